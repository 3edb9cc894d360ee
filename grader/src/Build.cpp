#include "Build.h"

#include <algorithm>
#include <csignal>
#include <map>
#include <set>

#include "Cgroup.h"
#include "Error.h"
#include "Includes.h"
#include "ObjectCache.h"
#include "Portability.h"
#include "Process.h"
#include "TimeBox.h"
#include "protocol/Message.h"
#include "subject/KernelLimits.h"

namespace grader {

namespace {

constexpr int kCompilerMemoryMib = 2048;  // of each process; where there is a cgroup, of all
constexpr int kLargestObjectMib = 64;
constexpr std::size_t kLongestLog = 256 * 1024;

/// In the words of cc1plus and of the C++ library.
bool ranOutOfMemory(const std::string& log) {
    for (const char* words : {"out of memory allocating", "virtual memory exhausted"})
        if (log.find(words) != std::string::npos)
            return true;
    return false;
}

/// In the words of g++ and of collect2, or in bubblewrap's exit code: by SIGKILL, or by SIGXCPU.
bool wasKilled(const ProcessResult& result) {
    for (const int signal : {SIGKILL, SIGXCPU})
        if (result.endedBy(signal) || result.output.find(fmt::format("terminated with signal {}",
                                                                     signal)) != std::string::npos)
            return true;
    for (const char* words :
         {"Killed signal terminated program", "CPU time limit exceeded signal terminated program"})
        if (result.output.find(words) != std::string::npos)
            return true;
    return false;
}

/// What is said when a sandbox or a compiler does not even start, or has nowhere to write.
bool wasShortOfSomething(const ProcessResult& result) {
    for (const char* words : {"Resource temporarily unavailable", "Cannot allocate memory",
                              "No space left on device", "Input/output error"})
        if (result.output.find(words) != std::string::npos)
            return true;
    return sandboxFailed(result);
}

/// What one command made of its input.
struct Made {
    bool ok = false;
    bool fromOutside = false;  ///< see BuildResult
    std::string log;
};

class OneBuild {
public:
    OneBuild(const Toolchain& tools, const Sandbox& sandbox, const Stage& stage,
             const AssignmentLimits& limits, const Job& job)
        : tools_(tools),
          sandbox_(sandbox),
          stage_(stage),
          limits_(limits),
          cache_(tools.cache / "objects"),
          sources_(job.work.path() / "stage"),
          held_(job.work.path() / "held"),
          out_(job.work.path() / "out"),
          user_(job.user.id()),
          cgroup_({.memoryMib = kCompilerMemoryMib, .endTogether = false}),
          includesOnlyHeaders_(
              std::all_of(stage.files.begin(), stage.files.end(), [](const StagedFile& file) {
                  const bool code = isHeader(file.name) || file.name.ends_with(".cpp");
                  return !code || includesOnlyHeaders(file.content);
              })) {}

    BuildResult run() {
        layOut();
        std::vector<std::future<Made>> compiling;
        const auto files = translationUnits();
        for (const StagedFile* file : files)
            compiling.push_back(alongside([=, this] { return compile(*file); }));
        BuildResult result;
        result.stage = sources_;
        result.ok = true;
        for (std::future<Made>& each : compiling)
            note(each.get(), result);
        if (result.ok)
            note(link(files), result);
        removeSources();
        std::stable_sort(result.diagnostics.begin(), result.diagnostics.end(),
                         [](const Diagnostic& a, const Diagnostic& b) {
                             return a.severity == "error" && b.severity != "error";
                         });
        for (Diagnostic& each : result.diagnostics)
            quoteSource(each);
        result.object = out_ / "subject.so";
        result.user = user_;
        return result;
    }

private:
    void layOut() const {
        fs::create_directories(sources_);
        fs::create_directories(held_);
        for (const StagedFile& file : stage_.files)
            if (!isHeld(file))
                writeFile(sources_ / file.name, file.content);
        for (const StagedFile* file : heldFiles())
            writeFile(held_ / file->name, file->content);
        fs::create_directories(out_);
        shareWithSandbox(sources_, user_, false);
        shareWithSandbox(held_, user_, false);
        shareWithSandbox(out_, user_, true);
    }

    static bool isSource(const StagedFile& file) { return file.name.ends_with(".cpp"); }

    /// A solution that stands in for a source is compiled where no text of the submission's is, not
    /// even a header.
    static bool isHeld(const StagedFile& file) {
        return isSource(file) && file.origin == "solutions";
    }

    /// All that a compiler of stand-ins sees, none where there is no stand-in.
    std::vector<const StagedFile*> heldFiles() const {
        std::vector<const StagedFile*> files;
        for (const StagedFile& file : stage_.files)
            if (isHeld(file))
                files.push_back(&file);
        if (files.empty())
            return files;
        for (const StagedFile& file : stage_.coursesHeaders)
            files.push_back(&file);
        for (const StagedFile& file : stage_.files)
            if (isHeader(file.name) && file.role == Role::provided)
                files.push_back(&file);
        return files;
    }

