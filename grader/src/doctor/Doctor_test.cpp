#include "doctor/Doctor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "Fields.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::Not;

/// What a program says in a sandbox in which everything works.
Confession wellKept() {
    return {{"CapEff", "0000000000000000"},
            {"NoNewPrivs", "1"},
            {"Seccomp", "2"},
            {"Processes", "4"},
            {"Self", "1"},
            {"Interfaces", "lo"},
            {"Visible", ""},
            {"Writable", "/tmp"},
            {"Cores", "0"},
            {"Memory", "1048576"},
            {"Threads", "64"}};
}

std::vector<std::string> missing(const Confession& said, const std::string& sandbox = "bubblewrap",
                                 bool root = true) {
    std::vector<std::string> ids;
    for (const Defence& each : defencesFrom(said, sandbox, root)) {
        EXPECT_EQ(each.active, each.remedy.empty()) << each.id;
        EXPECT_FALSE(each.found.empty()) << each.id;
        if (!each.active)
            ids.push_back(each.id);
    }
    return ids;
}

TEST(Doctor, FindsNothingWhereEverythingWorks) {
    EXPECT_THAT(missing(wellKept()), testing::IsEmpty());
}

TEST(Doctor, BelievesNothingThatWasNotSaid) {
    const std::vector<std::string> all = missing({}, "plain", false);
    EXPECT_EQ(all.size(), defencesFrom({}, "plain", false).size()) << "every defence is missing";
}

TEST(Doctor, NamesEachDefenceThatIsMissing) {
    const std::pair<const char*, std::pair<const char*, const char*>> holes[] = {
        {"system_calls", {"Seccomp", "0"}},     {"capabilities", {"CapEff", "000001ffffffffff"}},
        {"capabilities", {"NoNewPrivs", "0"}},  {"processes", {"Processes", "212"}},
        {"network", {"Interfaces", "lo eth0"}}, {"files", {"Visible", "/etc/passwd /home"}},
        {"read_only", {"Writable", "/ /tmp"}},  {"core_dumps", {"Cores", "unlimited"}},
        {"memory", {"Memory", "unlimited"}}};
    for (const auto& [id, what] : holes) {
        Confession said = wellKept();
        said[what.first] = what.second;
        EXPECT_THAT(missing(said), testing::ElementsAre(id)) << what.first;
    }
    EXPECT_THAT(missing(wellKept(), "bubblewrap", false), testing::ElementsAre("user"));
    Confession plain = wellKept();
    EXPECT_THAT(missing(plain, "plain"), testing::ElementsAre("namespaces", "read_only"))
        << "/tmp is everybody's there";
    plain["Writable"] = "";
    EXPECT_THAT(missing(plain, "plain"), testing::ElementsAre("namespaces"));
}

TEST(Doctor, SaysWhetherTheKernelLimitsWhatIsUsedInSum) {
    const Defence without = defenceInSum(CgroupHome("/nowhere"));
    EXPECT_EQ(without.id, "cgroup");
    EXPECT_FALSE(without.active);
    EXPECT_THAT(without.found, HasSubstr("every 20 ms"));
    EXPECT_THAT(without.found, HasSubstr("no cgroup v2 is mounted"));
    EXPECT_THAT(without.remedy, Not(testing::IsEmpty()));

    const testing_help::Tree machine;
    machine.write("proc/self/cgroup", "0::/\n");
    machine.write("proc/self/mountinfo", "1 1 0:1 / /cgroup rw - cgroup2 cgroup2 rw\n");
    machine.write("cgroup/cgroup.controllers", "memory pids\n");
    machine.write("cgroup/cgroup.procs", "");
    const Defence with = defenceInSum(CgroupHome(machine.path()));
    EXPECT_TRUE(with.active) << with.found;
    EXPECT_EQ(with.found, "cgroups in " + (machine / "cgroup").string());
    EXPECT_EQ(with.remedy, "");
}

TEST(Doctor, SaysTheSameOnTheScreenAndAsJson) {
    Diagnosis diagnosis{"bubblewrap",
                        defencesFrom(wellKept(), "bubblewrap", false),
                        {{"renderer", "renderer", "llvmpipe (LLVM 15, 256 bits)"}}};
    EXPECT_FALSE(diagnosis.allActive());
    EXPECT_THAT(diagnosis.text(), HasSubstr("✗ a user of its own for each job"));
    EXPECT_THAT(diagnosis.text(), HasSubstr("→ start the grader as root"));
    EXPECT_THAT(diagnosis.text(), HasSubstr("llvmpipe (LLVM 15, 256 bits)"));
    const std::string text = diagnosis.text();
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 40) << "a screen";
    const Json document = Json::parse(diagnosis.json());
    EXPECT_EQ(document.at("all_active"), false);
    EXPECT_EQ(document.at("defences").at(1).at("id"), "user");
    EXPECT_EQ(document.at("facts").at("renderer"), "llvmpipe (LLVM 15, 256 bits)");
}

}  // namespace
