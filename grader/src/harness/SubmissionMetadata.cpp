#include "harness/SubmissionMetadata.h"

#include <optional>

#include "Fields.h"
#include "batch/Moment.h"
#include "report/Words.h"

namespace grader {

namespace {

/// The member of an object, null where there is none.
const Json& memberOf(const Json& json, const char* name) {
    static const Json null;
    return json.is_object() && json.contains(name) ? json.at(name) : null;
}

std::optional<Moment> momentIn(const Json& json, const char* name) {
    const Json& text = memberOf(json, name);
    if (!text.is_string())
        return std::nullopt;
    try {
        return parseMoment(text, name);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// "2 d 3 h", "5 min"
std::string inWords(std::chrono::seconds span) {
    using namespace std::chrono;
    const auto whole = ceil<minutes>(span);
    const auto d = duration_cast<days>(whole);
    const auto h = duration_cast<hours>(whole - d);
    const minutes m = whole - d - h;
    if (d.count() > 0)
        return fmt::format("{} d {} h", d.count(), h.count());
    return h.count() > 0 ? fmt::format("{} h {} min", h.count(), m.count())
                         : fmt::format("{} min", m.count());
}

std::optional<double> lastScore(const Json& metadata) {
    const Json& all = memberOf(metadata, "previous_submissions");
    std::optional<double> score;
    std::optional<Moment> newest;
    if (!all.is_array())
        return score;
    for (const Json& each : all) {
        const auto when = momentIn(each, "submission_time");
        const Json& points = memberOf(each, "score");
        if (points.is_number() && when && (!newest || *when >= *newest)) {
            newest = when;
            score = points.get<double>();
        }
    }
    return score;
}

}  // namespace

std::vector<std::string> remarksFrom(const std::string& metadata, double points, bool tellPoints) {
    std::vector<std::string> remarks;
    const Json json = Json::parse(metadata, nullptr, false);
    const Json& assignment = memberOf(json, "assignment");
    const auto submitted = momentIn(json, "created_at"), due = momentIn(assignment, "due_date"),
               lateDue = momentIn(assignment, "late_due_date");
    if (submitted && due && *submitted > *due)
        remarks.push_back(fmt::format(
            "Handed in {} after the due date{}. What that costs is not in these points.",
            inWords(*submitted - *due),
            lateDue && *submitted > *lateDue ? ", and after the late due date" : ""));
    const auto before = lastScore(json);
    if (tellPoints && before && showPoints(*before) != showPoints(points))
        remarks.push_back(fmt::format("{} points; the submission before this one had {}.",
                                      showPoints(points), showPoints(*before)));
    return remarks;
}

}  // namespace grader
