std::ifstream file("/etc/passwd");
const std::string text(std::istreambuf_iterator<char>(file), {});
throw std::runtime_error("it says: " + text);
