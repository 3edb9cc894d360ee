#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <runner/SeededValues.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>

#include "subject/Subject.h"

/// What an assignment's tests are written with.
///
///     TEST(RotateUp, KeepsTheTarget) {
///         check("rotateUp leaves the target where it is");
///         const auto pose = subject().call<Pose>("turn", eye, target, up, steps);
///         expectClose(say("target after rotateUp({})", 25.0f), pose.target, target);
///     }
///
/// A test is a check of the task whose id is the suite's name (RotateUp: rotate-up). Its points
/// are earned whole or not at all. Tests run in the judge; the student's code is elsewhere.
namespace judge {

/// One sentence that a student can read, said first in every test. The hint replaces the task's.
void check(const std::string& title, const std::string& hint = "");

Subject& subject();

/// Values that depend on the seed of the run and the name of the test alone.
class Random : public SeededValues {
public:
    using SeededValues::SeededValues;
    float angle() { return uniform(20.0f, 160.0f); }  ///< degrees, away from 0 and 180
};
Random& random();

/// A value as students write it: (1, 2, 3); matrices by rows, [1 0 0; 0 1 0; 0 0 1].
std::string show(bool value);
std::string show(int value);
std::string show(float value);
std::string show(const glm::vec2& value);
std::string show(const glm::vec3& value);
std::string show(const glm::vec4& value);
std::string show(const glm::mat3& value);
std::string show(const glm::mat4& value);
inline std::string show(const char* value) {
    return value;
}
inline std::string show(const std::string& value) {
    return value;
}

/// fmt::format with the values shown as above.
template <class... A>
std::string say(const std::string& format, const A&... values) {
    return fmt::format(fmt::runtime(format), show(values)...);
}

/// Adds a sentence to the current check's failure.
void fail(const std::string& sentence);

/// Fails and leaves the test: there is nothing more to compare.
[[noreturn]] void failAndLeave(const std::string& sentence);

/// Leaves the test unless as many values came as were asked for. The harness answers with all of
/// them; what answers in its place may not.
void needCount(const std::string& what, std::size_t got, std::size_t asked);

/// Says what the current check sees of the last answer, when that is less than all of it: by this,
/// not by the answer, a known mistake is recognised. Colours of the student's own choice, the order
/// of parts or an alpha that nobody asked for stay out of it. `type`: "list"; "shares" (mostly 0
/// and 1, of which a few may differ); for what has no order there is orderless(), Evidence.h.
void observed(const std::string& type, std::vector<double> numbers);

/// Numbers agree when the largest difference is at most tolerance * max(1, |expected|); a number
/// that is not finite never agrees. Failing says "what: expected …, got …". Returns success.
template <class T>
bool expectClose(const std::string& what, const T& got, const T& expected, float tolerance = 1e-4f);

/// `found` says what was seen when the condition does not hold. Returns the condition.
bool expectThat(const std::string& what, bool condition, const std::string& found);

// ---------------------------------------------------------------------------------------------

namespace detail {
/// Keeps the first vector or matrix that was wrong, for the report to show.
void compared(const std::string& what, std::vector<std::vector<double>> expected,
              std::vector<std::vector<double>> got, double tolerance);

/// By rows; a vector is one column, a number has none.
template <class T>
std::vector<std::vector<double>> rowsOf(const T& value) {
    std::vector<std::vector<double>> rows;
    if constexpr (requires { value[0][0]; }) {
        for (glm::length_t i = 0; i < value[0].length(); ++i) {
            rows.emplace_back();
            for (glm::length_t j = 0; j < value.length(); ++j)
                rows.back().push_back(static_cast<double>(value[j][i]));
        }
    } else if constexpr (requires { value[0]; }) {
        for (glm::length_t i = 0; i < value.length(); ++i)
            rows.push_back({static_cast<double>(value[i])});
    }
    return rows;
}

template <class T>
float largest(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
        return std::abs(static_cast<float>(value));
    } else {
        float most = 0.0f;
        for (glm::length_t i = 0; i < value.length(); ++i) {
            const float each = largest(value[i]);
            most = std::isnan(each) ? each : std::max(most, each);
            if (std::isnan(most))
                break;
        }
        return most;
    }
}
}  // namespace detail

template <class T>
bool expectClose(const std::string& what, const T& got, const T& expected, float tolerance) {
    const float difference = detail::largest(T(got - expected));
    const float allowed = tolerance * std::max(1.0f, detail::largest(expected));
    if (difference <= allowed)  // false for NaN
        return true;
    fail(what + ": expected " + show(expected) + ", got " + show(got));
    detail::compared(what, detail::rowsOf(expected), detail::rowsOf(got), double(allowed));
    return false;
}

}  // namespace judge
