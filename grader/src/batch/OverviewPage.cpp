#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <map>

#include "batch/Overview.h"
#include "batch/OverviewAssets.h"
#include "report/Html.h"
#include "report/Words.h"

namespace grader {

namespace {

constexpr std::size_t kMostRows = 20;  // of a list that is only worth reading from its top

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

/// "Ada Lovelace (12345)", or the id alone.
std::string nameOf(const Mark& mark) {
    return escaped(mark.student.name.empty() ? mark.student.id
                                             : mark.student.name + " (" + mark.student.id + ")");
}

/// Calls `take` with each check of all results.
template <class Take>
void forEachCheck(const std::vector<Mark>& marks, Take&& take) {
    for (const Mark& mark : marks)
        if (mark.result)
            for (const Essence::Check& check : mark.result->checks)
                take(mark, check);
}

/// What a submission did that no honest mistake does; empty when nothing.
std::string tampering(const Mark& mark) {
    if (mark.result)
        for (const Essence::Check& check : mark.result->checks)
            if (!check.message.empty())
                return std::string(check.message);
    return "";
}

class Page {
public:
    Page(const Overview& overview, const fs::path& out)
        : all_(overview), marks_(overview.marks), out_(out) {}

    std::string html() const {
        return fmt::format(
            "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n"
            "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; style-src "
            "'unsafe-inline'; script-src 'unsafe-inline'; img-src file: 'self'\">\n"
            "<meta name=viewport content=\"width=device-width\">\n<title>{0}</title>\n"
            "<style>{1}</style></head>\n<body><h1>{0} <small>{2}</small></h1>\n{3}{4}{5}{6}{7}{8}"
            "{9}{10}<script>{11}</script></body></html>\n",
            escaped(all_.manifest.id + " " + all_.manifest.title), kOverviewStyle, summary(),
            navigation(), attention(), studentsTable(), distributions(), lostChecks(), mistakes(),
            gallery(), alike(), kOverviewScript);
    }

private:
    std::string summary() const {
        double sum = 0;
        std::size_t graded = 0, missing = 0, late = 0;
        for (const Mark& each : marks_) {
            graded += each.sentence.empty() && each.status != "missing";
            sum += each.sentence.empty() && each.status != "missing" ? each.points : 0;
            missing += each.status == "missing";
            late += each.lateness.late;
        }
        return fmt::format(
            "{} students, {} with a mark (mean {:.1f} points), {} missing, {} late; sandbox {}",
            marks_.size(), graded, graded ? sum / static_cast<double>(graded) : 0.0, missing, late,
            escaped(all_.environment.value("sandbox", "")));
    }

    static std::string navigation() {
        return "<nav><a href=#table>students</a><a href=#points>points</a><a href=#checks>checks "
               "lost</a><a href=#mistakes>mistakes</a><a href=#gallery>gallery</a><a "
               "href=#alike>alike</a></nav>\n";
    }

    /// Faults of the grader first, then what has no mark, then what is to be looked at.
    std::string attention() const {
        std::string faults, refused, notices;
        for (const Mark& each : marks_) {
            if (!each.sentence.empty())
                (each.graderFailed() ? faults : refused) +=
                    fmt::format("<p class=alarm><b>{}</b>: {}: {}</p>\n", nameOf(each),
                                each.graderFailed() ? "a fault of the grader, no mark" : "no mark",
                                escaped(each.sentence));
            if (const std::string how = tampering(each); !how.empty())
                refused += fmt::format("<p class=alarm><b>{}</b>: tampered: {}</p>\n", nameOf(each),
                                       escaped(how));
            for (const std::string& warning : each.warnings)
                notices += fmt::format("<p class=notice><b>{}</b>: {}</p>\n", nameOf(each),
                                       escaped(warning));
        }
        for (const std::string& each : all_.notTaken)
            notices += "<p class=notice>" + escaped(each) + "</p>\n";
        return faults + refused + notices;
    }

    std::string studentsTable() const {
        std::string heads =
            "<th><button>student</button></th><th></th><th><button>section</button></th>"
            "<th><button>status</button></th><th class=number><button>days late</button></th>"
            "<th class=number><button>points</button></th>";
        for (const Task& task : all_.manifest.tasks)
            heads += "<th class=number><button>" + escaped(task.id) + "</button></th>";
        std::string rows;
        for (const Mark& each : marks_)
            rows += rowOf(each);
        return "<h2 id=table>Students</h2>\n<p><input id=filter type=search aria-label=\"only rows "
               "with this text\" placeholder=\"only rows with this text\"></p>\n"
               "<table id=students><thead><tr>" +
               heads + "</tr></thead>\n<tbody>\n" + rows + "</tbody></table>\n";
    }

