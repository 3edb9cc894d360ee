#include "SystemFiles.h"

#include <dlfcn.h>
#include <gmock/gmock.h>

#include <algorithm>

namespace grader {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::Not;

bool isIn(const fs::path& file, const std::vector<fs::path>& shown) {
    return std::any_of(shown.begin(), shown.end(), [&](const fs::path& each) {
        const fs::path rest = file.lexically_relative(each);
        return !rest.empty() && *rest.begin() != "..";
    });
}

fs::path libraryOf(const char* name) {
    const void* handle = dlopen(name, RTLD_LAZY);
    Dl_info info{};
    if (!handle || dladdr(dlsym(const_cast<void*>(handle), "OSMesaMakeCurrent"), &info) == 0)
        return {};
    return fs::canonical(info.dli_fname);
}

TEST(SystemFiles, ACompilerSeesAllOfIt) {
    EXPECT_THAT(wholeSystem(), Contains(fs::path("/usr")));
}

TEST(SystemFiles, OthersSeeFoldersOfLibrariesAndTheLoader) {
    const std::vector<fs::path> shown = librariesAnd({});
    EXPECT_TRUE(isIn(libraryOf("libOSMesa.so.8"), shown)) << "what draws";
    EXPECT_TRUE(isIn(libraryOf("libOSMesa.so.8").parent_path() / "dri/swrast_dri.so", shown));
    for (const char* other : {"/usr/bin/env", "/usr/include/stdio.h", "/usr/lib/gcc", "/usr/share",
                              "/usr/src", "/usr/sbin"})
        EXPECT_FALSE(isIn(other, shown)) << other;
    EXPECT_THAT(shown, Each(Not(AnyOf(fs::path("/usr"), fs::path("/usr/lib")))));
}

TEST(SystemFiles, AndTheProgramsThatAreNamedIfThereAreAny) {
    EXPECT_THAT(librariesAnd({"sh", "no-such-program"}), Contains(fs::path("/usr/bin/sh")));
    EXPECT_FALSE(isIn("/usr/bin/no-such-program", librariesAnd({"no-such-program"})));
}

TEST(SystemFiles, NothingIsNamedThatIsNotThereAndNoLink) {
    for (const auto& shown : {wholeSystem(), librariesAnd({})})
        for (const fs::path& each : shown)
            EXPECT_TRUE(fs::exists(each)) << each;
    for (const fs::path& link : systemLinks()) {
        EXPECT_TRUE(fs::is_symlink(link)) << link;
        EXPECT_THAT(wholeSystem(), Not(Contains(link)));
    }
}

}  // namespace
}  // namespace grader
