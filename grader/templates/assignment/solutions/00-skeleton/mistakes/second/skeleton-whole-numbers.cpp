    const int share = i / n;
    const double turn = 8.0 * std::atan(1.0);
    return {float(-std::sin(share * turn)), float(std::cos(share * turn))};
