#include "report/Words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/PlainText.h"

namespace grader {

namespace {

/// The first in the order of the handout that waits for nothing else.
const TaskResult& nextTask(const AssignmentResult& result) {
    const auto find = [&](auto&& wanted) {
        return std::find_if(result.tasks.begin(), result.tasks.end(), wanted);
    };
    auto next = find([](const TaskResult& each) {
        return each.status != Status::pass && each.status != Status::skipped &&
               each.status != Status::pending;
    });
    if (next == result.tasks.end())
        next = find([](const TaskResult& each) { return each.status != Status::pass; });
    return *next;
}

}  // namespace

const char* symbolOf(Status status) {
    switch (status) {
        case Status::pass:
            return "✓";
        case Status::partial:
            return "◐";
        case Status::notImplemented:
            return "○";
        case Status::skipped:
            return "–";
        case Status::pending:
            return "…";
        case Status::graderError:
            return "!";
        default:
            return "✗";
    }
}

std::string nameOf(Status status) {
    std::string name = judge::toString(status);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string showPoints(double points) {
    // Cut, not rounded up: what is not everything must not read as everything.
    const double tenths = std::floor(points * 10 + 1e-6) / 10;
    // And what is not nothing must not read as nothing.
    return tenths > 0 || points < 1e-6 ? fmt::format("{:g}", tenths)
                                       : fmt::format("{:.1g}", points);
}

std::string scoreText(double points, double most) {
    return showPoints(points) + " / " + showPoints(most);
}

std::string whatNext(const AssignmentResult& result) {
    if (result.status == "build_error")
        return "Nothing could be checked: mend the first error "
               "below, then grade again.";
    if (result.graderFailed())
        return "The grader itself failed below; that is not your mistake. Please report it with "
               "the sentence shown.";
    const auto pending =
        std::count_if(result.tasks.begin(), result.tasks.end(),
                      [](const TaskResult& each) { return each.status == Status::pending; });
    if (result.full())
        return pending == 0
                   ? fmt::format("Everything is done: all {} tasks have full marks.",
                                 result.tasks.size())
                   : fmt::format("What a program can judge has full marks; a person judges {}.",
                                 pending == 1 ? "one task" : fmt::format("{} tasks", pending));
    const TaskResult& next = nextTask(result);
    const std::string name = fmt::format("{} ({})", next.id, next.title);
    if (result.notStarted())
        return fmt::format("Nothing is done yet: begin with {}.", name);
    const auto done =
        std::count_if(result.tasks.begin(), result.tasks.end(),
                      [](const TaskResult& each) { return each.status == Status::pass; });
    const std::string state = done == 0
                                  ? "No task is done yet"
                                  : fmt::format("{} of {} tasks {} done", done, result.tasks.size(),
                                                done == 1 ? "is" : "are");
    return fmt::format("{}; go on with {}, which has {} of {} points.", state, name,
                       showPoints(next.points), showPoints(next.maxPoints));
}

QuotedSource quoted(const Diagnostic& diagnostic, std::size_t width) {
    const std::string text = harmless(diagnostic.source);
    const std::size_t length = columns(text);
    const std::size_t at =
        diagnostic.column > 0 ? static_cast<std::size_t>(diagnostic.column) - 1 : length + 1;
    const bool known = at <= length;
    std::size_t first = 0;
    if (known && length > width && at > width / 2)
        first = std::min(at - width / 2, length - width + 1);
    QuotedSource result;
    const std::size_t from = bytesOf(text, first);
    const std::string rest = text.substr(from);
    result.line = rest.substr(0, bytesOf(rest, width));
    if (known && !text.empty())
        result.caret = std::string(at - first, ' ') + "^";
    return result;
}

}  // namespace grader
