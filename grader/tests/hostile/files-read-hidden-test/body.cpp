std::ifstream file("@ROOT@/solutions/06-rotation/hidden_tests/Rotation_hidden_test.cpp");
const std::string text(std::istreambuf_iterator<char>(file), {});
throw std::runtime_error("it says: " + text);
