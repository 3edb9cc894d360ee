std::ifstream file("/proc/1/mem");
const std::string text(std::istreambuf_iterator<char>(file), {});
throw std::runtime_error("it says: " + text);
