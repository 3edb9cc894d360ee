// OSMesa and EGL draw the same pictures, to the last byte, and give the same points.

#include "Lab.h"

namespace {

using lab::fs::path;

/// Name → bytes of every picture that a solution drew with a context provider.
std::map<std::string, std::string> picturesOf(const std::string& provider, const path& report) {
    const auto graded = lab::runGrader({"--submission", (lab::root() / "solutions").string(),
                                        "--context", provider, "--report", report.string()});
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    std::map<std::string, std::string> pictures;
    if (!lab::fs::is_directory(report))
        return pictures;
    for (const auto& entry : lab::fs::recursive_directory_iterator(report))
        if (entry.path().string().ends_with(".submission.png"))
            pictures[entry.path().lexically_relative(report).string()] =
                lab::readFile(entry.path());
    return pictures;
}

bool isInstalled(const std::string& library) {
    return lab::run({"sh", "-c", "/sbin/ldconfig -p | grep -q " + library}, 10.0).succeeded();
}

TEST(Providers, DrawTheSameBytes) {
    if (!isInstalled("libOSMesa.so") || !isInstalled("libEGL.so.1"))
        GTEST_SKIP() << "needs both libosmesa6 and libegl1";
    const lab::WorkFolder work;
    const auto osmesa = picturesOf("osmesa", work.path() / "osmesa");
    const auto egl = picturesOf("egl", work.path() / "egl");
    ASSERT_GE(osmesa.size(), 18u);
    ASSERT_EQ(osmesa.size(), egl.size());
    for (const auto& [name, bytes] : osmesa)
        EXPECT_TRUE(egl.contains(name) && egl.at(name) == bytes) << name;
}

}  // namespace
