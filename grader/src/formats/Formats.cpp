#include "formats/Formats.h"

#include <cmath>

#include "report/Html.h"

namespace grader {

namespace {

/// Calls `take` with each check and its task.
template <class Take>
void forEachCheck(const Json& result, Take&& take) {
    if (!result.contains("tasks"))
        return;
    for (const Json& task : result.at("tasks"))
        for (const Json& check : task.at("checks"))
            take(task, check);
}

std::string textOf(const Json& json, const char* name) {
    return json.value(name, "");
}

bool isFull(const Json& check) {
    return check.at("status") == "pass";
}

/// "Turn: rotation by no angle", which names the task, too.
std::string nameOf(const Json& task, const Json& check) {
    return textOf(task, "title") + ": " + textOf(check, "title");
}

/// What went wrong before any check could be made.
std::vector<std::string> linesOfBuild(const Json& result) {
    std::vector<std::string> lines;
    if (!result.contains("build"))
        return lines;
    for (const Json& each : result.at("build").at("diagnostics"))
        if (each.at("severity") == "error")
            lines.push_back(fmt::format("{}:{}: {}", textOf(each, "file"),
                                        each.at("line").get<int>(), textOf(each, "message")));
    return lines;
}

/// Remarks, then the compiler's errors.
std::string messageOf(const Scored& scored) {
    std::vector<std::string> lines = scored.remarks;
    for (std::string& each : linesOfBuild(scored.result))
        lines.push_back(std::move(each));
    return fmt::format("{}", fmt::join(lines, "\n"));
}

/// The hint belongs to what is wrong with a check, not to one that is not begun.
std::string outputOf(const Json& check) {
    const std::string message = textOf(check, "message"), hint = textOf(check, "hint");
    return message.empty() || hint.empty() ? message : message + "\nHint: " + hint;
}

std::string dumped(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string gradescopeResult(const Scored& scored) {
    Json tests = Json::array();
    forEachCheck(scored.result, [&](const Json& task, const Json& check) {
        tests.push_back({{"name", nameOf(task, check)},
                         {"number", textOf(check, "id")},
                         {"score", check.at("points")},
                         {"max_score", check.at("max_points")},
                         {"status", isFull(check) ? "passed" : "failed"},
                         {"output", outputOf(check)},
                         {"output_format", "text"},
                         {"visibility", "visible"}});
    });
    return dumped({{"score", scored.points},
                   {"output", messageOf(scored)},
                   {"output_format", "text"},
                   {"visibility", "visible"},
                   {"stdout_visibility", "hidden"},
                   {"tests", tests}});
}

std::string prairieLearnResult(const Scored& scored) {
    constexpr std::size_t kMostBytes = 1000 * 1000;
    Json document = {{"gradable", true},
                     {"score", scored.maxPoints > 0 ? scored.points / scored.maxPoints : 0.0},
                     {"message", messageOf(scored)},
                     {"tests", Json::array()},
                     {"images", Json::array()}};
    forEachCheck(scored.result, [&](const Json& task, const Json& check) {
        document["tests"].push_back({{"name", nameOf(task, check)},
                                     {"points", check.at("points")},
                                     {"max_points", check.at("max_points")},
                                     {"message", textOf(check, "message")},
                                     {"output", textOf(check, "hint")}});
    });
    std::size_t bytes = document.dump(2).size();
    forEachCheck(scored.result, [&](const Json&, const Json& check) {
        if (isFull(check) || !check.contains("images") || scored.report.empty())
            return;
        const Json image = {
            {"label", textOf(check, "title")},
            {"url", "data:image/png;base64," +
                        base64(readFile(scored.report /
                                        check.at("images").at("submission").get<std::string>()))}};
        bytes += image.dump(2).size() + 100;
        if (bytes < kMostBytes)
            document["images"].push_back(image);
    });
    return dumped(document);
}

std::string classroom50Result(const Scored& scored, const Classroom& classroom) {
    const auto whole = [](double points) { return static_cast<int>(std::lround(points)); };
    Json tests = Json::array();
    forEachCheck(scored.result, [&](const Json& task, const Json& check) {
        tests.push_back({{"test-name", nameOf(task, check)},
                         {"passed", isFull(check)},
                         {"score", whole(check.at("points"))},
                         {"max-score", whole(check.at("max_points"))}});
    });
    return dumped({{"schema", "classroom50/result/v1"},
                   {"classroom", classroom.name},
                   {"assignment", textOf(scored.result, "assignment")},
                   {"assignment_type", "individual"},
                   {"owner", scored.student},
                   {"submission", ""},
                   {"commit", ""},
                   {"release", ""},
                   {"review", ""},
                   {"datetime", classroom.datetime},
                   {"score", whole(scored.points)},
                   {"max-score", whole(scored.maxPoints)},
                   {"tests", tests}});
}

std::string autolabLine(const Scored& scored) {
    return Json{{"scores", scored.tasks}}.dump() + "\n";
}

std::string junitXml(const std::string& name, const std::vector<Scored>& all) {
    std::string suites;
    std::size_t allTests = 0, allFailures = 0;
    for (const Scored& scored : all) {
        std::string cases;
        std::size_t tests = 0, failures = 0;
        const auto add = [&](const std::string& about, const std::string& message,
                             const std::string& output, bool full) {
            ++tests;
            failures += !full;
            cases += fmt::format("    <testcase {}{}", about, full ? "/>\n" : ">");
            if (!full)
                cases += fmt::format("<failure message=\"{}\">{}</failure></testcase>\n",
                                     escaped(message), escaped(output));
        };
        for (const std::string& line : linesOfBuild(scored.result))
            add("name=\"build\" classname=\"build\"", line, line, false);
        forEachCheck(scored.result, [&](const Json& task, const Json& check) {
            add(fmt::format("name=\"{}\" classname=\"{}\"", escaped(textOf(check, "id")),
                            escaped(textOf(task, "id"))),
                textOf(check, "message"), outputOf(check), isFull(check));
        });
        suites += fmt::format(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n"
            "{}  </testsuite>\n",
            escaped(scored.student), tests, failures, cases);
        allTests += tests;
        allFailures += failures;
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" "
        "failures=\"{}\">\n{}</testsuites>\n",
        escaped(name), allTests, allFailures, suites);
}

}  // namespace grader
