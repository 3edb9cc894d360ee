#pragma once

#include <map>
#include <string>
#include <vector>

#include "Cgroup.h"
#include "Sandbox.h"
#include "Toolchain.h"

namespace grader {

/// One defence against what a submission may do, as it was seen to work on this machine, or not.
struct Defence {
    std::string id, title;
    bool active = false;
    std::string found;   ///< what was seen
    std::string remedy;  ///< how to get it; empty when it is active
};

/// What else two machines may differ in, so that their results do.
struct Fact {
    std::string id, title, value;
};

struct Diagnosis {
    std::string sandbox;  ///< "bubblewrap", "plain"
    std::vector<Defence> defences;
    std::vector<Fact> facts;

    bool allActive() const;
    std::string text() const;  ///< one screen
    std::string json() const;  ///< as grader/RESULT.md describes it
};

/// What a program said in the sandbox about itself: "Seccomp" → "2".
using Confession = std::map<std::string, std::string>;

/// What the defences are, told from that. `root`: the grader was started by root.
std::vector<Defence> defencesFrom(const Confession& said, const std::string& sandbox, bool root);

/// Whether the kernel limits what a submission's processes use in sum.
Defence defenceInSum(const CgroupHome& home);

/// Runs a program in the sandbox that looks around, draws a little, and asks the machine.
Diagnosis diagnose(const Toolchain& tools, const Sandbox& sandbox);

}  // namespace grader
