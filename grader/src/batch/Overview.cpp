#include "batch/Overview.h"

#include <cctype>
#include <cstring>
#include <map>

#include "report/Html.h"

namespace grader {

namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h1 small, .soft { font-weight: 400; opacity: .7; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid #8884; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
th button { font: inherit; font-weight: 600; background: none; border: 0; padding: 0; cursor: pointer;
  color: inherit; }
th[aria-sort=ascending] button::after { content: " ▲"; }
th[aria-sort=descending] button::after { content: " ▼"; }
.alarm { border-left: 4px solid #c33; padding: .3rem 1rem; margin: 1rem 0; }
input { font: inherit; padding: .3rem .5rem; margin: .5rem 0; width: 20rem; max-width: 100%; }
)css";

constexpr const char* kScript = R"js(
const body = document.querySelector("tbody");
document.querySelectorAll("th button").forEach((button, column) => {
  button.addEventListener("click", () => {
    const head = button.parentElement;
    const down = head.getAttribute("aria-sort") === "ascending";
    document.querySelectorAll("th").forEach(th => th.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    const key = row => row.cells[column].dataset.key ?? row.cells[column].textContent;
    const numeric = head.classList.contains("number");
    const rows = [...body.rows].sort((a, b) =>
      numeric ? Number(key(a)) - Number(key(b)) : key(a).localeCompare(key(b)));
    body.append(...(down ? rows.reverse() : rows));
  });
});
document.querySelector("input").addEventListener("input", event => {
  const text = event.target.value.toLowerCase();
  for (const row of body.rows) row.hidden = !row.textContent.toLowerCase().includes(text);
});
)js";

/// A path in a link: everything but letters, digits and a few signs as %XX.
std::string linkTo(const std::string& path) {
    std::string link;
    for (const char c : path)
        if (std::isalnum(static_cast<unsigned char>(c)) || std::strchr("-._~/", c))
            link += c;
        else
            link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return link;
}

/// A cell of RFC 4180. What a spreadsheet would take for a formula gets an apostrophe.
std::string cell(std::string text) {
    if (!text.empty() && std::strchr("=+-@\t\r", text.front()))
        text.insert(text.begin(), '\'');
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::map<std::string, double> pointsByTask(const Standing& standing) {
    std::map<std::string, double> points;
    if (standing.result.contains("tasks"))
        for (const Json& task : standing.result.at("tasks"))
            points[task.at("id")] = task.at("points");
    return points;
}

/// Of those that have a mark.
double meanOf(const std::vector<Standing>& standings) {
    double sum = 0, marks = 0;
    for (const Standing& each : standings)
        if (each.sentence.empty()) {
            sum += each.points;
            ++marks;
        }
    return marks > 0 ? sum / marks : 0;
}

}  // namespace

std::string Overview::json() const {
    Json document = {{"format", 1},        {"assignment", manifest.id},
                     {"seed", seed},       {"sandbox", sandbox},
                     {"ignored", ignored}, {"students", Json::array()}};
    for (const Standing& each : standings)
        document["students"].push_back({{"student", each.student},
                                        {"status", each.status},
                                        {"points", each.points},
                                        {"max_points", each.maxPoints},
                                        {"sentence", each.sentence},
                                        {"tasks", pointsByTask(each)}});
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string Overview::csv() const {
    std::string text = "student,status,points,max_points";
    for (const Task& task : manifest.tasks)
        text += "," + cell(task.id);
    text += ",sentence\r\n";
    for (const Standing& each : standings) {
        text += fmt::format("{},{},{:.2f},{:.2f}", cell(each.student), each.status, each.points,
                            each.maxPoints);
        const auto points = pointsByTask(each);
        for (const Task& task : manifest.tasks)
            text += points.contains(task.id) ? fmt::format(",{:.2f}", points.at(task.id)) : ",";
        text += "," + cell(each.sentence) + "\r\n";
    }
    return text;
}

std::string Overview::html() const {
    std::string alarms, rows,
        heads =
            "<th><button>student</button></th>"
            "<th><button>status</button></th>"
            "<th class=number><button>points</button></th>";
    for (const Task& task : manifest.tasks)
        heads += "<th class=number><button>" + escaped(task.id) + "</button></th>";
    for (const Standing& each : standings) {
        if (!each.sentence.empty())
            alarms +=
                fmt::format("<p class=alarm><b>{}</b>: {}: {}</p>\n", escaped(each.student),
                            each.graderFailed() ? "a fault of the grader, no mark" : "no mark",
                            escaped(each.sentence));
        const bool reported = each.sentence.empty();
        const std::string name = escaped(each.student);
        rows += fmt::format(
            "<tr><td>{}</td><td>{}</td><td class=number data-key=\"{}\">{:.1f}</td>",
            reported ? fmt::format("<a href=\"{}\">{}</a>",
                                   linkTo("students/" + each.student + "/report/index.html"), name)
                     : name,
            escaped(each.status), each.points, each.points);
        const auto points = pointsByTask(each);
        for (const Task& task : manifest.tasks)
            rows += points.contains(task.id)
                        ? fmt::format("<td class=number data-key=\"{}\">{:.1f}</td>",
                                      points.at(task.id), points.at(task.id))
                        : "<td class=number data-key=\"-1\">–</td>";
        rows += "</tr>\n";
    }
    for (const std::string& each : ignored)
        alarms += "<p class=soft>not taken: " + escaped(each) + "</p>\n";
    return fmt::format(
        "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n"
        "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; style-src "
        "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<meta name=viewport content=\"width=device-width\">\n<title>{0}: {1} "
        "submissions</title>\n<style>{2}</style></head>\n<body><h1>{0} <small>{1} submissions, "
        "mean {3:.1f} points, sandbox {4}</small></h1>\n{5}<p><input type=search "
        "aria-label=\"only rows with this text\" placeholder=\"only rows with this "
        "text\"></p>\n<table><thead><tr>{6}</tr></thead>\n<tbody>\n{7}</tbody></table>\n"
        "<script>{8}</script></body></html>\n",
        escaped(manifest.id + " " + manifest.title), standings.size(), kStyle, meanOf(standings),
        escaped(sandbox), alarms, heads, rows, kScript);
}

}  // namespace grader
