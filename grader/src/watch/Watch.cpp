// Theory of operation
//
// Two processes. The watcher, which has one thread, waits in poll() for whatever comes first:
//
//   FileWatch        a folder with a student's file has changed
//   GradingProcess   the grading under way has something to say, or has ended
//   Keys             a key was pressed (on a terminal only)
//   signals          Ctrl-C, Ctrl-Z, the end of the terminal
//
// Each grading is a process of its own, a copy of the watcher as it is then, with the toolchain,
// the sandbox and the references in memory. It tells its verdict as soon as there is one, writes
// the page after that if it is wanted, and ends. A save makes it worthless, so it is killed with
// everything that it has started, and the next one begins: however long a student's endless loop
// still had, nobody waits for it. So that a file which is written all the time gets verdicts, too,
// the sixth in a row is left to finish.
//
// Events only wake. What decides is the contents of the files: they are compared with those that
// the last grading began with, once there has been silence for a moment (kQuiet). A file that is
// gone or empty for a moment gets a little longer (kPatience). So neither a touch nor a save of
// the same text grades anything, and whatever happens meanwhile, the last state is graded. Only
// what is written while a grading is under way counts whatever it says: that grading may have read
// the file half written, though before and after it is the same.

#include "watch/Watch.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>
#include <memory>

#include "Browser.h"
#include "ExitCode.h"
#include "Grade.h"
#include "report/LiveReport.h"
#include "report/TerminalReport.h"
#include "watch/GradingProcess.h"
#include "watch/Keys.h"
#include "watch/Signals.h"
#include "watch/WatchText.h"
#include "watch/Watched.h"

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kQuiet{15};
constexpr milliseconds kPatience{400};       // with a file that is empty or gone
constexpr milliseconds kMostPatience{1000};  // with events that do not end
constexpr milliseconds kLookAround{1000};    // where the system does not tell of every change
constexpr int kMostAbandoned = 5;

constexpr const char* kKeysLine = "h hint  n next task  r whole report  o open in browser  q quit";

std::string timeOfDay() {
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%H:%M:%S", std::localtime(&now));
    return text;
}

class Watcher {
public:
    Watcher(const Toolchain& tools, const Sandbox& sandbox, const WatchOptions& options)
        : options_(options),
          grader_(tools, sandbox, options.renderer),
          watched_(watchedOf(tools.root, options.submission, options.assignments)),
          files_(filesOf(watched_)),
          pageWanted_(options.writePage || options.openPage),
          toOpen_(options.openPage) {}

    int run() {
        greet();
        while (!leaving_) {
            startNext();
            waitForSomething();
            if (pendingSince_ && isQuiet())
                lookAtFiles();
        }
        grading_.reset();
        if (pageOf_)
            endLiveReport(options_.report);
        clearStatus();
        return exitCode();
    }

private:
    // ---- what is said ----

    void say(const std::string& text) {
        clearStatus();
        std::cout << text << std::flush;
    }
    /// One line that is gone with the next; on a terminal only.
    void showStatus(const std::string& text) {
        if (!keys_.available() || text == status_)
            return;
        clearStatus();
        std::cout << text << std::flush;
        status_ = text;
    }
    void clearStatus() {
        if (!status_.empty())
            std::cout << "\r\033[K" << std::flush;
        status_.clear();
    }

    void greet() {
        TerminalWriter out(options_.style);
        for (const Watched& each : watched_)
            out.paragraph(fmt::format("Watching {}: ", each.manifest.id),
                          fmt::format("{}", fmt::join(each.names, ", ")));
        out.paragraph("", keys_.available() ? "Save a file to grade it again."
                                            : "Save a file to grade it again. Ctrl-C ends this.");
        say(out.take() + "\n");
    }

    // ---- grading ----

    void startNext() {
        if (grading_ || pendingSince_)
            return;
        const auto isDue = [](const Watched& each) { return each.due; };
        auto next = watched_.begin() + long(current_);
        if (!next->due)
            next = std::find_if(watched_.begin(), watched_.end(), isDue);
        if (next == watched_.end())
            return becomeIdle();
        start(*next);
    }

    void start(Watched& one) {
        one.due = false;
        runningIsNews_ = std::exchange(one.saved, false);
        one.graded = contentsOf(one.files);
        running_ = &one;
        mayHaveReadHalf_ = false;
        // While several are graded for the first time, nobody knows yet which one to show.
        const bool page =
            pageWanted_ && &one == &watched_[current_] && (started_ || watched_.size() == 1);
        showStatus("… grading " + one.manifest.id);
        grading_ = std::make_unique<GradingProcess>([&](const GradingProcess::Tell& tell) {
            std::vector<AssignmentResult> results;
            results.push_back(grader_.grade(one.manifest, options_.submission, kPublishedSeed));
            tell({{"result", Json::parse(toJson(results))},
                  {"report", terminalReport(results[0], options_.style)}});
            if (page)
                tell({{"page", fs::absolute(writeLiveReport(results, options_.report)).string()}});
        });
    }

