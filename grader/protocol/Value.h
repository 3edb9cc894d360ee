#pragma once

#include <glm/glm.hpp>
#include <tuple>

#include "protocol/Bytes.h"

/// Typed values as bytes: what a test passes to a student's function and what comes back.
///
/// Known types are bool, int, float, glm::vec2/3/4, glm::mat3/4, std::vector of one of these and
/// std::tuple of any of these. Every value is preceded by a tag, so that a harness and a test that
/// disagree about a signature are told apart from a wrong number: decoding throws ProtocolError
/// "expected mat3, found vec3". Matrices are column-major, as in GLM.
namespace protocol {

template <class T>
struct TypeTag;  // undefined: this type cannot cross the wall

#define PROTOCOL_TYPE(TYPE, TAG, NAME)             \
    template <>                                    \
    struct TypeTag<TYPE> {                         \
        static constexpr std::uint8_t value = TAG; \
        static constexpr const char* name = NAME;  \
    };
PROTOCOL_TYPE(bool, 1, "bool")
PROTOCOL_TYPE(int, 2, "int")
PROTOCOL_TYPE(float, 3, "float")
PROTOCOL_TYPE(glm::vec2, 4, "vec2")
PROTOCOL_TYPE(glm::vec3, 5, "vec3")
PROTOCOL_TYPE(glm::vec4, 6, "vec4")
PROTOCOL_TYPE(glm::mat3, 7, "mat3")
PROTOCOL_TYPE(glm::mat4, 8, "mat4")
#undef PROTOCOL_TYPE

inline constexpr std::uint8_t kVectorTag = 0x20;  // plus the element's tag
inline constexpr std::uint8_t kTupleTag = 0x40;   // then the number of members

template <class T>
struct Codec {
    static void write(ByteWriter& out, const T& value) {
        out.number(TypeTag<T>::value);
        if constexpr (std::is_same_v<T, bool>)
            out.number(static_cast<std::uint8_t>(value));
        else
            out.raw(&value, sizeof value);
    }
    static T read(ByteReader& in) {
        if (const auto tag = in.number<std::uint8_t>(); tag != TypeTag<T>::value)
            throw ProtocolError(std::string("expected ") + TypeTag<T>::name + ", found type " +
                                std::to_string(tag));
        if constexpr (std::is_same_v<T, bool>) {
            return in.number<std::uint8_t>() != 0;
        } else {
            T value;
            in.raw(&value, sizeof value);
            return value;
        }
    }
};

template <class T>
struct Codec<std::vector<T>> {
    static void write(ByteWriter& out, const std::vector<T>& values) {
        out.number(static_cast<std::uint8_t>(kVectorTag + TypeTag<T>::value));
        out.number(static_cast<std::uint32_t>(values.size()));
        for (const T& value : values)
            Codec<T>::write(out, value);
    }
    static std::vector<T> read(ByteReader& in) {
        if (in.number<std::uint8_t>() != kVectorTag + TypeTag<T>::value)
            throw ProtocolError(std::string("expected a vector of ") + TypeTag<T>::name);
        const auto count = in.number<std::uint32_t>();
        if (count > in.left() / (1 + sizeof(T)))  // every element takes its tag and itself
            throw ProtocolError("a vector longer than its message");
        std::vector<T> values;
        values.reserve(count);
        for (std::uint32_t i = 0; i < count; ++i)
            values.push_back(Codec<T>::read(in));
        return values;
    }
};

template <class... Ts>
struct Codec<std::tuple<Ts...>> {
    static void write(ByteWriter& out, const std::tuple<Ts...>& values) {
        out.number(kTupleTag);
        out.number(static_cast<std::uint8_t>(sizeof...(Ts)));
        std::apply([&](const Ts&... each) { (Codec<Ts>::write(out, each), ...); }, values);
    }
    static std::tuple<Ts...> read(ByteReader& in) {
        if (in.number<std::uint8_t>() != kTupleTag || in.number<std::uint8_t>() != sizeof...(Ts))
            throw ProtocolError("expected a tuple of " + std::to_string(sizeof...(Ts)));
        return std::tuple<Ts...>{Codec<Ts>::read(in)...};  // braces fix the order of evaluation
    }
};

/// All arguments of a call, one after the other.
template <class... Ts>
Bytes encode(const Ts&... values) {
    ByteWriter out;
    (Codec<Ts>::write(out, values), ...);
    return out.take();
}

/// The one value that `bytes` hold; throws ProtocolError when they hold anything else.
template <class T>
T decode(std::span<const std::uint8_t> bytes) {
    ByteReader in(bytes);
    T value = Codec<T>::read(in);
    in.end();
    return value;
}

}  // namespace protocol
