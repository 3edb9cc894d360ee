#include "subject/Judge.h"

namespace judge {

namespace {

constexpr float kRoundingNoise = 1e-6f;

/// Four significant digits; what is only rounding noise, and "-0", is 0.
std::string number(float value) {
    return fmt::format("{:.4g}", std::abs(value) < kRoundingNoise ? 0.0f : value);
}

template <class V>
std::string joined(const V& value, const char* separator) {
    std::string text;
    for (glm::length_t i = 0; i < value.length(); ++i)
        text += (i ? separator : "") + number(value[i]);
    return text;
}

template <class M>
std::string rows(const M& matrix) {
    const M transposed = glm::transpose(matrix);  // GLM stores columns
    std::string text;
    for (glm::length_t row = 0; row < transposed.length(); ++row)
        text += (row ? "; " : "") + joined(transposed[row], " ");
    return "[" + text + "]";
}

}  // namespace

std::string show(bool value) {
    return value ? "true" : "false";
}
std::string show(int value) {
    return std::to_string(value);
}
std::string show(float value) {
    return number(value);
}
std::string show(const glm::vec2& value) {
    return "(" + joined(value, ", ") + ")";
}
std::string show(const glm::vec3& value) {
    return "(" + joined(value, ", ") + ")";
}
std::string show(const glm::vec4& value) {
    return "(" + joined(value, ", ") + ")";
}
std::string show(const glm::mat3& value) {
    return rows(value);
}
std::string show(const glm::mat4& value) {
    return rows(value);
}

bool expectThat(const std::string& what, bool condition, const std::string& found) {
    if (!condition)
        fail(what + ": " + found);
    return condition;
}

}  // namespace judge
