#include "course/SyncedStarter.h"

#include "Error.h"
#include "Regions.h"

namespace grader {

std::string syncedStarter(const std::string& name, const std::string& starter,
                          const std::string& solution) {
    const auto blanks = regionsOf(starter), solved = regionsOf(solution);
    std::string text = solution;
    for (const auto& [id, body] : solved) {
        if (!blanks.contains(id))
            throw Error(
                "{}: the solution has a region TODO({}) and the starter has none: add it "
                "there, with its blank inside",
                name, id);
        text = withRegion(text, id, blanks.at(id)).value();
    }
    for (const auto& [id, body] : blanks)
        if (!solved.contains(id))
            throw Error(
                "{}: the starter has a region TODO({}) and the solution has none: nothing "
                "was written",
                name, id);
    return text;
}

}  // namespace grader