    std::string rowOf(const Mark& mark) const {
        std::string row = fmt::format(
            "<tr data-student=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td class=number data-key=\"{}\">{}</td><td class=number data-key=\"{}\">{:.1f}</td>",
            escaped(mark.student.id), linked(mark, nameOf(mark)), thumbnail(mark),
            escaped(mark.student.section), escaped(mark.status), mark.lateness.days,
            mark.lateness.late ? fmt::format("{}", mark.lateness.days) : "", mark.points,
            mark.points);
        for (const TaskMark& task : mark.tasks)
            row += fmt::format(
                "<td class=\"number{}\"{} data-key=\"{}\">{}</td>",
                task.reason.empty() ? "" : " decided",
                task.reason.empty() ? ""
                                    : fmt::format(" title=\"{:g} before: {}\"", task.automatic,
                                                  escaped(task.reason)),
                task.points, task.pending ? "pending" : fmt::format("{:.1f}", task.points));
        return row + "</tr>\n";
    }

    /// To the instructor's report where there is one of its own.
    std::string linked(const Mark& mark, const std::string& text) const {
        for (const char* whose : {"instructor", "students"}) {
            const std::string page =
                std::string(whose) + "/" + mark.submission + "/report/index.html";
            if (mark.result && fs::exists(out_ / page))
                return "<a href=\"" + linkTo(page) + "\">" + text + "</a>";
        }
        return text;
    }

    static std::string pictureOfCheck(const Mark& mark, const Essence::Check& check) {
        return check.picture.empty()
                   ? ""
                   : fmt::format("students/{}/report/{}", mark.submission, check.picture);
    }

    std::string thumbnail(const Mark& mark) const {
        if (!mark.result)
            return "";
        std::string picture;
        forEachCheck({mark}, [&](const Mark&, const Essence::Check& check) {
            if (picture.empty())
                picture = pictureOfCheck(mark, check);
        });
        return picture.empty() ? "" : "<img loading=lazy alt=\"\" src=\"" + linkTo(picture) + "\">";
    }

    /// How many earned which tenth of a task's points.
    static std::string histogram(const std::string& title, const std::vector<double>& shares) {
        constexpr int kBins = 10;
        std::array<int, kBins> counts{};
        for (const double share : shares)
            ++counts[static_cast<std::size_t>(
                std::clamp(static_cast<int>(share * kBins), 0, kBins - 1))];
        const int most = std::max(1, *std::max_element(counts.begin(), counts.end()));
        std::string bars;
        for (std::size_t bin = 0; bin < kBins; ++bin) {
            const double height = 48.0 * counts[bin] / most;
            bars += fmt::format(
                "<rect x=\"{}\" y=\"{:.1f}\" width=\"9\" height=\"{:.1f}\"><title>{} to {} %: {} "
                "students</title></rect>",
                10 * bin, 50 - height, height, 10 * bin, 10 * bin + 10, counts[bin]);
        }
        return fmt::format(
            "<figure><figcaption>{}</figcaption><svg viewBox=\"0 0 99 50\" "
            "preserveAspectRatio=none role=img aria-label=\"distribution of {}\">{}</svg><div "
            "class=ends><span>0 %</span><span>at most {} students</span><span>100 %</span></div>"
            "</figure>\n",
            escaped(title), escaped(title), bars, most);
    }

    std::string distributions() const {
        std::string figures;
        std::vector<double> totals;
        std::map<std::string, std::vector<double>> tasks;
        for (const Mark& mark : marks_) {
            if (!mark.result)
                continue;
            totals.push_back(mark.points / std::max(1.0, mark.maxPoints));
            for (const TaskMark& task : mark.tasks)
                if (!task.pending)
                    tasks[task.id].push_back(task.points / std::max(1e-9, task.maxPoints));
        }
        figures = histogram("all together", totals);
        for (const Task& task : all_.manifest.tasks)
            figures += histogram(task.id, tasks[task.id]);
        return "<h2 id=points>Distribution of points</h2>\n<div class=bars>" + figures + "</div>\n";
    }

