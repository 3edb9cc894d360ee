#include "batch/Batch.h"

#include <algorithm>
#include <numeric>

#include "Error.h"
#include "ResultDocument.h"
#include "TimeBox.h"
#include "Tokens.h"
#include "batch/Marks.h"
#include "batch/Remark.h"
#include "batch/Replay.h"
#include "report/HtmlReport.h"
#include "report/TerminalReport.h"

namespace grader {

namespace {

/// A fault of the grader's is tried once more.
constexpr int kAttempts = 2;

/// What is killed, and what was waiting for it, takes a moment to end.
constexpr double kLeastGraceSeconds = 5;

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

/// What vanished since the batch began must not count as a submission without files.
void requireThere(const Entrant& entrant) {
    std::vector<fs::path> needed = {entrant.path};
    for (const LooseFile& each : entrant.files)
        needed.push_back(each.path);
    for (const fs::path& each : needed)
        if (!fs::exists(each))
            throw Error("{} was there when the batch began, and is gone", each.string());
}

/// The contents of a submission's files that were taken, by name.
std::map<std::string, std::string> takenFiles(const Collected& collected) {
    std::map<std::string, std::string> files;
    for (const StagedFile& file : collected.stage.files)
        if (file.origin == "submission")
            files[file.name] = file.content;
    for (const Diagnostic& each : collected.unreadable)
        if (each.line == 0)
            files.erase(each.file);  // nothing was read of it
    return files;
}

Standing standingFrom(const std::string& entrant, const Json& document) {
    Standing standing{entrant, document.at("status"), "", 0, 0, nullptr, "", false};
    if (standing.status == "refused") {
        standing.sentence = document.at("sentence");
    } else {
        standing.points = document.at("points");
        standing.maxPoints = document.at("max_points");
        standing.result = essenceOf(document);
    }
    return standing;
}

}  // namespace

Batch::Batch(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
             const Ledger& ledger, Terms terms)
    : grader_(grader),
      sandbox_(sandbox),
      manifest_(manifest),
      ledger_(ledger),
      terms_(std::move(terms)),
      known_(knownAssignments(grader.tools().root)) {
    if (terms_.stable)
        terms_.rules.deciding += "stable\n";
}

Crew::Done Batch::run(const std::vector<Entrant>& entrants, int jobs, bool fresh,
                      const std::atomic<bool>& stop,
                      const std::function<void(const Standing&)>& tell) const {
    std::vector<std::size_t> order(entrants.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<std::uintmax_t> sizes;
    for (const Entrant& each : entrants)
        sizes.push_back(sizeOf(each));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });

    const Crew crew{jobs, kAttempts * terms_.longestSeconds +
                              std::max(kLeastGraceSeconds, terms_.longestSeconds / 10)};
    Crew::Done done = crew.run(
        entrants.size(), [&](std::size_t k) { return standingOf(entrants[order[k]], fresh); },
        [&](std::size_t k) {
            return faultOf(entrants[order[k]].name,
                           "grading it has hung in the grader itself, and was given up");
        },
        stop, tell);
    std::vector<std::optional<Standing>> inOrder(entrants.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        inOrder[order[k]] = std::move(done.standings[k]);
    done.standings = std::move(inOrder);
    return done;
}

Standing Batch::standingOf(const Entrant& entrant, bool fresh) const {
    std::string fault;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const TimeBox box(terms_.longestSeconds);
        try {
            requireThere(entrant);
            const Key key = keyOf(terms_.rules, grader_.tools().root, manifest_, entrant, known_);
            if (!fresh)
                if (auto standing = known(entrant, key))
                    return std::move(*standing);
            ledger_.begin(entrant.name);
            Standing standing = gradeOnce(entrant, key);
            if (!standing.graderFailed())
                return standing;
            fault = "see the checks that are grader_error in its report";
        } catch (const std::exception& error) {
            fault = error.what();
        }
    }
    return faultOf(entrant.name, fault);
}

/// What is known already; marked again where only points and words have changed since.
std::optional<Standing> Batch::known(const Entrant& entrant, const Key& key) const {
    auto found = ledger_.known(entrant.name, key);
    if (!found)
        return std::nullopt;
    try {
        if (found->wording != key.wording) {
            found->result = markAgain(entrant.name, std::move(found->result));
            ledger_.keep(entrant.name, key, found->result.dump(2) + "\n");
        }
        Standing standing = standingFrom(entrant.name, found->result);
        standing.fromBefore = true;
        standing.unstable = ledger_.record(entrant.name).value("unstable", "");
        return standing;
    } catch (const std::exception&) {
        return std::nullopt;  // something of it, or one of its pictures, is not there any more
    }
}

