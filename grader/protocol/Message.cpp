#include "protocol/Message.h"

#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <utility>

namespace protocol {

namespace {

constexpr std::size_t kMostTodos = 256;
constexpr std::size_t kLongestText = 16384, kLongestName = 200;  // bytes

void writeNonce(ByteWriter& out, const Nonce& nonce) {
    out.number(nonce[0]);
    out.number(nonce[1]);
}

Nonce readNonce(ByteReader& in) {
    const auto first = in.number<std::uint64_t>();
    return {first, in.number<std::uint64_t>()};
}

template <class Enum>
Enum readEnum(ByteReader& in, Enum last) {
    const auto value = in.number<std::uint8_t>();
    if (value > static_cast<std::uint8_t>(last))
        throw ProtocolError("unknown kind " + std::to_string(value));
    return static_cast<Enum>(value);
}

using Clock = std::chrono::steady_clock;

/// Milliseconds for poll(); -1 waits for ever.
int msLeft(Clock::time_point start, int deadlineMs) {
    if (deadlineMs < 0)
        return -1;
    const auto passed =
        std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start).count();
    return passed >= deadlineMs ? 0 : deadlineMs - static_cast<int>(passed);
}

}  // namespace

Nonce freshNonce() {
    Nonce nonce;
    if (getrandom(nonce.data(), sizeof nonce, 0) != sizeof nonce)
        throw std::runtime_error("no random numbers to be had");
    return nonce;
}

Bytes encodeRequest(const Request& request) {
    ByteWriter out;
    writeNonce(out, request.nonce);
    out.number(static_cast<std::uint8_t>(request.kind));
    out.text(request.name);
    out.blob(request.arguments);
    out.number(static_cast<std::uint8_t>(request.census));
    out.number(static_cast<std::uint8_t>(request.alone));
    out.number(request.width);
    out.number(request.height);
    out.number(request.seed);
    out.number(request.timeoutMs);
    out.number(request.outputBytes);
    return out.take();
}

Request decodeRequest(std::span<const std::uint8_t> body) {
    ByteReader in(body);
    Request request;
    request.nonce = readNonce(in);
    request.kind = readEnum(in, RequestKind::graphics);
    request.name = in.text();
    request.arguments = in.blob();
    request.census = in.number<std::uint8_t>() != 0;
    request.alone = in.number<std::uint8_t>() != 0;
    request.width = in.number<std::int32_t>();
    request.height = in.number<std::int32_t>();
    request.seed = in.number<std::uint64_t>();
    request.timeoutMs = in.number<std::uint32_t>();
    request.outputBytes = in.number<std::uint32_t>();
    in.end();
    return request;
}

Bytes encodeAnswer(const Answer& answer) {
    ByteWriter out;
    writeNonce(out, answer.nonce);
    out.number(static_cast<std::uint8_t>(answer.outcome));
    out.number(answer.code);
    out.text(answer.detail.substr(0, kLongestText));
    out.number(static_cast<std::uint32_t>(answer.todos.size()));
    for (const std::string& id : answer.todos)
        out.text(id);
    out.blob(answer.payload);
    return out.take();
}

Answer decodeAnswer(std::span<const std::uint8_t> body) {
    ByteReader in(body);
    Answer answer;
    answer.nonce = readNonce(in);
    answer.outcome = readEnum(in, Outcome::faulty);
    answer.code = in.number<std::int32_t>();
    answer.detail = in.text(kLongestText);
    const auto count = in.number<std::uint32_t>();
    if (count > kMostTodos)
        throw ProtocolError("too many unfilled regions");
    for (std::uint32_t i = 0; i < count; ++i)
        answer.todos.push_back(in.text(kLongestName));
    answer.payload = in.blob();
    in.end();
    return answer;
}

Bytes encodeGraphics(const GraphicsInfo& info) {
    ByteWriter out;
    out.text(info.provider);
    out.text(info.version);
    out.text(info.renderer);
    return out.take();
}

GraphicsInfo decodeGraphics(std::span<const std::uint8_t> body) {
    ByteReader in(body);
    GraphicsInfo info;
    info.provider = in.text(kLongestName);
    info.version = in.text(kLongestName);
    info.renderer = in.text(kLongestName);
    in.end();
    return info;
}

Bytes framed(std::uint32_t magic, const Bytes& body) {
    ByteWriter out;
    out.number(magic);
    out.number(static_cast<std::uint32_t>(body.size()));
    out.raw(body.data(), body.size());
    return out.take();
}

std::optional<ReadStatus> MessageReader::step(int descriptor) {
    std::uint8_t* data =
        hasHeader_ ? body_.data() : reinterpret_cast<std::uint8_t*>(header_.data());
    const std::size_t size = hasHeader_ ? body_.size() : sizeof header_;
    const ssize_t got = read(descriptor, data + done_, size - done_);
    if (got < 0 && (errno == EINTR || errno == EAGAIN))
        return std::nullopt;
    if (got <= 0)
        return ReadStatus::closed;
    done_ += static_cast<std::size_t>(got);
    if (done_ < size)
        return std::nullopt;
    if (hasHeader_)
        return ReadStatus::ok;
    if (header_[0] != magic_ || header_[1] > largest_)
        return ReadStatus::malformed;
    hasHeader_ = true;
    done_ = 0;
    body_.resize(header_[1]);
    return body_.empty() ? std::optional(ReadStatus::ok) : std::nullopt;
}

ReadStatus readMessage(int descriptor, std::uint32_t magic, std::size_t largest, int deadlineMs,
                       Bytes& body) {
    const auto start = Clock::now();
    MessageReader reader(magic, largest);
    for (;;) {
        pollfd waiting{descriptor, POLLIN, 0};
        const int ready = poll(&waiting, 1, msLeft(start, deadlineMs));
        if (ready < 0 && errno == EINTR)
            continue;
        if (ready == 0)
            return ReadStatus::late;
        if (const auto status = reader.step(descriptor)) {
            body = std::move(reader.body());
            return *status;
        }
    }
}

bool writeAll(int descriptor, const Bytes& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
        ssize_t sent = send(descriptor, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
        if (sent < 0 && errno == ENOTSOCK)
            sent = write(descriptor, bytes.data() + done, bytes.size() - done);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0)
            return false;
        done += static_cast<std::size_t>(sent);
    }
    return true;
}

}  // namespace protocol