    /// What runs needs none, and must not read what stands in for a part of its own.
    void removeSources() const {
        fs::remove_all(held_);
        for (const StagedFile& file : stage_.files)
            if (isSource(file) || isHeader(file.name))
                fs::remove(sources_ / file.name);
    }

    /// The student's own files first: the linker takes the first definition it meets.
    std::vector<const StagedFile*> translationUnits() const {
        std::vector<const StagedFile*> files;
        for (const Role role : {Role::own, Role::provided, Role::inherited})
            for (const StagedFile& file : stage_.files)
                if (file.role == role && isSource(file))
                    files.push_back(&file);
        return files;
    }

    static std::string objectName(const StagedFile& file) {
        std::string name = file.name;
        std::replace(name.begin(), name.end(), '/', '_');
        return name + ".o";
    }

    Made compile(const StagedFile& file) {
        std::vector<std::string> command = {tools_.compiler};
        command.insert(command.end(), tools_.compileFlags.begin(), tools_.compileFlags.end());
        const std::string kit = tools_.kit.string();
        for (const std::string& each :
             {std::string("-include"), kit + "/prelude/prelude.h", "-I" + kit + "/include",
              std::string("-I."), "-ffile-prefix-map=" + sources_.string() + "=.",
              "-ffile-prefix-map=" + held_.string() + "=.",
              std::string("-fdiagnostics-color=never"), std::string("-fno-diagnostics-show-caret"),
              std::string("-fmessage-length=0"), std::string("-fmax-errors=20")})
            command.push_back(each);
        command.insert(command.end(), {"-c", file.name, "-o", (out_ / objectName(file)).string()});
        return cached(keyOf(file), command, objectName(file), isHeld(file) ? held_ : sources_);
    }

    Made link(const std::vector<const StagedFile*>& files) {
        std::vector<std::string> objects, inherited;
        std::string key = "link";
        for (const StagedFile* file : files) {
            (file->role == Role::inherited ? inherited : objects)
                .push_back((out_ / objectName(*file)).string());
            key += " " + file->name + " " + keyOf(*file);
        }
        if (!inherited.empty()) {
            std::vector<std::string> archive = {"ar", "rcs", (out_ / "inherited.a").string()};
            archive.insert(archive.end(), inherited.begin(), inherited.end());
            if (Made made = cached(sha256("archive" + key), archive, "inherited.a", sources_);
                !made.ok)
                return made;
            objects.push_back((out_ / "inherited.a").string());
        }
        std::vector<std::string> command = {tools_.compiler};
        command.insert(command.end(), tools_.linkFlags.begin(), tools_.linkFlags.end());
        command.insert(command.end(), objects.begin(), objects.end());
        command.push_back((tools_.kit / "lib/libcg.a").string());
        command.insert(command.end(), {"-o", (out_ / "subject.so").string()});
        return cached(sha256(key), command, "subject.so", sources_);
    }

    /// All that the object depends on: flags, compiler, our headers, the file, and every file of
    /// the stage that it could include.
    std::string keyOf(const StagedFile& file) const {
        std::string text = tools_.compiler + "\n" + tools_.compilerVersion + "\n" +
                           tools_.kitFingerprint + "\n" + sandboxIndependentFlags();
        if (isHeld(file)) {
            for (const StagedFile* each : heldFiles())
                text += each->name + "\n" + sha256(withoutComments(each->content)) + "\n";
            return sha256(file.name + "\nheld\n" + text);
        }
        const auto reached = reachedFrom(file);
        for (const StagedFile& each : stage_.files)
            if (reached.contains(&each) || !includesOnlyHeaders_)
                text += each.name + "\n" + sha256(withoutComments(each.content)) + "\n";
        return sha256(file.name + "\n" + text);
    }

    /// A file and those of the stage that it includes, by whichever way. The kit's own headers
    /// include none of them.
    std::set<const StagedFile*> reachedFrom(const StagedFile& file) const {
        std::set<const StagedFile*> reached;
        std::vector<const StagedFile*> next = {&file};
        while (!next.empty()) {
            const StagedFile* here = next.back();
            next.pop_back();
            if (!reached.insert(here).second)
                continue;
            const auto names = includedNames(here->content);
            for (const StagedFile& each : stage_.files)
                if (names.contains(fs::path(each.name).filename().string()))
                    next.push_back(&each);
        }
        return reached;
    }
    std::string sandboxIndependentFlags() const {
        return fmt::format("{} {}\n", fmt::join(tools_.compileFlags, " "),
                           fmt::join(tools_.linkFlags, " "));
    }

