#include <iostream>

#include "ExitCode.h"
#include "Toolchain.h"
#include "batch/Earlier.h"
#include "batch/Merge.h"
#include "commands/ClassCommands.h"
#include "report/PlainText.h"

namespace grader {

namespace {

int merge(const std::vector<std::string>& parts, const fs::path& out,
          const std::vector<std::string>& compareWith) {
    const Toolchain tools = Toolchain::load();
    Merged merged = readParts({parts.begin(), parts.end()});
    const Manifest manifest = loadAssignment(tools.root, merged.assignment);
    const std::vector<Print> earlier = earlierPrints(compareWith, merged.assignment);
    fs::create_directories(out);
    copyFolders(merged, out);
    const auto likenesses = likenessesAmong(Ledger(out), merged.marks, earlier);
    writeOverview({manifest, merged.marks, merged.notTaken, likenesses, merged.classIds,
                   merged.seed, merged.environment},
                  out);
    for (const std::string& each : merged.notTaken)
        std::cout << "Look at: " << harmless(each) << "\n";
    for (const std::string& each : merged.missing)
        std::cout << "Missing: " << harmless(each) << " is in no part\n";
    std::cout << fmt::format("{} of {} students\nOverview: {}\n", merged.marks.size(),
                             merged.classIds.size(), fs::absolute(out / "index.html").string());
    return merged.missing.empty() ? kFullMarks : kGraderFailed;
}

}  // namespace

void addMergeCommand(CLI::App& app, int& exitCode) {
    static std::vector<std::string> parts, compareWith;
    static std::string out;
    CLI::App* command = app.add_subcommand(
        "merge", "put together what several machines graded with ./grade batch --shard");
    command->add_option("parts", parts, "what each of them wrote to its --out")->required();
    command->add_option("--out", out, "folder for all of it; it may be one of the parts")
        ->required();
    command->add_option("--compare-with", compareWith, "as for ./grade batch");
    command->callback([&exitCode] { exitCode = merge(parts, out, compareWith); });
}

}  // namespace grader
