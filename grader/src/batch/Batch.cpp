#include "batch/Batch.h"

#include <algorithm>
#include <numeric>
#include <thread>

#include "Error.h"
#include "batch/Replay.h"
#include "report/HtmlReport.h"
#include "report/TerminalReport.h"

namespace grader {

namespace {

/// How much there is to read: what takes long is begun first.
std::uintmax_t sizeOf(const Entrant& entrant) {
    std::error_code unknown;
    if (entrant.kind == EntrantKind::archive)
        return fs::file_size(entrant.path, unknown);
    std::uintmax_t sum = 0;
    if (entrant.kind == EntrantKind::looseFiles) {
        for (const LooseFile& each : entrant.files)
            sum += fs::file_size(each.path, unknown);
        return sum;
    }
    for (auto each = fs::recursive_directory_iterator(entrant.path, unknown);
         !unknown && each != fs::recursive_directory_iterator(); each.increment(unknown))
        if (each->is_regular_file(unknown))
            sum += each->file_size(unknown);
    return sum;
}

std::string hashOfFolder(const fs::path& folder) {
    std::string text;
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file())
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        text += file.lexically_relative(folder).string() + "\n" + sha256(readFile(file)) + "\n";
    return sha256(text);
}

/// What vanished since the batch began must not count as a submission without files.
void requireThere(const Entrant& entrant) {
    std::vector<fs::path> needed = {entrant.path};
    for (const LooseFile& each : entrant.files)
        needed.push_back(each.path);
    for (const fs::path& each : needed)
        if (!fs::exists(each))
            throw Error("{} was there when the batch began, and is gone", each.string());
}

/// Which commit a repository's HEAD names, however it does.
std::string hashOfReferences(const fs::path& repository) {
    std::string text;
    for (const char* each : {"HEAD", "packed-refs"})
        if (fs::is_regular_file(fs::symlink_status(repository / each)))
            text += sha256(readFile(repository / each)) + "\n";
    return sha256(text + hashOfFolder(repository / "refs"));
}

/// Where a submission has what may be handed in for an assignment, by name.
std::map<std::string, fs::path> filesIn(const Submission& submission, const Manifest& manifest) {
    std::map<std::string, fs::path> files;
    const fs::path folder = submission.folderFor(manifest.id, manifest.id);
    for (const std::string& name : manifest.submit)
        files[name] = folder / name;
    for (const auto& [name, from] : manifest.inherits)
        files[name] = fs::exists(fs::symlink_status(folder / name))
                          ? folder / name
                          : submission.folderFor(from, manifest.id) / name;
    return files;
}

Standing standingFrom(const std::string& entrant, Json document) {
    Standing standing{entrant, document.at("status"), "", 0, 0, nullptr, "", false};
    if (standing.status == "refused") {
        standing.sentence = document.at("sentence");
    } else {
        standing.points = document.at("points");
        standing.maxPoints = document.at("max_points");
    }
    standing.result = std::move(document);
    return standing;
}

}  // namespace

Batch::Batch(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
             const Ledger& ledger, std::uint64_t seed, std::string key, bool stable)
    : grader_(grader),
      sandbox_(sandbox),
      manifest_(manifest),
      ledger_(ledger),
      seed_(seed),
      key_(std::move(key) + (stable ? "stable\n" : "")),
      stable_(stable),
      known_(knownAssignments(grader.tools().root)) {}

std::vector<Standing> Batch::run(const std::vector<Entrant>& entrants, int jobs, bool fresh,
                                 const std::atomic<bool>& stop,
                                 const std::function<void(const Standing&)>& tell) const {
    std::vector<std::size_t> order(entrants.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<std::uintmax_t> sizes;
    for (const Entrant& each : entrants)
        sizes.push_back(sizeOf(each));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });

    std::vector<std::optional<Standing>> standings(entrants.size());
    std::atomic<std::size_t> next = 0;
    std::mutex telling;
    const auto work = [&] {
        for (std::size_t k = next++; k < order.size() && !stop; k = next++) {
            Standing standing = standingOf(entrants[order[k]], fresh);
            const std::scoped_lock lock(telling);
            tell(standing);
            standings[order[k]] = std::move(standing);
        }
    };
    std::vector<std::thread> workers;
    for (int i = 1; i < jobs; ++i)
        workers.emplace_back(work);
    work();
    for (std::thread& each : workers)
        each.join();
    std::vector<Standing> done;
    for (auto& each : standings)
        if (each)
            done.push_back(std::move(*each));
    return done;
}

Standing Batch::standingOf(const Entrant& entrant, bool fresh) const {
    std::string fault;
    for (int attempt = 0; attempt < 2; ++attempt) {
        try {
            requireThere(entrant);
            const std::string key = keyOf(entrant);
            if (auto known = fresh ? std::nullopt : ledger_.known(entrant.name, key)) {
                Standing standing = standingFrom(entrant.name, std::move(*known));
                standing.fromBefore = true;
                standing.unstable = ledger_.record(entrant.name).value("unstable", "");
                return standing;
            }
            ledger_.begin(entrant.name);
            Standing standing = gradeOnce(entrant, key);
            if (!standing.graderFailed())
                return standing;
            fault = "see the checks that are grader_error in its report";
        } catch (const std::exception& error) {
            fault = error.what();
        }
    }
    return {entrant.name, "grader_error", fault, 0, 0, nullptr, "", false};
}