    Made cached(const std::string& key, const std::vector<std::string>& command,
                const std::string& output, const fs::path& folder) {
        const fs::path made = out_ / output;
        if (const auto log = cache_.fetch(key, made))
            return {true, false, *log};
        Confinement confinement;
        confinement.readable = {tools_.kit, folder};
        confinement.writable = {out_};
        confinement.workingFolder = folder;
        confinement.user = user_;
        confinement.cgroup = cgroup_.folder();
        confinement.limits.cpuSeconds = limits_.buildSeconds;
        confinement.limits.memoryMib = kCompilerMemoryMib;
        confinement.limits.fileMib = kLargestObjectMib;
        // Its own limit is on processor time: a crowded machine makes the clock no judge of code.
        ProcessResult result =
            grader::run(sandbox_.confine(confinement, command),
                        limits_.buildSeconds * double(protocol::kMostStretch), kLongestLog);
        if (result.succeeded() && fs::is_regular_file(fs::symlink_status(made)))
            cache_.store(key, made, result.output);
        if (result.succeeded())
            return {true, false, result.output};
        const std::string excess = excessOf(result);
        if (!excess.empty())
            result.output += fmt::format("\n{}:1:1: error: the compiler {}\n",
                                         output.substr(0, output.size() - 2), excess);
        const bool fromOutside =
            excess.empty() && (wasKilled(result) || wasShortOfSomething(result));
        return {false, fromOutside, result.output};
    }

    /// Which limit a failing compiler met; empty for none.
    std::string excessOf(const ProcessResult& result) const {
        const bool endedByKernel =
            wasKilled(result) && judge::interventionsIn(cgroup_.folder()).memory > 0;
        if (ranOutOfMemory(result.output) || endedByKernel)
            return fmt::format("needed more than {} MiB of memory", kCompilerMemoryMib);
        if (result.output.find("File size limit exceeded signal terminated") != std::string::npos)
            return fmt::format("wrote more than {} MiB", kLargestObjectMib);
        if (result.timedOut || (wasKilled(result) && result.canHaveUsed(limits_.buildSeconds)))
            return fmt::format("did not finish within {} s", limits_.buildSeconds);
        return "";
    }

    /// A solution that stands in for a file is nobody's to read.
    void quoteSource(Diagnostic& diagnostic) const {
        const StagedFile* file = stage_.find(diagnostic.file);
        if (file && file->origin != "solutions")
            diagnostic.source = sourceLine(file->content, diagnostic.line);
    }

    /// A header that is there under a name that other systems do not tell from the one asked for.
    void explainCase(Diagnostic& diagnostic) const {
        static const std::string missing = ": No such file or directory";
        if (!diagnostic.message.ends_with(missing))
            return;
        std::vector<std::string> names;
        for (const StagedFile& file : stage_.files)
            names.push_back(file.name);
        const fs::path kit = tools_.kit / "include";
        for (const auto& each : fs::recursive_directory_iterator(kit))
            names.push_back(each.path().lexically_relative(kit).string());
        const std::string wanted =
            diagnostic.message.substr(0, diagnostic.message.size() - missing.size());
        if (const std::string name = nameInOtherCase(wanted, names); !name.empty())
            diagnostic.message += ", but there is " + name;
    }

    /// Of a file that is not the student's, its name is enough, and may be a lie (#line).
    void note(const Made& made, BuildResult& result) const {
        auto found = parseDiagnostics(made.log);
        for (Diagnostic& each : found) {
            if (!stage_.find(each.file))
                each.file = fs::path(each.file).filename().string();
            explainCase(each);
        }
        result.diagnostics.insert(result.diagnostics.end(), found.begin(), found.end());
        result.ok = result.ok && made.ok;
        result.fromOutside = result.fromOutside || made.fromOutside;
        const bool explained = std::any_of(found.begin(), found.end(), [](const Diagnostic& each) {
            return each.severity == "error";
        });
        if (!made.ok && !explained)
            result.diagnostics.push_back(
                {"", 0, 0, "error", withoutFolders(made.log.substr(0, made.log.find('\n')))});
    }

    const Toolchain& tools_;
    const Sandbox& sandbox_;
    const Stage& stage_;
    const AssignmentLimits& limits_;
    ObjectCache cache_;
    fs::path sources_, held_, out_;
    unsigned user_;
    Cgroup cgroup_;             ///< of all compilers; the largest one ends when memory runs out
    bool includesOnlyHeaders_;  ///< of every C++ file in the stage
};

}  // namespace

double longestBuild(const AssignmentLimits& limits) {
    // All files at once, their archive, and the link.
    return 3.0 * limits.buildSeconds * protocol::kMostStretch;
}

BuildResult Builder::build(const Stage& stage, const AssignmentLimits& limits,
                           const Job& job) const {
    return OneBuild(tools_, sandbox_, stage, limits, job).run();
}

}  // namespace grader