Standing Batch::gradeOnce(const Entrant& entrant, const Key& key) const {
    const Job unpacking;
    const Unpacked unpacked = layOut(grader_.tools(), sandbox_, unpacking, entrant, known_);
    if (!unpacked.refusal.empty()) {
        const char* what = entrant.kind == EntrantKind::clone     ? "repository"
                           : entrant.kind == EntrantKind::archive ? "archive"
                                                                  : "submission";
        Json document = {
            {"format", 1},
            {"assignment", manifest_.id},
            {"status", "refused"},
            {"sentence", fmt::format("the {} is refused: {}", what, unpacked.refusal)}};
        ledger_.keep(entrant.name, key, document.dump(2) + "\n");
        return standingFrom(entrant.name, document);
    }
    const Submission submission = submissionIn(unpacked.folder, known_);
    std::vector<AssignmentResult> results;  // braces would copy all its pictures
    results.push_back(grader_.grade(manifest_, submission, terms_.seed));
    if (!unpacked.notice.empty())
        results.front().notices.push_back(unpacked.notice);
    const std::string unstable = terms_.stable ? repeated(submission, results.front()) : "";
    TimeBox::check();  // what was cut off must not look like the submission's doing
    writeReports(results, entrant.name);
    ledger_.keepPrint(printOf(entrant.name, submission));
    ledger_.keepSubmission(entrant.name,
                           takenFiles(collect(grader_.tools().root, manifest_, submission)),
                           manifest_.id);
    ledger_.keepRecord(entrant.name, {{"assignment", manifest_.id},
                                      {"seed", terms_.seed},
                                      {"unstable", unstable},
                                      {"hints", hintsOf(manifest_)}});
    const std::string document = toJson(results.front());
    ledger_.keep(entrant.name, results.front().graderFailed() ? std::nullopt : std::optional(key),
                 document);
    Standing standing = standingFrom(entrant.name, Json::parse(document));
    standing.unstable = unstable;
    return standing;
}

/// How two more gradings differ from the first.
std::string Batch::repeated(const Submission& submission, const AssignmentResult& first) const {
    const Json then = Json::parse(toJson(first));
    for (int time = 2; time <= 3; ++time) {
        const auto differences = differencesOf(
            then, Json::parse(toJson(grader_.grade(manifest_, submission, terms_.seed))));
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
    const Stage stage = collect(root, manifest_, submission).stage;
    Fingerprints starter;
    for (const auto& [name, begun] : handedIn(manifest_)) {
        starter = joined(starter, fingerprintsOf(readFile(begun)));
        const StagedFile* file = stage.find(name);
        if (file->origin != "submission")
            continue;
        words += wordsOf(file->content) + "\n";
        print.own = joined(print.own, fingerprintsOf(file->content));
    }
    print.own = without(print.own, starter);
    print.exact = sha256(words);
    return print;
}

/// With a secret seed the instructor has a report and a document of their own, with all pictures.
void Batch::writeReports(std::vector<AssignmentResult>& results, const std::string& entrant) const {
    const fs::path report = ledger_.folderOf(entrant) / "report",
                   full = ledger_.instructorFolderOf(entrant) / "report";
    if (terms_.seed == kPublishedSeed) {
        writeReportPictures(results, report);
    } else {
        writeReportPictures(results, full);
        writeFile(full / "index.html", htmlReport(results, full));
        ledger_.keepInstructorsResult(entrant, toJson(results.front()));
        copyPictures(results, grader_.publicFrames(manifest_, terms_.seed), full, report);
    }
    writeFile(ledger_.folderOf(entrant) / "report.txt", terminalReport(results.front(), {}));
    writeFile(report / "index.html", htmlReport(results, report));
}

/// The same results counted by the manifest of today, and their reports. The pictures stay.
Json Batch::markAgain(const std::string& entrant, Json document) const {
    if (document.at("status") == "refused")
        return document;
    Json record = ledger_.record(entrant);
    const auto hints = record.at("hints").get<std::map<std::string, std::string>>();
    const auto again = [&](const Json& kept, const fs::path& report) {
        AssignmentResult result = resultFrom(kept);
        remark(result, manifest_, hints);
        writeFile(report / "index.html", htmlReport({result}, report));
        return result;
    };
    if (const auto full = ledger_.instructorsResult(entrant))
        ledger_.keepInstructorsResult(
            entrant, toJson(again(*full, ledger_.instructorFolderOf(entrant) / "report")));
    const AssignmentResult result = again(document, ledger_.folderOf(entrant) / "report");
    writeFile(ledger_.folderOf(entrant) / "report.txt", terminalReport(result, {}));
    const std::string text = toJson(result);
    ledger_.keep(entrant, std::nullopt, text);
    // Only now: while a text still has the hints of then, they must be known.
    record["hints"] = hintsOf(manifest_);
    ledger_.keepRecord(entrant, record);
    return Json::parse(text);
}

}  // namespace grader