    /// Everything is graded: time to look ahead.
    void becomeIdle() {
        if (!std::exchange(started_, true)) {
            current_ = firstUnfinished();
            if (pageWanted_ && pageOf_ != current_)
                return requestPage();
        }
        // What the first grading decoded and left in the cache is taken into memory now, while
        // nobody waits.
        for (Watched& each : watched_)
            if (!std::exchange(each.warm, true) && !each.result.is_null()) {
                grader_.rules(each.manifest, kPublishedSeed);
                grader_.signatures(each.manifest);
            }
        showStatus(kKeysLine);
    }

    std::size_t firstUnfinished() const {
        for (std::size_t i = 0; i < watched_.size(); ++i)
            if (!watched_[i].isFull())
                return i;
        return 0;
    }

    /// The page needs pictures, and those are gone with the grading that drew them.
    void requestPage() {
        pageWanted_ = true;
        watched_[current_].due = true;
    }

    void hear() {
        for (const Json& message : grading_->take())
            if (message.contains("result"))
                takeVerdict(*running_, message);
            else
                takePage(message.at("page"));
        if (!grading_->ended())
            return;
        running_->faulty = !grading_->failure().empty();
        if (running_->faulty)
            say(fmt::format("grade: {}: {}\n", running_->manifest.id, grading_->failure()));
        grading_.reset();
        abandoned_ = 0;
    }

    void takeVerdict(Watched& one, const Json& message) {
        const bool isFirst = one.result.is_null();
        const bool compiledBefore = isFirst || !doesNotCompile(one.result);
        one.result = message.at("result");
        one.report = message.at("report");
        const auto changes = one.baseline.take(one.result);
        abandoned_ = 0;
        if (isFirst)
            return say(one.report + "\n");
        // Graded again for a file of an earlier assignment, or for the page: only news count.
        if (!runningIsNews_ && changes.empty() && compiledBefore == !doesNotCompile(one.result))
            return;
        say(fmt::format("{}\n{}\n", timeOfDay(),
                        verdictText(one.result, changes, one.baseline, options_.style)));
    }

    void takePage(const std::string& page) {
        if (!pageOf_)
            say("Report: " + page + "\n");
        pageOf_ = static_cast<std::size_t>(running_ - watched_.data());
        if (std::exchange(toOpen_, false) && !openInBrowser(page))
            say("No browser could be opened (xdg-open). Open that file yourself.\n");
    }

    // ---- files ----

    bool isQuiet() const {
        const auto now = Clock::now();
        return now - lastEvent_ >= (unfinished_ ? kPatience : kQuiet) ||
               now - *pendingSince_ >= kMostPatience;
    }

    void lookAtFiles() {
        const bool patient =
            Clock::now() - lastEvent_ < kPatience && Clock::now() - *pendingSince_ < kMostPatience;
        bool waits = false;
        std::vector<Watched*> changed;
        std::vector<std::size_t> saved;
        for (std::size_t i = 0; i < watched_.size(); ++i) {
            Watched& one = watched_[i];
            const Contents now = contentsOf(one.files);
            if (now == one.graded && !(mayHaveReadHalf_ && &one == running_))
                continue;
            waits = waits || (patient && looksUnfinished(one.graded, now));
            const bool own = one.changed(one.own, now), shared = one.changed(one.shared, now);
            one.saved = one.saved || own || (shared && one.isBegun());
            if (own || shared)
                saved.push_back(i);
            changed.push_back(&one);
        }
        if (!saved.empty())
            noteSaved(saved);
        unfinished_ = waits;
        if (waits)
            return;
        pendingSince_.reset();
        mayHaveReadHalf_ = false;
        for (Watched* one : changed) {
            one->due = true;
            if (one == running_ && grading_ && abandoned_ < kMostAbandoned) {
                grading_.reset();
                one->saved = one->saved || runningIsNews_;
                ++abandoned_;
            }
        }
    }

    /// The student works on one of those for which a saved file is handed in: on the same as before
    /// where it is among them.
    void noteSaved(const std::vector<std::size_t>& saved) {
        if (std::find(saved.begin(), saved.end(), current_) == saved.end())
            current_ = saved.front();
        watched_[current_].saved = true;
    }

    // ---- waiting ----

    int timeoutMs() const {
        if (pendingSince_) {
            const auto wait = unfinished_ ? kPatience : kQuiet;
            const auto left = lastEvent_ + wait - Clock::now();
            return std::max(1, int(std::chrono::ceil<milliseconds>(left).count()));
        }
        return fileWatch_.hearsEverything() && !isInBackground() ? -1 : int(kLookAround.count());
    }

