#include "watch/Changes.h"

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

constexpr double kNoise = 1e-4;            // points
constexpr std::size_t kMostSentences = 3;  // of one task, of checks that changed alike

struct Moved {
    double points;
    std::string title, message;
    bool full, wasFull;
};

std::string sentenceOf(const Moved& moved) {
    if (moved.full)
        return "now " + moved.title;
    if (moved.wasFull)
        return "no longer: " + moved.title;
    return (moved.points > 0 ? "nearer: " : "further off: ") + moved.title;
}

/// Those of one task that changed in one direction, the most points first; one sentence for all
/// that are too many.
void describe(const std::string& task, std::vector<Moved> moved, std::vector<Change>& changes) {
    std::stable_sort(moved.begin(), moved.end(), [](const Moved& a, const Moved& b) {
        return std::abs(a.points) > std::abs(b.points) + kNoise;
    });
    const std::size_t told = moved.size() <= kMostSentences ? moved.size() : kMostSentences - 1;
    for (std::size_t i = 0; i < told; ++i)
        changes.push_back(
            {moved[i].points, sentenceOf(moved[i]), moved[i].points < 0 ? moved[i].message : ""});
    if (told == moved.size())
        return;
    double rest = 0;
    for (std::size_t i = told; i < moved.size(); ++i)
        rest += moved[i].points;
    changes.push_back({rest, fmt::format("{} more checks of {}", moved.size() - told, task), ""});
}

bool isDone(const Json& status) {
    return status == "pass" || status == "pending";
}

bool couldNotBeMade(const Json& result, const Json& check) {
    return result.at("status") != "graded" || check.at("status") == "build_error" ||
           check.at("status") == "grader_error";
}

}  // namespace

std::vector<Change> Baseline::take(const Json& result) {
    std::vector<Change> gained, lost;
    for (const Json& task : result.at("tasks")) {
        std::vector<Moved> up, down;
        for (const Json& check : task.at("checks")) {
            if (couldNotBeMade(result, check))
                continue;
            const Check now{check.at("points"), check.at("status") == "pass"};
            const auto [known, isNew] = checks_.try_emplace(check.at("id"), now);
            const Check before = std::exchange(known->second, now);
            const double points = now.points - before.points;
            if (!isNew && std::abs(points) > kNoise)
                (points > 0 ? up : down)
                    .push_back(
                        {points, check.at("title"), check.at("message"), now.full, before.full});
        }
        describe(task.at("id"), std::move(up), gained);
        describe(task.at("id"), std::move(down), lost);
    }
    gained.insert(gained.end(), lost.begin(), lost.end());
    return gained;
}

double Baseline::points() const {
    double sum = 0;
    for (const auto& [id, check] : checks_)
        sum += check.points;
    return std::round(sum / kNoise) * kNoise;
}

const Json* firstLost(const Json& result) {
    const Json* resting = nullptr;
    if (result.at("status") == "build_error")
        return nullptr;
    for (const Json& task : result.at("tasks"))
        for (const Json& check : task.at("checks")) {
            if (isDone(check.at("status")))
                continue;
            if (check.at("status") != "skipped")
                return &check;
            if (!resting)
                resting = &check;
        }
    return resting;
}

const Json* nextTask(const Json& result, const std::string& after) {
    const Json& tasks = result.at("tasks");
    const auto current = std::find_if(tasks.begin(), tasks.end(),
                                      [&](const Json& task) { return task.at("id") == after; });
    const auto first = current == tasks.end() ? 0 : current - tasks.begin() + 1;
    for (std::size_t i = 0; i < tasks.size(); ++i)
        if (const Json& task = tasks.at((static_cast<std::size_t>(first) + i) % tasks.size());
            !isDone(task.at("status")))
            return &task;
    return nullptr;
}

bool doesNotCompile(const Json& result) {
    if (result.at("status") == "build_error")
        return true;
    const Json* lost = firstLost(result);
    return lost && lost->at("status") == "build_error";
}

}  // namespace grader
