#include "CourseCopy.h"

#include <set>

#include "Fields.h"

namespace lab {

using namespace grader;

namespace {

/// What lies around in a checkout, and is none of its files.
bool isLeftOut(const fs::path& name) {
    static const std::set<fs::path> ofTheTop = {"build", ".git", "report", ".cache"};
    return ofTheTop.contains(name) || name.filename() == "node_modules";
}

void copyCheckout(const fs::path& from, const fs::path& to) {
    for (auto it = fs::recursive_directory_iterator(from); it != fs::recursive_directory_iterator();
         ++it) {
        const fs::path name = it->path().lexically_relative(from);
        if (isLeftOut(name))
            it.disable_recursion_pending();
        else if (it->is_directory())
            fs::create_directory(to / name);
        else if (it->is_regular_file())
            fs::copy_file(it->path(), to / name);
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
