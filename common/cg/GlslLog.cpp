#include <cg/GlslLog.h>
#include <cg/GlslSource.h>

#include <regex>
#include <sstream>

namespace cg {
namespace {

std::string nameLine(const std::string& line, const std::string& file) {
    // The place alone: a pattern that also matches a long message overflows the stack.
    static const std::regex mesa(R"(\d+:(\d+)\(\d+\): *)");
    static const std::regex nvidia(R"(\d+\((\d+)\) *: *)");
    static const std::regex khronos(R"((ERROR|WARNING): *\d+:(\d+): *)");
    std::smatch found;
    const auto begins = [&](const std::regex& place) {
        return std::regex_search(line, found, place, std::regex_constants::match_continuous);
    };
    if (begins(mesa) || begins(nvidia)) {
        return file + ":" + found.str(1) + ": " + found.suffix().str();
    }
    if (begins(khronos)) {
        const std::string severity = found.str(1) == "ERROR" ? "error: " : "warning: ";
        return file + ":" + found.str(2) + ": " + severity + found.suffix().str();
    }
    return line;
}

/// Number of the first line that the log complains about; 0 when it names none.
std::size_t firstLine(const std::string& log) {
    static const std::regex place(R"((?:^|\n)(?:ERROR: *)?\d+[:(](\d+))");
    std::smatch found;
    return std::regex_search(log, found, place) ? std::stoul(found.str(1)) : 0;
}

std::string lineOf(const std::string& source, std::size_t number) {
    std::istringstream lines(source);
    std::string line;
    for (std::size_t i = 0; i < number && std::getline(lines, line); ++i) {
    }
    return line;
}

bool holds(const std::string& text, const char* pattern) {
    return std::regex_search(text, std::regex(pattern));
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

std::string glslHint(const std::string& log, const std::string& source) {
    const std::string line = lineOf(source, firstLine(log));
    if (holds(line, R"((^|[^\w.])\d{1,20}f\b)")) {
        return "a float has a decimal point: write 0.0 or 0.0f, not 0f";
    }
    if (holds(line, R"(\bunsigned\s+int\b)")) {
        return "GLSL calls this type uint";
    }
    if (holds(log, R"((cannot|can't|could not) (be )?(assign|convert|implicitly)|type float)") &&
        holds(line, R"(\b(int|uint|ivec[234])\b)")) {
        return "GLSL turns no float into an int by itself: write int(x)";
    }
    if (!beginsWithVersion(source)) {
        return "#version 330 core must be the first line; only comments and space may stand before";
    }
    return "";
}

}  // namespace cg
