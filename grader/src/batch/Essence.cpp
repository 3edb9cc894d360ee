#include "batch/Essence.h"

namespace grader {

std::shared_ptr<const Essence> essenceOf(const Json& document) {
    if (!document.contains("tasks"))
        return nullptr;
    auto essence = std::make_shared<Essence>();
    for (const Json& task : document.at("tasks")) {
        Essence::Task& kept = essence->tasks.emplace_back();
        kept.id = task.at("id");
        kept.points = task.at("points");
        if (task.contains("recognised"))
            kept.recognised = task.at("recognised").at("says");
        for (const Json& check : task.at("checks")) {
            Essence::Check& one = essence->checks.emplace_back();
            one.id = check.at("id");
            one.title = check.at("title");
            one.status = check.at("status");
            one.points = check.at("points");
            one.maxPoints = check.at("max_points");
            if (one.status == "tampered")
                one.message = check.at("message");
            if (check.contains("images"))
                one.picture = check.at("images").at("submission");
        }
    }
    essence->tasks.shrink_to_fit();
    essence->checks.shrink_to_fit();
    return essence;
}

}  // namespace grader
