#include "recognise/Signatures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "Error.h"
#include "Fields.h"

namespace grader {

namespace {

constexpr int kFormat = 3;
constexpr double kTolerance = 1e-3;
constexpr double kShare = 0.01;
constexpr double kSameThumbnail = 1.0;  // mean difference of a channel, of 255

bool isNear(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b))
        return !std::isfinite(a) && !std::isfinite(b);
    return std::abs(a - b) <= kTolerance * std::max(1.0, std::max(std::abs(a), std::abs(b)));
}

// The file: numbers as 32-bit floats, shares as bits behind their count.

Json packed(const Evidence& evidence) {
    Json json = Json::array({evidence.key, evidence.outcome, evidence.type});
    std::vector<std::uint8_t> bytes;
    if (evidence.type == "shares") {
        bytes.resize((evidence.numbers.size() + 7) / 8);
        for (std::size_t i = 0; i < evidence.numbers.size(); ++i)
            if (evidence.numbers[i] != 0)
                bytes[i / 8] |= static_cast<std::uint8_t>(1u << i % 8);
        json.push_back(evidence.numbers.size());
    } else {
        for (const double each : evidence.numbers) {
            const auto number = static_cast<float>(each);
            const auto* first = reinterpret_cast<const std::uint8_t*>(&number);
            bytes.insert(bytes.end(), first, first + sizeof number);
        }
    }
    json.push_back(Json::binary(bytes));
    return json;
}

Evidence unpacked(const Json& json) {
    Evidence evidence{json.at(0), json.at(1), json.at(2), {}};
    const std::vector<std::uint8_t>& bytes = json.back().get_binary();
    if (evidence.type == "shares") {
        const std::size_t count = json.at(3);
        if (bytes.size() != (count + 7) / 8)
            throw Error("{} shares in {} bytes", count, bytes.size());
        for (std::size_t i = 0; i < count; ++i)
            evidence.numbers.push_back(bytes[i / 8] >> i % 8 & 1);
        return evidence;
    }
    for (std::size_t i = 0; i + sizeof(float) <= bytes.size(); i += sizeof(float)) {
        float number;
        std::memcpy(&number, bytes.data() + i, sizeof number);
        evidence.numbers.push_back(number);
    }
    return evidence;
}

Json packed(const Answers& answers) {
    Json list = Json::array();
    for (const auto& [key, evidence] : answers)
        list.push_back(packed(evidence));
    return list;
}

Answers unpackedAnswers(const Json& list) {
    Answers answers;
    for (const Json& each : list) {
        Evidence evidence = unpacked(each);
        answers[evidence.key] = std::move(evidence);
    }
    return answers;
}

Json packed(const Signature& signature) {
    Json frames = Json::object();
    for (const auto& [id, thumbnail] : signature.frames)
        frames[id] = Json::array({thumbnail.width, thumbnail.height, Json::binary(thumbnail.rgb)});
    return {{"mistake", signature.mistake},
            {"region", signature.region},
            {"says", signature.says},
            {"common", signature.common},
            {"section", signature.section},
            {"loses", signature.loses},
            {"answers", packed(signature.answers)},
            {"frames", frames}};
}

Signature unpackedSignature(const Json& json) {
    Signature signature{json.at("mistake"),
                        json.at("region"),
                        json.at("says"),
                        json.at("common"),
                        json.at("section"),
                        json.at("loses"),
                        unpackedAnswers(json.at("answers")),
                        {}};
    for (const auto& [id, thumbnail] : json.at("frames").items())
        signature.frames[id] = {thumbnail.at(0), thumbnail.at(1), thumbnail.at(2).get_binary()};
    return signature;
}

bool sameAnswers(const Answers& a, const Answers& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.first == y.first && agree(x.second, y.second);
    });
}

bool sameSignature(const Signature& a, const Signature& b) {
    return a.mistake == b.mistake && a.region == b.region && a.says == b.says &&
           a.common == b.common && a.section == b.section && a.loses == b.loses &&
           sameAnswers(a.answers, b.answers) &&
           std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), b.frames.end(),
                      [](const auto& x, const auto& y) {
                          return x.first == y.first &&
                                 distance(x.second, y.second) <= kSameThumbnail;
                      });
}

}  // namespace

bool agree(const Evidence& a, const Evidence& b) {
    if (a.outcome != b.outcome || a.type != b.type || a.numbers.size() != b.numbers.size())
        return false;
    if (a.type == "shares") {
        double different = 0;
        for (std::size_t i = 0; i < a.numbers.size(); ++i)
            different += a.numbers[i] != b.numbers[i] ? 1 : 0;
        return different <= kShare * static_cast<double>(a.numbers.size());
    }
    return std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), isNear);
}

Answers answersOf(const std::vector<CheckResult>& checks) {
    Answers answers;
    for (const CheckResult& check : checks)
        for (const Evidence& evidence : check.evidence)
            if (!check.hidden)
                answers.emplace(evidence.key, evidence);
    return answers;
}

Signature signatureOf(const Mistake& mistake, const Answers& right,
                      const std::vector<CheckResult>& checks) {
    Signature signature{mistake.id,      mistake.region, mistake.says, mistake.common,
                        mistake.section, mistake.loses,  {},           {}};
    for (auto& [key, evidence] : answersOf(checks)) {
        const auto known = right.find(key);
        if (known == right.end() || !agree(evidence, known->second))
            signature.answers[key] = evidence;
    }
    for (const CheckResult& check : checks)
        if (check.pictures && !check.full())
            signature.frames[check.id] = thumbnailOf(check.pictures->submission);
    return signature;
}

std::vector<std::string> differing(const Signatures& a, const Signatures& b) {
    std::vector<std::string> ids;
    if (!sameAnswers(a.right, b.right))
        ids.push_back("the solution");
    std::map<std::string, const Signature*> inA;
    for (const Signature& each : a.mistakes)
        inA[each.mistake] = &each;
    for (const Signature& each : b.mistakes) {
        const auto known = inA.find(each.mistake);
        if (known == inA.end() || !sameSignature(*known->second, each))
            ids.push_back(each.mistake);
        inA.erase(each.mistake);
    }
    for (const auto& [id, signature] : inA)
        ids.push_back(id);
    return ids;
}

Signatures Signatures::load(const fs::path& file) {
    const std::string bytes = readFile(file);
    try {
        const Json json = Json::from_cbor(bytes);
        if (json.at("format") != kFormat)
            throw Error("expected format {}, found {}", kFormat, json.at("format").dump());
        Signatures signatures{unpackedAnswers(json.at("right")), {}};
        for (const Json& each : json.at("mistakes"))
            signatures.mistakes.push_back(unpackedSignature(each));
        return signatures;
    } catch (const std::exception& error) {
        throw Error("{}: not what this grader writes ({}): run ./grade update-references",
                    file.string(), error.what());
    }
}

void Signatures::save(const fs::path& file) const {
    Json json = {{"format", kFormat}, {"right", packed(right)}, {"mistakes", Json::array()}};
    for (const Signature& each : mistakes)
        json["mistakes"].push_back(packed(each));
    const auto bytes = Json::to_cbor(json);
    writeFile(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace grader
