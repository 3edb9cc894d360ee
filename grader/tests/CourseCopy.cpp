#include "CourseCopy.h"

#include <algorithm>
#include <array>

#include "Fields.h"

namespace lab {

using namespace grader;

namespace {

void copyCheckout(const fs::path& from, const fs::path& to) {
    constexpr std::array kLeftOut = {"build", ".git", "report", "node_modules", ".cache"};
    for (const auto& entry : fs::directory_iterator(from)) {
        const std::string name = entry.path().filename().string();
        if (std::find(kLeftOut.begin(), kLeftOut.end(), name) != kLeftOut.end())
            continue;
        if (entry.is_directory()) {
            fs::create_directory(to / name);
            copyCheckout(entry.path(), to / name);
        } else {
            fs::copy_file(entry.path(), to / name);
        }
    }
}

}  // namespace

CourseCopy::CourseCopy() {
    copyCheckout(COURSE_ROOT, root());
    const fs::path program = COURSE_GRADER, built = program.parent_path().parent_path();
    fs::create_directories(build() / "grader");
    fs::copy_file(program, build() / "grader/grader");
    Json tools = parseJsonFile((program.parent_path() / "toolchain.json").string());
    tools["root"] = root().string();
    tools["build"] = build().string();
    writeFile(build() / "grader/toolchain.json", tools.dump());
    fs::create_symlink(built / "kit", build() / "kit");
    fs::create_directory(build() / "judges");
    for (const auto& judge : fs::directory_iterator(built / "judges"))
        fs::create_symlink(judge.path(), build() / "judges" / judge.path().filename());
    fs::create_directory(built / "cache");  // its entries are named by all that decides them
    fs::create_symlink(built / "cache", build() / "cache");
    writeFile(root() / "grade",
              "#!/bin/sh\nexec '" + (build() / "grader/grader").string() + "' \"$@\"\n");
    fs::permissions(root() / "grade", fs::perms(0755));
}

ProcessResult CourseCopy::sh(const std::string& line, const std::string& folder,
                             double seconds) const {
    return run({"bash", "-c", "cd \"$0\" && " + line, (root() / folder).string()}, seconds);
}

ProcessResult CourseCopy::buildAssignment(const std::string& targets) const {
    fs::copy_file(root() / "grader/tests/one_assignment.cmake", root() / "CMakeLists.txt",
                  fs::copy_options::overwrite_existing);
    return sh("cmake -S . -B build/release -G Ninja -DBUILT='" COURSE_BUILT_LIBRARIES
              "' -DCMAKE_BUILD_TYPE='" COURSE_BUILD_TYPE "' -DCMAKE_CXX_FLAGS='" COURSE_CXX_FLAGS
              "' > configure.log 2>&1 || { cat configure.log; exit 1; }; "
              "cmake --build build/release --target " +
                  targets,
              ".", 300);
}

}  // namespace lab
