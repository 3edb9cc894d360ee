#include "subject/JudgeMain.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "subject/Evidence.h"
#include "subject/Judge.h"

/// A test program's main: runs the checks and writes what became of each, as
/// {"checks": [{"suite", "name", "title", "hint", "hidden", "todos", "status", "message",
/// "comparison", "evidence": [{"key", "outcome", "type", "numbers"}]}]}.

namespace judge {

namespace {

struct CurrentCheck {
    std::string title, hint;
    std::vector<std::string> sentences;  ///< of failed expectations
    std::optional<Verdict> verdict;      ///< set when the subject gave no value
    std::vector<std::string> todos;
    nlohmann::json comparison;       ///< null until something compared was wrong
    std::vector<Evidence> evidence;  ///< what the subject answered
    std::optional<Random> random;
};

CurrentCheck current;
std::unique_ptr<Subject> theSubject;
std::uint64_t seed = 1;

nlohmann::json jsonOf(const Evidence& evidence) {
    return {{"key", evidence.key},
            {"outcome", evidence.outcome},
            {"type", evidence.type},
            {"numbers", evidence.numbers}};
}

Verdict verdictOf(const testing::TestResult& result) {
    if (result.Skipped())
        return {Status::skipped, ""};
    if (result.Passed())
        return {Status::pass, ""};
    if (current.verdict)
        return *current.verdict;
    if (!current.sentences.empty())
        return {Status::fail, current.sentences.front()};
    // An exception or a plain GoogleTest assertion of the test itself.
    return {Status::graderError, result.GetTestPartResult(0).summary()};
}

class CheckListener : public testing::EmptyTestEventListener {
public:
    void OnTestStart(const testing::TestInfo& info) override {
        current = {};
        current.title = info.name();
        current.random.emplace(seed ^ hashOf(std::string(info.test_suite_name()) + info.name()));
    }
    void OnTestEnd(const testing::TestInfo& info) override {
        const Verdict verdict = verdictOf(*info.result());
        checks.push_back({{"suite", info.test_suite_name()},
                          {"name", info.name()},
                          {"title", current.title},
                          {"hint", current.hint},
                          {"hidden", isHidden(info)},
                          {"todos", current.todos},
                          {"status", toString(verdict.status)},
                          {"message", verdict.message},
                          {"comparison", current.comparison},
                          {"evidence", nlohmann::json::array()}});
        for (const Evidence& each : current.evidence)
            checks.back()["evidence"].push_back(jsonOf(each));
    }
    nlohmann::json checks = nlohmann::json::array();

private:
    static bool isHidden(const testing::TestInfo& info) {
        return std::string(info.file()).find("/hidden_tests/") != std::string::npos;
    }
};

}  // namespace

void check(const std::string& title, const std::string& hint) {
    current.title = title;
    current.hint = hint;
}

Subject& subject() {
    return *theSubject;
}
Random& random() {
    return *current.random;
}

void fail(const std::string& sentence) {
    current.sentences.push_back(sentence);
    ADD_FAILURE() << sentence;
}

void failAndLeave(const std::string& sentence) {
    const Verdict why{Status::fail, sentence};
    current.verdict = why;
    throw SubjectFailure(why);
}

void needCount(const std::string& what, std::size_t got, std::size_t asked) {
    if (got != asked)
        failAndLeave(fmt::format("{}: {} values were asked for, {} came", what, asked, got));
}

void observed(const std::string& type, std::vector<double> numbers) {
    if (current.evidence.empty())
        throw std::logic_error("observed() comes after a request");
    current.evidence.back().type = type;
    current.evidence.back().numbers = std::move(numbers);
}

void detail::compared(const std::string& what, std::vector<std::vector<double>> expected,
                      std::vector<std::vector<double>> got, double tolerance) {
    if (!current.comparison.is_null() || expected.empty())
        return;
    current.comparison = {
        {"what", what}, {"expected", expected}, {"got", got}, {"tolerance", tolerance}};
}

/// Lets the current check know what its requests ran into.
static void listenTo(Subject& each) {
    each.onTodos = [](const std::vector<std::string>& ids) {
        current.todos.insert(current.todos.end(), ids.begin(), ids.end());
    };
    each.onFailure = [](const Verdict& verdict) { current.verdict = verdict; };
    each.onAnswer = [](const protocol::Request& request, const protocol::Answer& answer) {
        current.evidence.push_back(evidenceOf(request, answer));
    };
}

/// Takes GoogleTest's variables out of the environment: a filter that somebody has set would leave
/// checks out, and nobody would see it.
static void clearVariablesOfGoogleTest() {
    std::vector<std::string> names;
    for (char** each = environ; *each; ++each)
        if (const std::string variable = *each; variable.rfind("GTEST_", 0) == 0)
            names.push_back(variable.substr(0, variable.find('=')));
    for (const std::string& name : names)
        unsetenv(name.c_str());
}

}  // namespace judge

int main(int argc, char** argv) {
    judge::clearVariablesOfGoogleTest();
    testing::InitGoogleTest(&argc, argv);
    CLI::App app("Runs the checks of one assignment in the judge. Started by the grader.");
    std::string resultPath, seedFile;
    std::uint32_t callMs = 2000, outputKib = 64;
    double patience = std::numeric_limits<double>::infinity();
    std::vector<std::string> runnerCommand;
    judge::KernelLimits limits;
    app.add_option("--result", resultPath, "write the outcome of each check to this file");
    app.add_option("--seed-file", seedFile, "holds the seed of random inputs; default 1");
    app.add_option("--call-ms", callMs, "time limit of one call, milliseconds");
    app.add_option("--patience", patience, "time for all calls together, seconds; default no end");
    app.add_option("--output-kib", outputKib, "what one call may print, KiB");
    app.add_option("--cgroup", limits.cgroup, "folder of the cgroup that the runner enters");
    app.add_option("--memory-mib", limits.memoryMib,
                   "what is said when memory runs out there, MiB");
    app.add_option("--processes", limits.processes, "what is said when processes do");
    app.add_option("command", runnerCommand, "after --: the command that starts the runner");
    CLI11_PARSE(app, argc, argv);
    if (!seedFile.empty() && !(std::ifstream(seedFile) >> judge::seed)) {
        std::cerr << seedFile << ": expected a seed\n";
        return 2;
    }

    judge::theSubject = judge::makeSubject(runnerCommand, limits);
    judge::listenTo(judge::subject());
    judge::subject().callTimeoutMs = callMs;
    judge::subject().patienceSeconds = patience;
    judge::subject().outputBytes = outputKib * 1024;

    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    auto* listener = new judge::CheckListener;  // owned by GoogleTest
    listeners.Append(listener);
    if (!resultPath.empty())
        delete listeners.Release(listeners.default_result_printer());
    const int failed = RUN_ALL_TESTS();
    if (testing::UnitTest::GetInstance()->test_to_run_count() == 0) {
        std::cerr << "no test matches the filter\n";
        return 2;
    }
    if (!resultPath.empty()) {
        std::ofstream file(resultPath);
        // A student's exception may say anything; what is not UTF-8 is replaced.
        file << nlohmann::json{{"checks", listener->checks}}.dump(
            -1, ' ', false, nlohmann::json::error_handler_t::replace);
        if (!file.flush()) {
            std::cerr << "cannot write " << resultPath << "\n";
            return 2;
        }
    }
    return failed;
}