Standing Batch::gradeOnce(const Entrant& entrant, const std::string& key) const {
    const Job unpacking;
    const Unpacked unpacked = layOut(grader_.tools(), sandbox_, unpacking, entrant, known_);
    if (!unpacked.refusal.empty()) {
        Json document = {
            {"format", 1},
            {"assignment", manifest_.id},
            {"status", "refused"},
            {"sentence", fmt::format("the {} is refused: {}",
                                     entrant.kind == EntrantKind::clone ? "repository" : "archive",
                                     unpacked.refusal)}};
        ledger_.keep(entrant.name, key, document.dump(2) + "\n");
        return standingFrom(entrant.name, std::move(document));
    }
    const Submission submission = submissionIn(unpacked.folder, known_);
    std::vector<AssignmentResult> results = {grader_.grade(manifest_, submission, seed_)};
    if (!unpacked.notice.empty())
        results.front().notices.push_back(unpacked.notice);
    const std::string unstable = stable_ ? repeated(submission, results.front()) : "";
    writeReports(results, entrant.name);
    ledger_.keepPrint(printOf(entrant.name, submission));
    ledger_.keepSubmission(entrant.name, filesIn(submission, manifest_), manifest_.id);
    ledger_.keepRecord(entrant.name,
                       {{"assignment", manifest_.id}, {"seed", seed_}, {"unstable", unstable}});
    const std::string document = toJson(results.front());
    ledger_.keep(entrant.name, results.front().graderFailed() ? "" : key, document);
    Standing standing = standingFrom(entrant.name, Json::parse(document));
    standing.unstable = unstable;
    return standing;
}

/// How two more gradings differ from the first.
std::string Batch::repeated(const Submission& submission, const AssignmentResult& first) const {
    const Json then = Json::parse(toJson(first));
    for (int time = 2; time <= 3; ++time) {
        const auto differences =
            differencesOf(then, Json::parse(toJson(grader_.grade(manifest_, submission, seed_))));
        if (!differences.empty())
            return fmt::format("graded three times, it came out differently: {}",
                               fmt::join(differences, "; "));
    }
    return "";
}

Print Batch::printOf(const std::string& entrant, const Submission& submission) const {
    const fs::path& root = grader_.tools().root;
    Print print{entrant, {}, ""};
    std::string words;
    for (const StagedFile& file : collect(root, manifest_, submission).stage.files) {
        if (file.role != Role::own || file.origin != "submission")
            continue;
        words += wordsOf(file.content) + "\n";
        print.own.merge(fingerprintsOf(file.content));
    }
    for (const std::string& name : manifest_.submit)
        for (const std::uint64_t each : fingerprintsOf(readFile(manifest_.folder / name)))
            print.own.erase(each);
    print.exact = sha256(words);
    return print;
}

/// Where the submission's files are, as a folder.
void Batch::writeReports(std::vector<AssignmentResult>& results, const std::string& entrant) const {
    const fs::path report = ledger_.folderOf(entrant) / "report",
                   full = ledger_.instructorFolderOf(entrant) / "report";
    writeFile(ledger_.folderOf(entrant) / "report.txt", terminalReport(results.front(), {}));
    if (seed_ == kPublishedSeed) {
        writeReportPictures(results, report);
    } else {
        writeReportPictures(results, full);
        writeFile(full / "index.html", htmlReport(results, full));
        copyPictures(results, grader_.publicFrames(manifest_, seed_), full, report);
    }
    writeFile(report / "index.html", htmlReport(results, report));
}

std::string Batch::keyOf(const Entrant& entrant) const {
    std::string files = key_;
    switch (entrant.kind) {
        case EntrantKind::archive:
            return sha256(key_ + "archive\n" + sha256(readFile(entrant.path)));
        case EntrantKind::clone:
            return sha256(key_ + "clone\n" + hashOfReferences(entrant.path));
        case EntrantKind::looseFiles:
            for (const LooseFile& each : entrant.files)
                files += each.name + " " + sha256(readFile(each.path)) + "\n";
            return sha256(files);
        case EntrantKind::folder:
            break;
    }
    const Collected collected =
        collect(grader_.tools().root, manifest_, submissionIn(entrant.path, known_));
    for (const StagedFile& file : collected.stage.files)
        files += file.name + " " + file.origin + " " + sha256(file.content) + "\n";
    for (const std::string& name : collected.ignored)
        files += "ignored " + name + "\n";
    return sha256(files);
}

std::string keyOfRules(const Toolchain& tools, const Sandbox& sandbox, const Manifest& manifest,
                       std::uint64_t seed) {
    std::string text;
    for (const std::string& each :
         {sha256(readFile("/proc/self/exe")), tools.kitFingerprint, tools.compilerVersion,
          tools.glmVersion, sandbox.name(), cpuModel(), std::to_string(seed),
          sha256(readFile(tools.judge(manifest.id))), hashOfFolder(manifest.folder),
          hashOfFolder(tools.root / "reference_images" / manifest.id),
          hashOfFolder(tools.root / "solutions" / manifest.id)})
        text += each + "\n";
    return sha256(text);
}

}  // namespace grader