    /// Nobody tells a job that runs already that it is in the foreground again.
    bool isInBackground() const { return keys_.available() && keys_.descriptor() < 0; }

    void waitForSomething() {
        pollfd all[] = {{fileWatch_.descriptor(), POLLIN, 0},
                        {grading_ ? grading_->descriptor() : -1, POLLIN, 0},
                        {keys_.descriptor(), POLLIN, 0},
                        {signals_.descriptor(), POLLIN, 0}};
        // With a grading under way there is no hurry to look at the files, but somebody must wait.
        const bool somethingIsDue = !grading_ && !pendingSince_ &&
                                    std::any_of(watched_.begin(), watched_.end(),
                                                [](const Watched& each) { return each.due; });
        const int ready = poll(all, std::size(all), somethingIsDue ? 0 : timeoutMs());
        if (isInBackground())
            keys_.resume();
        const auto has = [&](int which) { return ready > 0 && all[which].revents != 0; };
        if (has(0) && fileWatch_.takeEvents()) {
            noteChange();
            mayHaveReadHalf_ = mayHaveReadHalf_ || grading_;
        }
        if (ready == 0 && !somethingIsDue && !pendingSince_)
            noteChange();  // the system does not tell of every change
        if (has(1))
            hear();
        if (has(3))
            obey(signals_.take());
        if (has(2) && !leaving_)
            for (const char key : withoutEscapes(keys_.pressed()))
                press(key);
    }

    void noteChange() {
        lastEvent_ = Clock::now();
        unfinished_ = false;  // it may be complete now
        if (!pendingSince_)
            pendingSince_ = lastEvent_;
    }

    void obey(int signal) {
        if (signal == SIGCONT)
            return keys_.resume();
        if (signal != SIGTSTP) {
            leaving_ = leaving_ || signal != 0;
            return;
        }
        clearStatus();
        keys_.suspend();
        signals_.stop();
        keys_.resume();  // before the line that names the keys is drawn
    }

    // ---- keys ----

    /// An arrow key is Esc and more; none of it is meant as one of ours.
    static std::string withoutEscapes(const std::string& keys) {
        return keys.substr(0, keys.find('\033'));
    }

    void press(char key) {
        const Watched& one = watched_[current_];
        if (key == 'q' || key == '\004')
            leaving_ = true;
        else if (key == 'o')
            openPage();
        else if (std::string_view("hnr").find(key) == std::string_view::npos)
            return;
        else if (one.result.is_null())
            say("The first verdict is still to come.\n");
        else if (key == 'h')
            say(hintText(one.result, options_.style));
        else if (key == 'r')
            say(one.report + "\n");
        else
            tellNextTask(one);
    }

    void tellNextTask(const Watched& one) {
        if (doesNotCompile(one.result))  // no task can be told done from not done
            return say(hintText(one.result, options_.style));
        const Json* task = nextTask(one.result, toldTask_);
        if (!task)
            return say("  Every task is done.\n");
        toldTask_ = task->at("id");
        say(taskText(one.result, *task, placeOfRegion(options_.submission, one.manifest, toldTask_),
                     options_.style));
    }

    void openPage() {
        toOpen_ = true;
        requestPage();
    }

    int exitCode() const {
        bool full = true;
        for (const Watched& each : watched_) {
            if (each.faulty ||
                (!each.result.is_null() && each.result.at("status") == "grader_error"))
                return kGraderFailed;
            full = full && each.isFull();
        }
        return full ? kFullMarks : kSomethingLost;
    }

    const WatchOptions& options_;
    const Signals signals_;
    const Grader grader_;
    std::vector<Watched> watched_;
    const std::vector<fs::path> files_;
    FileWatch fileWatch_{files_};
    Keys keys_;

    std::size_t current_ = 0;     ///< the assignment that the student works on
    Watched* running_ = nullptr;  ///< whose grading is, or was last, under way
    std::unique_ptr<GradingProcess> grading_;
    int abandoned_ = 0;  ///< gradings in a row that were not left to finish

    std::optional<Clock::time_point> pendingSince_;  ///< since when the files may have changed
    Clock::time_point lastEvent_;
    bool unfinished_ = false;       ///< an editor seems to be in the middle of writing
    bool mayHaveReadHalf_ = false;  ///< something was written while running_ was graded

    bool pageWanted_, toOpen_;
    std::optional<std::size_t> pageOf_;  ///< the assignment that the page shows
    std::string toldTask_, status_;
    bool runningIsNews_ = false;  ///< a file of its own was saved before it began
    bool started_ = false;        ///< everything was graded once
    bool leaving_ = false;
};

}  // namespace

int watch(const Toolchain& tools, const Sandbox& sandbox, const WatchOptions& options) {
    return Watcher(tools, sandbox, options).run();
}

}  // namespace grader
