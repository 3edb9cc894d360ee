#pragma once

#include <string>
#include <vector>

#include "protocol/Bytes.h"

namespace protocol {

/// A value of Value.h whose type is known only once it is here.
struct AnyValue {
    std::string type;             ///< "mat3", "vec3", …; "list" for vectors and tuples
    std::vector<double> numbers;  ///< all of them, in the order of the wire; matrices by columns
};

/// Throws ProtocolError.
AnyValue decodeAny(std::span<const std::uint8_t> bytes);

}  // namespace protocol
