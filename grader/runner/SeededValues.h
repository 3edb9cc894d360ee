#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>

/// Values that depend on nothing but a seed: the same on every machine and in every library.
class SeededValues {
public:
    explicit SeededValues(std::uint64_t seed) : engine_(seed) {}
    /// In [low, high).
    float uniform(float low, float high) {
        const double unit = static_cast<double>(engine_() >> 11) * 0x1.0p-53;
        return low + static_cast<float>(unit) * (high - low);
    }
    /// Evenly distributed over the unit sphere (Archimedes: z and the azimuth are uniform).
    glm::vec3 unitVector() {
        const float z = uniform(-1.0f, 1.0f);
        const float azimuth = uniform(0.0f, 6.28318531f);
        const float radius = std::sqrt(1.0f - z * z);
        return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
    }

private:
    std::mt19937_64 engine_;
};
