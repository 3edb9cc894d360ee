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
constexpr std::size_t kMostDiagnostics = 200;

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

/// All that something made can depend on.
struct Origin {
    std::string key;       ///< a hash of it
    bool trusted = false;  ///< nothing of the submission's is in it
};

/// What one command made of its input.
struct Made {
    bool ok = false;
    bool fromOutside = false;  ///< see BuildResult
    std::string log;
    std::string excess;  ///< which limit was met: "did not finish within 10 s"; empty for none
    Origin origin;
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
          stageFolder_(job.work.path() / "stage"),
          compiling_(job.work.path() / "compiling"),
          out_(job.work.path() / "out"),
          user_(job.user.id()),
          cgroup_({.memoryMib = kCompilerMemoryMib, .endTogether = false}),
          includesOnlyHeaders_(
              std::all_of(stage.files.begin(), stage.files.end(), [](const StagedFile& file) {
                  const bool code = isHeader(file.name) || file.name.ends_with(".cpp");
                  return !code || includesOnlyHeaders(file.content);
              })) {}

    BuildResult run() {
        makeClosedFolder(out_);
        shareWithSandbox(out_, user_, true);
        BuildResult result;
        result.stage = stageFolder_;
        result.ok = true;
        const auto files = translationUnits();
        const auto compiled = compileAll(files);
        for (std::size_t i = 0; i < files.size(); ++i)
            note(compiled[i], files[i]->name, result);
        if (result.ok)
            note(link(files, compiled), "", result);
        fs::remove_all(compiling_);
        layOutForRun();
        std::stable_sort(result.diagnostics.begin(), result.diagnostics.end(),
                         [](const Diagnostic& a, const Diagnostic& b) {
                             return a.severity == "error" && b.severity != "error";
                         });
        dropRepeated(result.diagnostics);
        if (result.diagnostics.size() > kMostDiagnostics)
            result.diagnostics.resize(kMostDiagnostics);
        for (Diagnostic& each : result.diagnostics)
            quoteSource(each);
        result.object = out_ / "subject.so";
        result.user = user_;
        return result;
    }

private:
    /// Stand-ins first, whose sources are gone before anything of the submission's is compiled.
    std::vector<Made> compileAll(const std::vector<const StagedFile*>& files) {
        std::vector<std::future<Made>> compiling(files.size());
        for (const bool held : {true, false}) {
            for (std::size_t i = 0; i < files.size(); ++i)
                if (isHeld(*files[i]) == held)
                    compiling[i] = alongside([this, file = files[i]] { return compile(*file); });
            for (const std::future<Made>& each : compiling)
                if (each.valid())
                    each.wait();
        }
        std::vector<Made> compiled;
        for (std::future<Made>& each : compiling)
            compiled.push_back(each.get());
        return compiled;
    }

    /// What runs finds its shaders. It needs no source, and must not read what stands in for a part
    /// of its own.
    void layOutForRun() const {
        makeClosedFolder(stageFolder_);
        for (const StagedFile& file : stage_.files)
            if (!isSource(file) && !isHeader(file.name))
                writeFile(stageFolder_ / file.name, file.content);
        shareWithSandbox(stageFolder_, user_, false);
    }

    static bool isSource(const StagedFile& file) { return file.name.ends_with(".cpp"); }

    /// A solution that stands in for a source is compiled where no text of the submission's is, not
    /// even a header.
    static bool isHeld(const StagedFile& file) {
        return isSource(file) && file.origin == "solutions";
    }

