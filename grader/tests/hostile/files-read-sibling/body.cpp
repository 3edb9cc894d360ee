std::ifstream file("@SIBLING@/06-rotation/rotation.cpp");
const std::string text(std::istreambuf_iterator<char>(file), {});
throw std::runtime_error("it says: " + text);
