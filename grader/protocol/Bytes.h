#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// Bytes that cross the wall between judge and runner.
///
/// Everything that a student's process sends is read through `ByteReader`, which checks every
/// length before it touches memory. Numbers travel in the machine's own byte order: both ends are
/// always on one machine.
namespace protocol {

using Bytes = std::vector<std::uint8_t>;

/// A message that does not follow the protocol: too short, too long, of another type.
struct ProtocolError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class ByteWriter {
public:
    template <class T>
    void number(T value) {
        static_assert(std::is_arithmetic_v<T>);
        raw(&value, sizeof value);
    }
    void raw(const void* data, std::size_t size) {
        const auto* first = static_cast<const std::uint8_t*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }
    /// A 32-bit length, then the bytes.
    void text(const std::string& value) {
        number(static_cast<std::uint32_t>(value.size()));
        raw(value.data(), value.size());
    }
    void blob(const Bytes& value) {
        number(static_cast<std::uint32_t>(value.size()));
        raw(value.data(), value.size());
    }
    Bytes take() { return std::move(bytes_); }

private:
    Bytes bytes_;
};

class ByteReader {
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    template <class T>
    T number() {
        static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
        T value;
        raw(&value, sizeof value);
        return value;
    }
    void raw(void* data, std::size_t size) {
        if (size == 0)
            return;
        const auto from = take(size);
        std::memcpy(data, from.data(), size);
    }
    /// Throws ProtocolError for a longer one.
    std::string text(std::size_t longest = std::numeric_limits<std::size_t>::max()) {
        const auto size = number<std::uint32_t>();
        if (size > longest)
            throw ProtocolError("a text is too long");
        const auto from = take(size);
        return {from.begin(), from.end()};
    }
    Bytes blob() {
        const auto from = take(number<std::uint32_t>());
        return {from.begin(), from.end()};
    }
    std::size_t left() const { return rest_.size(); }
    /// Throws ProtocolError when bytes are left over.
    void end() const {
        if (!rest_.empty())
            throw ProtocolError(std::to_string(rest_.size()) + " bytes too many");
    }

private:
    std::span<const std::uint8_t> take(std::size_t size) {
        if (size > rest_.size())
            throw ProtocolError("message ends " + std::to_string(size - rest_.size()) +
                                " bytes early");
        const auto taken = rest_.first(size);
        rest_ = rest_.subspan(size);
        return taken;
    }

    std::span<const std::uint8_t> rest_;
};

}  // namespace protocol
