#include "bench/Ways.h"

#include <algorithm>
#include <chrono>
#include <future>

#include "Error.h"
#include "Process.h"

namespace bench {

namespace {

constexpr double kPatience = 300.0;  // seconds for one command

}  // namespace

Cost measure(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu = cpuSeconds();
    work();
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {wall, cpuSeconds() - cpu};
}

void mustRun(const std::vector<std::string>& command, int worstExitCode) {
    const ProcessResult result = run(command, kPatience);
    if (result.timedOut || result.exitCode < 0 || result.exitCode > worstExitCode)
        throw Error("{} failed:\n{}", fmt::join(command, " "), result.output);
}

Ways::Ways(const std::string& assignment)
    : tools_(Toolchain::load()),
      manifest_(loadAssignment(tools_.root, assignment)),
      plain_(makePlainProcess(tools_.confine())),
      observer_(tools_, *plain_, {}),
      grader_(tools_, *plain_) {}

void Ways::bare(const Stage& stage) {
    fs::remove_all(bareFolder());
    std::vector<std::string> sources;
    for (const StagedFile& file : stage.files) {
        writeFile(bareFolder() / file.name, file.content);
        if (file.name.ends_with(".cpp"))
            sources.push_back(file.name);
    }
    if (compile(sources))
        linkAndDraw(stage, true);
}

void Ways::bareAgain(const Stage& stage, const std::string& edited) {
    const bool isCode = edited.ends_with(".cpp");
    writeFile(bareFolder() / edited, stage.find(edited)->content);
    if (!isCode || compile({edited}))
        linkAndDraw(stage, isCode);
}

/// All at once. False when one does not compile.
bool Ways::compile(const std::vector<std::string>& files) const {
    std::vector<std::future<bool>> compiling;
    for (const std::string& name : files) {
        std::vector<std::string> command = {tools_.compiler};
        command.insert(command.end(), tools_.compileFlags.begin(), tools_.compileFlags.end());
        const std::string file = (bareFolder() / name).string();
        for (const std::string& each :
             {std::string("-include"), (tools_.kit / "prelude/prelude.h").string(),
              "-I" + (tools_.kit / "include").string(), "-I" + bareFolder().string(),
              std::string("-c"), file, std::string("-o"), file + ".o"})
            command.push_back(each);
        compiling.push_back(std::async(std::launch::async,
                                       [command] { return run(command, kPatience).succeeded(); }));
    }
    bool compiled = true;
    for (auto& each : compiling)
        compiled = each.get() && compiled;
    return compiled;
}

void Ways::linkAndDraw(const Stage& stage, bool link) const {
    const fs::path folder = bareFolder();
    BuildResult build;
    build.ok = true;
    build.stage = folder;
    build.user = user_.id();
    build.object = folder / "subject.so";
    if (link) {
        std::vector<std::string> inherited;
        std::vector<std::string> command = {tools_.compiler};
        command.insert(command.end(), tools_.linkFlags.begin(), tools_.linkFlags.end());
        for (const StagedFile& file : stage.files)
            if (file.name.ends_with(".cpp"))
                (file.role == Role::inherited ? inherited : command)
                    .push_back((folder / file.name).string() + ".o");
        // A file of an earlier assignment gives way to what the submission defines itself.
        if (!inherited.empty()) {
            std::vector<std::string> archive = {"ar", "rcs", (folder / "inherited.a").string()};
            archive.insert(archive.end(), inherited.begin(), inherited.end());
            mustRun(archive);
            command.push_back((folder / "inherited.a").string());
        }
        command.insert(command.end(),
                       {(tools_.kit / "lib/libcg.a").string(), "-o", build.object.string()});
        mustRun(command);
    }
    shareWithSandbox(folder, user_.id(), false);
    observer_.drawFrames(manifest_, build, 1);
}

void Ways::usual(const Stage& stage) {
    const fs::path folder = work_.path() / "usual";
    fs::remove_all(folder);
    fs::copy(fs::path(COURSE_BENCH) / "usual_way", folder, fs::copy_options::recursive);
    for (const StagedFile& file : stage.files)
        writeFile(folder / file.name, file.content);
    const std::string build = (folder / "build").string();
    mustRun({"cmake", "-S", folder.string(), "-B", build, "-G", "Ninja",
             "-DCMAKE_BUILD_TYPE=Release", "-DCOURSE_ROOT=" + tools_.root.string(),
             "-DCOURSE_BUILD=" + tools_.build.string(), "-DASSIGNMENT=" + manifest_.id});
    // What does not compile has no tests to run and no frames to compare.
    if (!run({"cmake", "--build", build}, kPatience).succeeded())
        return;
    mustRun({"ctest", "--test-dir", build}, 8);
    const std::string frames = (folder / "frames").string();
    fs::create_directories(frames);
    mustRun({"sh", "-c", "cd " + folder.string() + " && build/render " + frames});
    for (const Frame& frame : manifest_.frames)
        mustRun(
            {"idiff", "-fail", "0.016", "-failpercent", "0.05", frames + "/" + frame.id + ".png",
             (tools_.root / "reference_images" / manifest_.id / (frame.id + ".png")).string()},
            2);
}

}  // namespace bench
