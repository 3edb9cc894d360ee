#include "protocol/AnyValue.h"

#include "protocol/Value.h"

namespace protocol {

namespace {

/// Reads one value of type T when `tag` is its tag.
template <class T>
bool readIf(std::uint8_t tag, ByteReader& in, AnyValue& value) {
    if (tag != TypeTag<T>::value)
        return false;
    value.type = TypeTag<T>::name;
    if constexpr (std::is_same_v<T, bool>) {
        value.numbers.push_back(in.number<std::uint8_t>());
    } else if constexpr (std::is_arithmetic_v<T>) {
        value.numbers.push_back(in.number<T>());
    } else {
        float numbers[sizeof(T) / sizeof(float)];
        in.raw(numbers, sizeof numbers);
        value.numbers.insert(value.numbers.end(), std::begin(numbers), std::end(numbers));
    }
    return true;
}

template <class... Ts>
bool readAny(std::uint8_t tag, ByteReader& in, AnyValue& value) {
    return (readIf<Ts>(tag, in, value) || ...);
}

/// A tuple of vectors of values, see Value.h.
constexpr int kDeepest = 2;

void read(ByteReader& in, AnyValue& value, int depth) {
    const auto tag = in.number<std::uint8_t>();
    if (tag != kTupleTag && (tag & kVectorTag) == 0) {
        if (!readAny<bool, int, float, glm::vec2, glm::vec3, glm::vec4, glm::mat3, glm::mat4>(
                tag, in, value))
            throw ProtocolError("a value of the unknown type " + std::to_string(tag));
        return;
    }
    if (depth == kDeepest)
        throw ProtocolError("lists too deep within each other");
    const std::size_t count =
        tag == kTupleTag ? in.number<std::uint8_t>() : in.number<std::uint32_t>();
    if (count > in.left())  // every element takes at least its tag
        throw ProtocolError("a list longer than its message");
    for (std::size_t i = 0; i < count; ++i)
        read(in, value, depth + 1);
    value.type = "list";
}

}  // namespace

AnyValue decodeAny(std::span<const std::uint8_t> bytes) {
    ByteReader in(bytes);
    AnyValue value;
    read(in, value, 0);
    in.end();
    return value;
}

}  // namespace protocol