    /// All that the compiler of a file sees, and that its object can depend on: of a stand-in the
    /// course's headers, else what it could include.
    std::vector<const StagedFile*> visibleTo(const StagedFile& file) const {
        std::vector<const StagedFile*> visible;
        if (isHeld(file)) {
            visible.push_back(&file);
            for (const StagedFile& each : stage_.coursesHeaders)
                visible.push_back(&each);
            for (const StagedFile& each : stage_.files)
                if (isHeader(each.name) && each.role == Role::provided)
                    visible.push_back(&each);
            return visible;
        }
        const auto reached = reachedFrom(file);
        for (const StagedFile& each : stage_.files)
            if ((reached.contains(&each) || !includesOnlyHeaders_) && !(isHeld(each)))
                visible.push_back(&each);
        return visible;
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
    fs::path objectOf(const StagedFile& file) const {
        const std::string name = objectName(file);
        return compiling_ / name / "made" / name;
    }

    /// Each compiler has folders of its own: it could write the bytes of any file that it sees into
    /// its object (.incbin), and no text says for sure that it does not.
    Made compile(const StagedFile& file) {
        const auto visible = visibleTo(file);
        Origin origin{"compile " + file.name + "\n" + flagsAndTools(), true};
        for (const StagedFile* each : visible) {
            origin.key += each->name + "\n" + sha256(withoutComments(each->content)) + "\n";
            origin.trusted = origin.trusted && each->origin != "submission";
        }
        origin.key = sha256(origin.key);
        const fs::path made = objectOf(file);
        makeClosedFolder(made.parent_path());
        shareWithSandbox(made.parent_path(), user_, true);
        if (const auto known = fetched(origin, made))
            return *known;
        const fs::path sources = compiling_ / objectName(file) / "sources";
        makeClosedFolder(sources);
        for (const StagedFile* each : visible)
            writeFile(sources / each->name, withoutComments(each->content));
        shareWithSandbox(sources, user_, false);
        Made result = make(origin, compilerCall(file, sources), made, sources);
        fs::remove_all(sources);
        return result;
    }

    std::vector<std::string> compilerCall(const StagedFile& file, const fs::path& sources) const {
        std::vector<std::string> command = {tools_.compiler};
        command.insert(command.end(), tools_.compileFlags.begin(), tools_.compileFlags.end());
        const std::string kit = tools_.kit.string();
        for (const std::string& each :
             {std::string("-include"), kit + "/prelude/prelude.h", "-I" + kit + "/include",
              std::string("-I."), "-ffile-prefix-map=" + sources.string() + "=.",
              std::string("-fdiagnostics-color=never"), std::string("-fno-diagnostics-show-caret"),
              std::string("-fmessage-length=0"), std::string("-fmax-errors=20")})
            command.push_back(each);
        command.insert(command.end(), {"-c", file.name, "-o", objectOf(file).string()});
        return command;
    }

    Made link(const std::vector<const StagedFile*>& files, const std::vector<Made>& compiled) {
        std::vector<std::string> objects, inherited;
        std::string key = "link";
        bool trusted = true;
        for (std::size_t i = 0; i < files.size(); ++i) {
            (files[i]->role == Role::inherited ? inherited : objects)
                .push_back(objectOf(*files[i]).string());
            key += " " + files[i]->name + " " + compiled[i].origin.key;
            trusted = trusted && compiled[i].origin.trusted;
        }
        if (!inherited.empty()) {
            std::vector<std::string> archive = {"ar", "rcs", (out_ / "inherited.a").string()};
            archive.insert(archive.end(), inherited.begin(), inherited.end());
            if (Made made = linked({sha256("archive" + key), trusted}, archive, "inherited.a");
                !made.ok)
                return made;
            objects.push_back((out_ / "inherited.a").string());
        }
        std::vector<std::string> command = {tools_.compiler};
        command.insert(command.end(), tools_.linkFlags.begin(), tools_.linkFlags.end());
        command.insert(command.end(), objects.begin(), objects.end());
        command.push_back((tools_.kit / "lib/libcg.a").string());
        command.insert(command.end(), {"-o", (out_ / "subject.so").string()});
        return linked({sha256(key), trusted}, command, "subject.so");
    }

    Made linked(const Origin& origin, const std::vector<std::string>& command,
                const std::string& name) {
        const auto known = fetched(origin, out_ / name);
        return known ? *known : make(origin, command, out_ / name, compiling_);
    }

    std::string flagsAndTools() const {
        return fmt::format("{}\n{}\n{}\n{} {}\n", tools_.compiler, tools_.compilerVersion,
                           tools_.kitFingerprint, fmt::join(tools_.compileFlags, " "),
                           fmt::join(tools_.linkFlags, " "));
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

    /// Where a compiler could read what is not in its key, only our own objects are kept.
    bool mayKeep(const Origin& origin) const { return origin.trusted || sandbox_.hidesFiles(); }

    std::optional<Made> fetched(const Origin& origin, const fs::path& file) const {
        if (const auto log = mayKeep(origin) ? cache_.fetch(origin.key, file) : std::nullopt)
            return Made{true, false, *log, "", origin};
        return std::nullopt;
    }

    /// Runs a command that makes a file of what it reads in a folder.
    Made make(const Origin& origin, const std::vector<std::string>& command, const fs::path& file,
              const fs::path& folder) {
        Confinement confinement;
        confinement.readable = {tools_.kit, folder};
        confinement.writable = {file.parent_path()};
        confinement.workingFolder = folder;
        confinement.user = user_;
        confinement.cgroup = cgroup_.folder();
        confinement.limits.cpuSeconds = limits_.buildSeconds;
        confinement.limits.memoryMib = kCompilerMemoryMib;
        confinement.limits.fileMib = kLargestObjectMib;
        // Its own limit is on processor time: a crowded machine makes the clock no judge of code.
        const ProcessResult result = grader::run(
            sandbox_.confine(confinement, command),
            limits_.buildSeconds * double(protocol::kMostStretch), {.outputLimit = kLongestLog});
        if (result.succeeded()) {
            if (mayKeep(origin) && typeOf(file) == fs::file_type::regular)
                cache_.store(origin.key, file, result.output);
            return {true, false, result.output, "", origin};
        }
        const std::string excess = excessOf(result);
        const bool fromOutside =
            excess.empty() && (wasKilled(result) || wasShortOfSomething(result));
        return {false, fromOutside, result.output, excess, origin};
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
        if (result.cut && result.output.find(" error: ") == std::string::npos)
            return fmt::format("said more than {} KiB before its first error", kLongestLog >> 10);
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

    /// Takes over what the compiler said of a file. Of one that is not the student's, its name is
    /// enough, and may be a lie (#line).
    void note(const Made& made, const std::string& file, BuildResult& result) const {
        auto found = parseDiagnostics(made.log);
        if (!made.excess.empty())
            found.push_back({file, 0, 0, "error", "the compiler " + made.excess, ""});
        for (Diagnostic& each : found) {
            if (!stage_.find(each.file))
                each.file = fs::path(each.file).filename().string();
            explainCase(each);
        }
        const bool explained = std::any_of(found.begin(), found.end(), [](const Diagnostic& each) {
            return each.severity == "error";
        });
        if (!made.ok && !explained) {
            const std::string said = withoutFolders(made.log.substr(0, made.log.find('\n')));
            found.push_back(
                {"", 0, 0, "error", said.empty() ? "the compiler ended without a word" : said, ""});
        }
        result.diagnostics.insert(result.diagnostics.end(), found.begin(), found.end());
        result.ok = result.ok && made.ok;
        result.fromOutside = result.fromOutside || made.fromOutside;
    }

    const Toolchain& tools_;
    const Sandbox& sandbox_;
    const Stage& stage_;
    const AssignmentLimits& limits_;
    ObjectCache cache_;
    fs::path stageFolder_, compiling_, out_;
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