    /// Lines "31 of 180 …" with a bar, the most frequent first.
    std::string ranking(const std::map<std::string, std::size_t>& counts) const {
        const auto graded = static_cast<std::size_t>(std::count_if(
            marks_.begin(), marks_.end(), [](const Mark& each) { return each.result != nullptr; }));
        std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](const auto& a, const auto& b) { return a.second > b.second; });
        sorted.resize(std::min(sorted.size(), kMostRows));
        std::string rows;
        for (const auto& [what, count] : sorted)
            rows += fmt::format(
                "<tr><td class=number>{} of {}</td><td><span class=share style=\"width:{:.1f}rem\">"
                "</span></td><td>{}</td></tr>\n",
                count, graded,
                6.0 * static_cast<double>(count) /
                    static_cast<double>(std::max<std::size_t>(graded, 1)),
                escaped(what));
        return rows.empty() ? "<p class=soft>none</p>\n" : "<table>" + rows + "</table>\n";
    }

    std::string lostChecks() const {
        // What did not build lost all of them, which says nothing of any.
        std::map<std::string, std::size_t> lost;
        forEachCheck(marks_, [&](const Mark& mark, const Essence::Check& check) {
            if (mark.status == "graded" && check.status != "pass" && check.status != "pending")
                ++lost[fmt::format("{}: {}", check.id, check.title)];
        });
        return "<h2 id=checks>Checks that most lost</h2>\n" + ranking(lost);
    }

    std::string mistakes() const {
        std::map<std::string, std::size_t> counts;
        for (const Mark& mark : marks_)
            if (mark.result)
                for (const Essence::Task& task : mark.result->tasks)
                    if (!task.recognised.empty())
                        ++counts[fmt::format("{}: {}", task.id, task.recognised)];
        return "<h2 id=mistakes>Mistakes, by frequency</h2>\n" + ranking(counts);
    }

    /// The picture that a frame should be, out of any report that has it.
    std::string referenceOf(const std::string& frame) const {
        for (const Mark& mark : marks_)
            for (const char* whose : {"instructor", "students"}) {
                const std::string path = fmt::format("{}/{}/report/{}/{}.reference.png", whose,
                                                     mark.submission, all_.manifest.id, frame);
                if (!mark.submission.empty() && fs::exists(out_ / path))
                    return path;
            }
        return "";
    }

    std::string gallery() const {
        if (all_.manifest.frames.empty())
            return "";
        std::map<std::string, std::string> figures;
        forEachCheck(marks_, [&](const Mark& mark, const Essence::Check& check) {
            if (const std::string picture = pictureOfCheck(mark, check); !picture.empty())
                figures[std::string(check.id)] += fmt::format(
                    "<figure data-student=\"{}\"><a href=\"{}\"><img loading=lazy src=\"{}\" "
                    "alt=\"picture of {}\"></a><figcaption>{} {}</figcaption></figure>\n",
                    escaped(mark.student.id), linkTo(picture), linkTo(picture), nameOf(mark),
                    linked(mark, nameOf(mark)), scoreText(check.points, check.maxPoints));
        });
        std::string options, galleries;
        for (const Frame& frame : all_.manifest.frames) {
            options += fmt::format("<option value=\"{}\">{}: {}</option>", escaped(frame.id),
                                   escaped(frame.id), escaped(frame.title));
            const std::string reference = referenceOf(frame.id);
            galleries += fmt::format(
                "<div class=gallery data-frame=\"{}\">{}{}</div>\n", escaped(frame.id),
                reference.empty() ? ""
                                  : fmt::format("<figure class=truth><img loading=lazy src=\"{}\" "
                                                "alt=\"the reference\"><figcaption><b>the "
                                                "reference</b></figcaption></figure>\n",
                                                linkTo(reference)),
                figures[frame.id]);
        }
        return "<h2 id=gallery>Gallery</h2>\n<p><label>Frame <select id=frame>" + options +
               "</select></label></p>\n" + galleries;
    }

    std::string alike() const {
        std::string rows;
        for (const Likeness& each : all_.likenesses)
            rows += fmt::format(
                "<tr><td>{}</td><td>{}</td><td class=number>{}</td></tr>\n", escaped(each.first),
                escaped(each.second),
                each.identical ? "the same but for comments and layout"
                               : fmt::format("{:.0f} % of the fingerprints", 100 * each.share));
        return "<h2 id=alike>Submissions that are nearly identical</h2>\n<p class=soft>Names, "
               "numbers, comments and layout make no difference, and what the starter or a tenth "
               "of the class has is not counted. This is where to look, not what to "
               "conclude.</p>\n" +
               (rows.empty() ? "<p class=soft>none</p>\n" : "<table>" + rows + "</table>\n");
    }

    const Overview& all_;
    const std::vector<Mark>& marks_;
    const fs::path& out_;
};

}  // namespace

std::string overviewPage(const Overview& overview, const fs::path& out) {
    return Page(overview, out).html();
}

}  // namespace grader
