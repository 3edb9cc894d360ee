#pragma once

#include <string>
#include <vector>

#include "protocol/Message.h"

namespace judge {

/// What a subject answered to one request, in a form that two subjects can be compared by.
struct Evidence {
    std::string key;              ///< of the request: the same function with the same arguments
    std::string outcome;          ///< "ok", "refused" (exception, exit), "died", or "absent"
    std::string type;             ///< "mat3", "vec3", "list", "set", "shares", …
    std::vector<double> numbers;  ///< empty unless the outcome is ok
};

/// The evidence of an answer. Draw calls are a "set": their order does not matter. A value of more
/// than `kMostNumbers` numbers leaves none, unless the test says what it sees of it (observed()).
Evidence evidenceOf(const protocol::Request& request, const protocol::Answer& answer);

inline constexpr std::size_t kMostNumbers = 1024;

/// Numbers that are the same for the same rows in whatever order, and change smoothly with each:
/// how many rows there are, the sum of each column, and sums that bind the columns together.
std::vector<double> orderless(const std::vector<std::vector<double>>& rows);

/// FNV-1a: the same on every machine, unlike std::hash.
std::uint64_t hashOf(const std::string& text, std::uint64_t start = 0xcbf29ce484222325u);

}  // namespace judge
