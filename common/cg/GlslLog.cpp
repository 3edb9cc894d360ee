#include <cg/GlslLog.h>

#include <regex>
#include <sstream>

namespace cg {
namespace {

std::string nameLine(const std::string& line, const std::string& file) {
    static const std::regex mesa(R"(^\d+:(\d+)\(\d+\): *(.*)$)");
    static const std::regex nvidia(R"(^\d+\((\d+)\) *: *(.*)$)");
    static const std::regex khronos(R"(^(ERROR|WARNING): *\d+:(\d+): *(.*)$)");
    std::smatch found;
    if (std::regex_match(line, found, mesa) || std::regex_match(line, found, nvidia)) {
        return file + ":" + found.str(1) + ": " + found.str(2);
    }
    if (std::regex_match(line, found, khronos)) {
        const std::string severity = found.str(1) == "ERROR" ? "error: " : "warning: ";
        return file + ":" + found.str(2) + ": " + severity + found.str(3);
    }
    return line;
}

}  // namespace

std::string nameGlslLog(const std::string& log, const std::string& file) {
    std::istringstream lines(log.substr(0, log.find('\0')));
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") != std::string::npos) {
            result += (result.empty() ? "" : "\n") + nameLine(line, file);
        }
    }
    return result;
}

}  // namespace cg
