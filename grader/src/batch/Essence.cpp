#include "batch/Essence.h"

#include <mutex>
#include <set>

namespace grader {

namespace {

std::string_view textOf(const Json& json) {
    return interned(json.get_ref<const std::string&>());
}

}  // namespace

std::string_view interned(const std::string& text) {
    static std::mutex mutex;
    static std::set<std::string> all;
    const std::scoped_lock lock(mutex);
    return *all.insert(text).first;
}

std::shared_ptr<const Essence> essenceOf(const Json& document) {
    if (!document.contains("tasks"))
        return nullptr;
    auto essence = std::make_shared<Essence>();
    for (const Json& task : document.at("tasks")) {
        Essence::Task& kept = essence->tasks.emplace_back();
        kept.id = textOf(task.at("id"));
        kept.points = task.at("points");
        if (task.contains("recognised"))
            kept.recognised = textOf(task.at("recognised").at("says"));
        for (const Json& check : task.at("checks")) {
            Essence::Check& one = essence->checks.emplace_back();
            one.id = textOf(check.at("id"));
            one.title = textOf(check.at("title"));
            one.status = textOf(check.at("status"));
            one.points = check.at("points");
            one.maxPoints = check.at("max_points");
            if (one.status == "tampered")
                one.message = textOf(check.at("message"));
            if (check.contains("images"))
                one.picture = textOf(check.at("images").at("submission"));
        }
    }
    essence->checks.shrink_to_fit();
    return essence;
}

}  // namespace grader
