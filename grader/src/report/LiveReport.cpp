#include "report/LiveReport.h"

#include <fmt/format.h>

#include <chrono>

#include "report/HtmlReport.h"

namespace grader {

namespace {

constexpr const char* kVersionFile = "version.svg";

/// Two numbers that no page has which is still open, as "WIDTHxHEIGHT".
struct Version {
    long width, height;
};

Version freshVersion() {
    using namespace std::chrono;
    const long ms = duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
    constexpr long kSide = 10000;
    return {1 + ms % kSide, 1 + ms / kSide % kSide};
}

}  // namespace

fs::path writeLiveReport(std::vector<AssignmentResult>& results, const fs::path& folder) {
    const Version version = freshVersion();
    writeReportPictures(results, folder);
    const fs::path page = folder / "index.html";
    writeFile(page,
              htmlReport(results, folder, fmt::format("{}x{}", version.width, version.height)));
    // Last: from now on older pages load the new one.
    writeFile(
        folder / kVersionFile,
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\"/>\n",
                    version.width, version.height));
    return page;
}

void endLiveReport(const fs::path& folder) {
    std::error_code none;
    fs::remove(folder / kVersionFile, none);
}

}  // namespace grader
