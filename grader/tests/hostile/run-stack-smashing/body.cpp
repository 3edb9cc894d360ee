char small[8];
std::memset(small, 0x41, 4096);
return glm::mat3(float(small[0]));
