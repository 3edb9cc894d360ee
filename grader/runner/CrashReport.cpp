#include "runner/CrashReport.h"

#include <cxxabi.h>
#include <execinfo.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <regex>
#include <sstream>

#include "runner/Census.h"

namespace runner {

namespace {

int reportDescriptor = -1;
std::uintptr_t objectBase = 0;
std::uintptr_t objectEnd = 0;

constexpr int kMostFrames = kLongestReport - 1;
constexpr std::size_t kSignalStackBytes = 256 * 1024;

void onFatalSignal(int signal) {
    static void* addresses[kMostFrames];
    static std::uint64_t report[kLongestReport];
    const int count = backtrace(addresses, kMostFrames);
    std::size_t kept = 0;
    report[kept++] = static_cast<std::uint64_t>(driverWork());
    for (int i = 0; i < count; ++i) {
        const auto address = reinterpret_cast<std::uintptr_t>(addresses[i]);
        if (address >= objectBase && address < objectEnd)
            report[kept++] = address - objectBase;
    }
    [[maybe_unused]] const auto written = write(reportDescriptor, report, kept * sizeof report[0]);
    ::signal(signal, SIG_DFL);
    raise(signal);
}

std::string outputOf(const std::string& command) {
    std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string text;
    std::array<char, 4096> buffer;
    while (pipe && fgets(buffer.data(), buffer.size(), pipe.get()))
        text += buffer.data();
    return text;
}

/// GLM's full template names are no help to a reader.
std::string prettyName(std::string name) {
    static const std::regex vectorType(
        R"(glm::(vec|mat)<([234])(?:, ([234]))?, float, \(glm::qualifier\)0>)");
    return std::regex_replace(name, vectorType, "glm::$1$2");
}

std::string demangle(const std::string& symbol) {
    int status = 0;
    std::unique_ptr<char, void (*)(void*)> text(
        abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), std::free);
    return prettyName(status == 0 ? text.get() : symbol);
}

std::string shellQuoted(const std::string& text) {
    return "'" + std::regex_replace(text, std::regex("'"), R"('\'')") + "'";
}

/// "rotation, rotation.cpp:17" for the innermost frame that lies in a file of the stage other than
/// the harness; empty when there is none.
std::string locate(const std::string& objectPath, const std::vector<std::uint64_t>& offsets) {
    if (offsets.empty())
        return {};
    std::ostringstream command;
    command << "addr2line -C -f -i -e " << shellQuoted(objectPath);
    for (const std::uint64_t offset : offsets)
        command << " 0x" << std::hex << offset - 1;  // a return address is one past its call
    command << " 2>/dev/null";

    std::istringstream lines(outputOf(command.str()));
    std::string function, place;
    while (std::getline(lines, function) && std::getline(lines, place)) {
        // Files of the stage were compiled by their bare names: "./Camera.cpp:17".
        if (!place.starts_with("./") || place.find("harness.cpp") != std::string::npos)
            continue;
        while (place.starts_with("./"))
            place.erase(0, 2);
        return function.substr(0, function.find('(')) + ", " +
               place.substr(0, place.find(" (discriminator"));
    }
    return {};
}

}  // namespace

void installCrashHandlers(int descriptor) {
    reportDescriptor = descriptor;
    void* warmUp[1];
    backtrace(warmUp, 1);  // loads the unwinder now, not in the handler
    static const std::unique_ptr<char[]> stack(new char[kSignalStackBytes]);
    stack_t alternative{};
    alternative.ss_sp = stack.get();
    alternative.ss_size = kSignalStackBytes;
    sigaltstack(&alternative, nullptr);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        struct sigaction action {};
        action.sa_handler = onFatalSignal;
        action.sa_flags = SA_ONSTACK | SA_RESETHAND;
        sigaction(signal, &action, nullptr);
    }
}

void setCrashObject(std::uintptr_t base, std::uintptr_t end) {
    objectBase = base;
    objectEnd = end;
}

std::string describeCrash(const std::string& objectPath, const std::vector<std::uint64_t>& report) {
    if (report.empty())
        return {};
    const std::string place = locate(objectPath, {report.begin() + 1, report.end()});
    const std::string caller = ", called by " + (place.empty() ? "your code" : place);
    switch (static_cast<DriverWork>(report.front())) {
        case DriverWork::shaders:
            return "the driver's shader compiler" + caller;
        case DriverWork::drawing:
            return "the driver (OpenGL)" + caller;
        case DriverWork::none:
            break;
    }
    return place;
}

std::string describeMissingSymbol(const std::string& objectPath, const std::string& symbol) {
    const std::string wanted = demangle(symbol);
    const std::string name = wanted.substr(0, wanted.find('('));
    std::string sentence = "`" + wanted + "` is defined in none of the submitted files";

    std::istringstream lines(
        outputOf("nm -DC --defined-only " + shellQuoted(objectPath) + " 2>/dev/null"));
    for (std::string line; std::getline(lines, line);) {
        const auto start = line.find(' ', line.find(' ') + 1) + 1;  // behind address and kind
        const std::string defined = prettyName(line.substr(start));
        if (defined.starts_with(name + "("))
            return sentence + "; they define `" + defined +
                   "`: the types must be the same to the letter";
    }
    return sentence + ": check the spelling and the types of its parameters";
}

}  // namespace runner
