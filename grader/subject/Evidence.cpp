#include "subject/Evidence.h"

#include <fmt/format.h>

#include <cmath>

#include "protocol/AnyValue.h"
#include "protocol/DrawCall.h"

namespace judge {

namespace {

constexpr int kBindingSums = 6;

std::string keyOf(const protocol::Request& request) {
    std::string text =
        fmt::format("{} {} {} ", static_cast<int>(request.kind), request.census, request.name);
    text.append(request.arguments.begin(), request.arguments.end());
    return fmt::format("{:016x}", hashOf(text));
}

/// How an answer ended, as far as mistakes are told apart by it: an endless loop may meet its end
/// by time, memory or output, whichever is first.
std::string kindOf(protocol::Outcome outcome) {
    using protocol::Outcome;
    switch (outcome) {
        case Outcome::ok:
            return "ok";
        case Outcome::exception:
        case Outcome::exited:
            return "refused";
        case Outcome::crash:
        case Outcome::timeout:
        case Outcome::memory:
        case Outcome::output:
            return "died";
        default:
            return "absent";
    }
}

std::vector<double> rowOf(const protocol::DrawCall& call) {
    std::vector<double> row{static_cast<double>(call.count)};
    const float* matrix = &call.modelview[0].x;
    row.insert(row.end(), matrix, matrix + 16);
    for (const glm::vec4* colour : {&call.ambient, &call.diffuse, &call.specular, &call.emision})
        row.insert(row.end(), {colour->x, colour->y, colour->z});
    row.push_back(call.shininess);
    return row;
}

}  // namespace

std::uint64_t hashOf(const std::string& text, std::uint64_t start) {
    std::uint64_t hash = start;
    for (const unsigned char each : text)
        hash = (hash ^ each) * 0x100000001b3u;
    return hash;
}

std::vector<double> orderless(const std::vector<std::vector<double>>& rows) {
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    std::vector<double> sums(1 + columns + kBindingSums, 0.0);
    sums[0] = static_cast<double>(rows.size());
    for (const std::vector<double>& row : rows) {
        for (std::size_t i = 0; i < columns; ++i)
            sums[1 + i] += row[i];
        for (std::size_t k = 0; k < kBindingSums; ++k) {
            // A wave over all columns, each with a weight of its own that no other shares.
            double phase = static_cast<double>(k);
            for (std::size_t i = 0; i < columns; ++i)
                phase +=
                    std::sin(1.0 + 7.3 * static_cast<double>(i) + 2.9 * static_cast<double>(k)) *
                    row[i];
            sums[1 + columns + k] += std::cos(phase);
        }
    }
    return sums;
}

Evidence evidenceOf(const protocol::Request& request, const protocol::Answer& answer) {
    Evidence evidence{keyOf(request), kindOf(answer.outcome), "", {}};
    if (answer.outcome != protocol::Outcome::ok)
        return evidence;
    try {
        if (request.census) {
            std::vector<std::vector<double>> rows;
            for (const auto& call : protocol::decodeDrawAnswer(answer.payload).calls)
                rows.push_back(rowOf(call));
            evidence.type = "set";
            evidence.numbers = orderless(rows);
        } else {
            protocol::AnyValue value =
                request.kind == protocol::RequestKind::draw
                    ? protocol::decodeAny(protocol::decodeDrawAnswer(answer.payload).value)
                    : protocol::decodeAny(answer.payload);
            evidence.type = value.type;
            evidence.numbers = std::move(value.numbers);
        }
    } catch (const protocol::ProtocolError&) {
        evidence.outcome = "absent";  // the test itself will say what was wrong with it
    }
    if (evidence.numbers.size() > kMostNumbers) {
        evidence.type = "large";
        evidence.numbers.clear();
    }
    return evidence;
}

}  // namespace judge
