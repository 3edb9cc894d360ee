#pragma once

#include <algorithm>
#include <vector>

/// The middle value: of noisy measurements, the one to trust.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}
