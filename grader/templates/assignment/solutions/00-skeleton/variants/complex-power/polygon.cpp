// The i-th power of the n-th root of unity, times the top, which is the imaginary unit.
#include <complex>

#include "polygon.h"

glm::vec2 corner(const int i, const int n) {
    const std::complex<double> root = std::polar(1.0, 2.0 * std::acos(-1.0) / n);
    std::complex<double> place(0.0, 1.0);
    for (int k = 0; k < i; ++k) {
        place *= root;
    }
    return {float(place.real()), float(place.imag())};
}
