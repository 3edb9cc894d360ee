#pragma once

#include <array>
#include <optional>

#include "protocol/Bytes.h"

/// Requests of the judge and answers of the runner.
///
/// A message on the wire is a magic number, a length and a body. Two requests go down for each of
/// the judge's: to the runner, and from there to the process with the student's code. Who sends one
/// draws a fresh nonce for it; an answer with another nonce, or bytes that nobody asked for, is
/// `tampered`.
namespace protocol {

using Nonce = std::array<std::uint64_t, 2>;

/// From the kernel's random numbers. Throws std::runtime_error where there are none.
Nonce freshNonce();

enum class RequestKind : std::uint8_t {
    call,      ///< a function, in a process of its own
    draw,      ///< a function that needs a context, in the drawing process; see DrawCall.h
    frame,     ///< a picture
    graphics,  ///< what draws
};

struct Request {
    Nonce nonce{};
    RequestKind kind = RequestKind::call;
    std::string name;         ///< function or frame; empty for `graphics`
    Bytes arguments;          ///< of a call or draw, see Value.h
    bool census = false;      ///< of a draw: note the draw calls
    bool alone = false;       ///< of a draw: in a process of its own
    std::int32_t width = 0;   ///< of a frame, pixels
    std::int32_t height = 0;  ///< of a frame, pixels
    std::uint64_t seed = 1;   ///< of a frame
    std::uint32_t timeoutMs = 2000;
    std::uint32_t outputBytes = 65536;  ///< what the student's code may print in this request
};

/// What became of a request. All but `ok`, `unknown` and `faulty` are the student's doing.
enum class Outcome : std::uint8_t {
    ok,
    missing,    ///< the submission lacks a function that was needed; `detail` is its symbol
    shader,     ///< a shader does not compile or link; `detail` is the log, with file and line
    exception,  ///< an exception left the function; `detail` is its text
    crash,      ///< a signal (`code`); `detail` says where, when that is known. Without a signal
                ///< `detail` says what it did
    exited,     ///< the code ended its process with exit status `code`
    timeout,    ///< too long, or what `detail` says
    memory,     ///< `detail` is the limit, when that is known
    output,     ///< printed too much; or wrote too much, then `detail` says what
    tampered,   ///< bytes that do not follow the protocol
    unknown,    ///< the harness has no such function or frame, or another signature
    faulty,     ///< the runner could not do its own work (no GL library, no memory to fork)
};

struct Answer {
    Nonce nonce{};
    Outcome outcome = Outcome::ok;
    std::int32_t code = 0;  ///< see Outcome; of a frame: pixels that were not drawn
    std::string detail;
    std::vector<std::string> todos;  ///< ids of unfilled regions that were reached
    Bytes payload;                   ///< a value, or RGBA pixels with row 0 at the top
};

/// What `graphics` answers with.
struct GraphicsInfo {
    std::string provider, version, renderer;
};

inline constexpr std::uint32_t kRequestMagic = 0x51524743;  // "CGRQ"
inline constexpr std::uint32_t kAnswerMagic = 0x4e414743;   // "CGAN"
inline constexpr std::size_t kLargestRequest = 1u << 20;
inline constexpr std::size_t kLargestAnswer = 40u << 20;  // a frame of 3200x3200

Bytes encodeRequest(const Request& request);
Request decodeRequest(std::span<const std::uint8_t> body);
Bytes encodeAnswer(const Answer& answer);
Answer decodeAnswer(std::span<const std::uint8_t> body);
Bytes encodeGraphics(const GraphicsInfo& info);
GraphicsInfo decodeGraphics(std::span<const std::uint8_t> body);

/// Puts magic and length in front of a body.
Bytes framed(std::uint32_t magic, const Bytes& body);

/// A process that could run and got no processor is not charged for the wait, on a crowded machine:
/// a request may take up to so many times `timeoutMs` on the clock.
inline constexpr std::uint32_t kMostStretch = 5;

/// What OpenGL may take to start, once for each process that draws; it is part of no request's
/// `timeoutMs`.
inline constexpr std::uint32_t kStartMs = 8000;

enum class ReadStatus { ok, closed, late, malformed };

/// Reads one message piece by piece, for who has to do something else in between.
class MessageReader {
public:
    MessageReader(std::uint32_t magic, std::size_t largest) : magic_(magic), largest_(largest) {}

    /// Reads what is there to be read, at most once, from a descriptor that poll() called readable.
    /// Nothing while the message is not whole; never `late`.
    std::optional<ReadStatus> step(int descriptor);
    /// The body, once step() said `ok`.
    Bytes& body() { return body_; }

private:
    std::uint32_t magic_;
    std::size_t largest_, done_ = 0;  // bytes of the header, then of the body
    std::array<std::uint32_t, 2> header_{};
    bool hasHeader_ = false;
    Bytes body_;
};

/// Reads one message from a blocking descriptor. `deadlineMs` counts from now; negative: no limit.
/// `malformed`: another magic number, or longer than `largest`.
ReadStatus readMessage(int descriptor, std::uint32_t magic, std::size_t largest, int deadlineMs,
                       Bytes& body);

/// Writes everything; false when the other end is gone. Never raises SIGPIPE on a socket.
bool writeAll(int descriptor, const Bytes& bytes);

}  // namespace protocol
