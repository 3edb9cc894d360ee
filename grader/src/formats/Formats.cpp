#include "formats/Formats.h"

#include <cmath>

#include "report/Html.h"
#include "report/PlainText.h"

namespace grader {

namespace {

constexpr std::size_t kMostBytes = 1000 * 1000;  // PrairieLearn's limit; Gradescope names none
constexpr std::size_t kMostColumns = 2000;       // of one text
constexpr std::size_t kMostErrors = 20;

/// Calls `take` with each check and its task; not with those that wait for a person.
template <class Take>
void forEachCheck(const Json& result, Take&& take) {
    if (!result.contains("tasks"))
        return;
    for (const Json& task : result.at("tasks"))
        for (const Json& check : task.at("checks"))
            if (check.at("status") != "pending")
                take(task, check);
}

std::string textOf(const Json& json, const char* name) {
    return shortened(json.value(name, ""), kMostColumns);
}

bool isFull(const Json& check) {
    return check.at("status") == "pass";
}

std::string visibilityOf(const Json& check) {
    return check.value("visibility", kVisible);
}

/// The same for a platform that shows whatever it is given. Returns how many checks were left out.
template <class Take>
std::size_t forEachShownCheck(const Json& result, Take&& take) {
    std::size_t others = 0;
    forEachCheck(result, [&](const Json& task, const Json& check) {
        if (visibilityOf(check) == kVisible)
            take(task, check);
        else
            ++others;
    });
    return others;
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
            lines.push_back(
                each.at("line") == 0
                    ? fmt::format("{}: {}", textOf(each, "file"), textOf(each, "message"))
                    : fmt::format("{}:{}: {}", textOf(each, "file"), each.at("line").get<int>(),
                                  textOf(each, "message")));
    if (lines.size() > kMostErrors) {
        const std::size_t more = lines.size() - kMostErrors;
        lines.resize(kMostErrors);
        lines.push_back(fmt::format("and {} more errors; mend the first one first", more));
    }
    return lines;
}

/// Remarks, the compiler's errors, what the reader should know, and what held the code.
std::string messageOf(const Scored& scored) {
    std::vector<std::string> lines = scored.remarks;
    for (std::string& each : linesOfBuild(scored.result))
        lines.push_back(std::move(each));
    for (const Json& each : scored.result.value("notices", Json::array()))
        lines.push_back(shortened(each.get<std::string>(), kMostColumns));
    const auto ignored = scored.result.value("ignored_files", std::vector<std::string>());
    if (!ignored.empty())
        lines.push_back(
            shortened(fmt::format("Not taken: {}", fmt::join(ignored, ", ")), kMostColumns));
    if (scored.result.contains("environment"))
        lines.push_back("Sandbox: " + textOf(scored.result.at("environment"), "sandbox"));
    return fmt::format("{}", fmt::join(lines, "\n"));
}

/// The known mistake that explains what a task lost is told once: at its first lost check, of those
/// that students see if there is one.
std::string mistakeTold(const Json& task, const Json& check) {
    if (!task.contains("recognised"))
        return "";
    const Json* first = nullptr;
    for (const Json& each : task.at("checks"))
        if (!isFull(each) &&
            (!first || (visibilityOf(*first) != kVisible && visibilityOf(each) == kVisible)))
            first = &each;
    if (first != &check)
        return "";
    const Json& known = task.at("recognised");
    const std::string section = textOf(known, "section");
    return textOf(known, "says") + (section.empty() ? "" : fmt::format(" (section {})", section));
}

/// The hint belongs to what is wrong with a check, not to one that is not begun.
std::string outputOf(const Json& task, const Json& check) {
    std::vector<std::string> lines;
    const std::string message = textOf(check, "message"), hint = textOf(check, "hint"),
                      mistake = mistakeTold(task, check);
    if (!message.empty())
        lines.push_back(message);
    if (!mistake.empty())
        lines.push_back(mistake);
    if (!message.empty() && !hint.empty())
        lines.push_back("Hint: " + hint);
    return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string dumped(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Texts are cut further where all of them together are too long, which takes odd letters in most.
void makeFit(Json& document) {
    constexpr std::size_t kFewColumns = 200;
    if (dumped(document).size() < kMostBytes)
        return;
    for (const char* name : {"output", "message"}) {
        if (document.contains(name))
            document[name] = shortened(document[name], kMostColumns);
        for (Json& test : document["tests"])
            if (test.contains(name))
                test[name] = shortened(test[name], kFewColumns);
    }
}

/// The pictures of a lost frame, as far as a document has room for them.
class Pictures {
public:
    Pictures(const Scored& scored, const Json& document)
        : report_(scored.report), bytes_(dumped(document).size()) {}

    /// Label → data URL: the student's picture, and beside it the right one where there is one.
    std::vector<std::pair<std::string, std::string>> of(const Json& check) {
        std::vector<std::pair<std::string, std::string>> all;
        if (isFull(check) || !check.contains("images") || report_.empty())
            return all;
        for (const auto& [name, label] :
             {std::pair("submission", "yours"), std::pair("reference", "right")})
            if (check.at("images").contains(name))
                add(all, label, check.at("images").at(name).get<std::string>());
        return all;
    }

private:
    void add(std::vector<std::pair<std::string, std::string>>& all, const char* label,
             const std::string& file) {
        constexpr std::size_t kAround = 200;  // quotes, labels, white space
        const std::string url = "data:image/png;base64," + base64(readFile(report_ / file));
        if (bytes_ + url.size() + kAround > kMostBytes)
            return;
        bytes_ += url.size() + kAround;
        all.emplace_back(label, url);
    }

    const fs::path report_;
    std::size_t bytes_;
};

/// Lines of text as HTML.
std::string paragraphs(const std::string& text) {
    std::string html = "<p>";
    for (const char each : escaped(text))
        html += each == '\n' ? "</p><p>" : std::string(1, each);
    return html + "</p>";
}

constexpr const char* kNotYours =
    "Your submission was not graded: the grader failed. That is not your mistake, and there is no "
    "mark. Hand it in again later; if that does not help, tell your instructor, who sees the "
    "reason.";

}  // namespace

std::string gradescopeResult(const Scored& scored) {
    Json document = {{"score", scored.points},       {"output", messageOf(scored)},
                     {"output_format", "text"},      {"visibility", kVisible},
                     {"stdout_visibility", kHidden}, {"tests", Json::array()}};
    forEachCheck(scored.result, [&](const Json& task, const Json& check) {
        document["tests"].push_back({{"name", nameOf(task, check)},
                                     {"number", textOf(check, "id")},
                                     {"score", check.at("points")},
                                     {"max_score", check.at("max_points")},
                                     {"status", isFull(check) ? "passed" : "failed"},
                                     {"output", outputOf(task, check)},
                                     {"output_format", "text"},
                                     {"visibility", visibilityOf(check)}});
    });
    makeFit(document);
    Pictures pictures(scored, document);
    std::size_t at = 0;
    forEachCheck(scored.result, [&](const Json&, const Json& check) {
        Json& test = document["tests"][at++];
        std::string html;
        for (const auto& [label, url] : pictures.of(check))
            html += fmt::format(
                "<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>", label,
                url);
        if (html.empty())
            return;
        test["output"] = paragraphs(test["output"]) + html;
        test["output_format"] = "html";
    });
    return dumped(document);
}

std::string gradescopeFault() {
    return dumped({{"output", kNotYours},
                   {"output_format", "text"},
                   {"visibility", kVisible},
                   {"stdout_visibility", kHidden},
                   {"tests", Json::array()}});
}

std::string prairieLearnResult(const Scored& scored) {
    Json document = {{"gradable", true},
                     {"score", scored.maxPoints > 0 ? scored.points / scored.maxPoints : 0.0},
                     {"message", messageOf(scored)},
                     {"tests", Json::array()}};
    const auto errors = linesOfBuild(scored.result);
    if (!errors.empty() && scored.points <= 0) {
        document["gradable"] = false;
        document["format_errors"] = errors;
    }
    const std::size_t others =
        forEachShownCheck(scored.result, [&](const Json& task, const Json& check) {
            document["tests"].push_back({{"name", nameOf(task, check)},
                                         {"points", check.at("points")},
                                         {"max_points", check.at("max_points")},
                                         {"message", outputOf(task, check)}});
        });
    if (others > 0)
        document["message"] = fmt::format("{}\nChecks that are not shown: {}",
                                          document["message"].get<std::string>(), others);
    makeFit(document);
    Pictures pictures(scored, document);
    std::size_t at = 0;
    forEachShownCheck(scored.result, [&](const Json&, const Json& check) {
        Json& test = document["tests"][at++];
        for (const auto& [label, url] : pictures.of(check))
            test["images"].push_back({{"label", label}, {"url", url}});
    });
    return dumped(document);
}

std::string prairieLearnFault() {
    return dumped({{"gradable", false}, {"message", kNotYours}, {"format_errors", kNotYours}});
}

std::string classroom50Result(const Scored& scored, const Classroom& classroom) {
    const auto whole = [](double points) { return static_cast<int>(std::lround(points)); };
    Json tests = Json::array();
    forEachShownCheck(scored.result, [&](const Json& task, const Json& check) {
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

std::string autolabFault() {
    return fmt::format("{}\n", kNotYours);
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
                textOf(check, "message"), outputOf(task, check), isFull(check));
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
