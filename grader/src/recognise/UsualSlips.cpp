#include "recognise/UsualSlips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <numeric>

namespace grader {

namespace {

using Numbers = std::vector<double>;

/// Side of a matrix: 3 or 4; 0 for what is none.
std::size_t sideOf(const Evidence& evidence) {
    return evidence.type == "mat3" ? 3 : evidence.type == "mat4" ? 4 : 0;
}

bool isVector(const Evidence& evidence) {
    return evidence.type == "vec2" || evidence.type == "vec3" || evidence.type == "vec4";
}

bool isComparable(const AnswerPair& pair) {
    static const char* types[] = {"mat3", "mat4", "vec2", "vec3", "vec4", "int", "float", "list"};
    return pair.right.outcome == "ok" && pair.got.outcome == "ok" &&
           pair.right.type == pair.got.type &&
           std::find(std::begin(types), std::end(types), pair.right.type) != std::end(types) &&
           pair.right.numbers.size() == pair.got.numbers.size();
}

/// A slip as a map of the right numbers; nothing where it does not apply.
using Slip = std::function<std::optional<Numbers>(const Evidence& right)>;

bool explains(const Slip& slip, const std::vector<AnswerPair>& pairs) {
    for (const AnswerPair& pair : pairs) {
        std::optional<Numbers> numbers = slip(pair.right);
        if (!numbers)
            return false;
        Evidence slipped = pair.right;
        slipped.numbers = std::move(*numbers);
        if (!agree(slipped, pair.got))
            return false;
    }
    return true;
}

std::optional<Numbers> transposed(const Evidence& right) {
    const std::size_t n = sideOf(right);
    if (n == 0)
        return std::nullopt;
    Numbers numbers(n * n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            numbers[i * n + j] = right.numbers[j * n + i];
    return numbers;
}

std::optional<Numbers> inverted(const Evidence& right) {
    Numbers inverse(right.numbers.size());
    if (sideOf(right) == 3) {
        const glm::dmat3 m = glm::inverse(glm::make_mat3(right.numbers.data()));
        std::copy_n(glm::value_ptr(m), 9, inverse.begin());
    } else if (sideOf(right) == 4) {
        const glm::dmat4 m = glm::inverse(glm::make_mat4(right.numbers.data()));
        std::copy_n(glm::value_ptr(m), 16, inverse.begin());
    } else {
        return std::nullopt;
    }
    return inverse;
}

Slip scaledBy(double factor) {
    return [factor](const Evidence& right) -> std::optional<Numbers> {
        Numbers numbers = right.numbers;
        for (double& each : numbers)
            each *= factor;
        return numbers;
    };
}

Slip shiftedBy(double step) {
    return [step](const Evidence& right) -> std::optional<Numbers> {
        Numbers numbers = right.numbers;
        for (double& each : numbers) {
            if (each != std::round(each))
                return std::nullopt;
            each += step;
        }
        return numbers;
    };
}

/// A rotation by as many radians as it should be degrees, or the other way round.
Slip turnedBy(double factor) {
    return [factor](const Evidence& right) -> std::optional<Numbers> {
        if (right.type != "mat3")
            return std::nullopt;
        const glm::dmat3 R = glm::make_mat3(right.numbers.data());
        const glm::dvec3 twice(R[1][2] - R[2][1], R[2][0] - R[0][2], R[0][1] - R[1][0]);
        const double sine = 0.5 * glm::length(twice);
        if (sine < 1e-3)
            return std::nullopt;
        const double angle = std::atan2(sine, 0.5 * (R[0][0] + R[1][1] + R[2][2] - 1.0)) * factor;
        const glm::dvec3 a = twice / (2.0 * sine);
        const glm::dmat3 cross(0.0, a.z, -a.y, -a.z, 0.0, a.x, a.y, -a.x, 0.0);
        const glm::dmat3 turned = std::cos(angle) * glm::dmat3(1.0) +
                                  (1.0 - std::cos(angle)) * glm::outerProduct(a, a) +
                                  std::sin(angle) * cross;
        return Numbers(glm::value_ptr(turned), glm::value_ptr(turned) + 9);
    };
}

/// Rows (of a vector: components) in another order.
Slip reordered(const std::vector<std::size_t>& order) {
    return [order](const Evidence& right) -> std::optional<Numbers> {
        const std::size_t n = order.size();
        if (sideOf(right) != n && !(isVector(right) && right.numbers.size() == n))
            return std::nullopt;
        Numbers numbers = right.numbers;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = right.numbers[i / n * n + order[i % n]];
        return numbers;
    };
}

std::optional<std::string> swappedAxes(const std::vector<AnswerPair>& pairs) {
    const AnswerPair& first = pairs.front();
    const std::size_t n = sideOf(first.right) ? sideOf(first.right) : first.right.numbers.size();
    if (n < 2 || n > 4 || !(isVector(first.right) || sideOf(first.right)))
        return std::nullopt;
    static const char axes[] = "xyzw";
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    while (std::next_permutation(order.begin(), order.end())) {
        if (!explains(reordered(order), pairs))
            continue;
        std::string names;
        for (const std::size_t each : order)
            names += axes[each];
        return "Your numbers are the right ones with their axes mixed up: where x" +
               std::string(n > 2 ? ", y and z" : " and y") + " belong, you have " + names + ".";
    }
    return std::nullopt;
}

/// Every right vector has length 1, and what came points the same way.
bool isUnnormalised(const std::vector<AnswerPair>& pairs) {
    return std::all_of(pairs.begin(), pairs.end(), [](const AnswerPair& pair) {
        if (!isVector(pair.right))
            return false;
        const auto length = [](const Numbers& v) {
            return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
        };
        const double got = length(pair.got.numbers);
        if (std::abs(length(pair.right.numbers) - 1.0) > 1e-3 || got < 1e-6)
            return false;
        Evidence unit = pair.got;
        for (double& each : unit.numbers)
            each /= got;
        return agree(unit, pair.right);
    });
}

/// What came is no finite number where the right one is.
bool isBroken(const AnswerPair& pair) {
    for (std::size_t i = 0; i < pair.got.numbers.size(); ++i)
        if (std::isfinite(pair.right.numbers[i]) && !std::isfinite(pair.got.numbers[i]))
            return true;
    return false;
}

/// The factor between the largest right number and what came for it.
double factorOf(const AnswerPair& pair) {
    const auto largest =
        std::max_element(pair.right.numbers.begin(), pair.right.numbers.end(),
                         [](double a, double b) { return std::abs(a) < std::abs(b); });
    const auto at = static_cast<std::size_t>(largest - pair.right.numbers.begin());
    return *largest == 0.0 ? 0.0 : pair.got.numbers[at] / *largest;
}

}  // namespace

std::optional<std::string> usualSlip(const std::vector<AnswerPair>& all) {
    std::vector<AnswerPair> pairs;
    std::size_t wrong = 0, wrongNumbers = 0;
    for (const AnswerPair& pair : all) {
        if (!isComparable(pair))
            return std::nullopt;
        if (pair.right.numbers.empty())
            continue;  // an empty list, or an answer that the test sees nothing of
        pairs.push_back(pair);
        if (!agree(pair.right, pair.got)) {
            ++wrong;
            wrongNumbers += pair.right.numbers.size();
        }
    }
    if (std::any_of(pairs.begin(), pairs.end(), isBroken))
        return "Some of your numbers are none (nan or inf): a division by 0, or the root or power "
               "of a "
               "negative number, gives such.";
    // One vector can be met by chance, two or a matrix cannot.
    if (wrong == 0 || wrongNumbers < 4)
        return std::nullopt;
    constexpr double kDegree = std::numbers::pi / 180.0;
    const bool isTransposed = explains(transposed, pairs), isInverse = explains(inverted, pairs);
    if (isTransposed && isInverse)
        return "Your matrix is the inverse of the right one, which for a rotation is its "
               "transpose: "
               "either rows and columns are exchanged, or it turns the other way.";
    if (isTransposed)
        return "Your matrix is the transpose of the right one: rows and columns are exchanged "
               "(GLM stores columns).";
    if (isInverse)
        return "Your matrix is the inverse of the right one: it maps the other way.";
    if (explains(scaledBy(-1.0), pairs))
        return "Your numbers are the right ones with the opposite sign.";
    if (explains(turnedBy(1.0 / kDegree), pairs))
        return "You turn by as many radians as it should be degrees.";
    if (explains(turnedBy(kDegree), pairs))
        return "You turn by as many degrees as it should be radians.";
    if (isUnnormalised(pairs))
        return "The direction is right, the length is not: normalise it.";
    if (explains(shiftedBy(1.0), pairs))
        return "Every number is one too large.";
    if (explains(shiftedBy(-1.0), pairs))
        return "Every number is one too small.";
    if (auto mixed = swappedAxes(pairs))
        return mixed;
    const double factor = factorOf(pairs.front());
    if (factor != 0.0 && explains(scaledBy(factor), pairs))
        return fmt::format("Your numbers are {:.3g} times the right ones.", factor);
    return std::nullopt;
}

}  // namespace grader
