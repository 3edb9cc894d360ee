auto small = std::make_unique<char[]>(8);
std::memset(small.get(), 0x41, 1 << 16);
return glm::mat3(float(small[0]));
