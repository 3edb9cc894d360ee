// Why a table cannot be followed, in numbers for the harness to send and in words for its author.
#pragma once

#include <string>
#include <vector>

namespace course {

struct TableFault {
    enum Kind {
        none,
        childWithoutTransform,
        transformWithoutChild,
        modelWithoutTransform,
        transformWithoutModel,
        otherModel,
        noChild,
        cycle
    };
    enum Place { table, top, leg, elsewhere };

    Kind kind = none;
    Place place = elsewhere;          ///< the node where it was found
    int entries = 0, transforms = 0;  ///< of two lists that should be equally long

    std::vector<int> numbers() const { return {kind, place, entries, transforms}; }
    /// What numbers() gave; anything else is no fault.
    static TableFault of(const std::vector<int>& numbers) {
        if (numbers.size() != 4 || numbers[0] < none || numbers[0] > cycle || numbers[1] < table ||
            numbers[1] > elsewhere) {
            return {};
        }
        return {Kind(numbers[0]), Place(numbers[1]), numbers[2], numbers[3]};
    }

    std::string tell() const {
        static const char* const places[] = {"table", "top", "leg", "a node"};
        const std::string at = places[place];
        switch (kind) {
            case childWithoutTransform:
            case transformWithoutChild:
                return lengths(at, "childnodes", "childtransforms");
            case modelWithoutTransform:
            case transformWithoutModel:
                return lengths(at, "models", "modeltransforms");
            case otherModel:
                return at + ".models holds a model that is not `piece`";
            case noChild:
                return at + ".childnodes holds a null pointer";
            case cycle:
                return "the table contains itself: " + at + " is below itself, or far too deep";
            case none:
                break;
        }
        return "";
    }

private:
    std::string lengths(const std::string& at, const char* list, const char* transformList) const {
        return at + "." + list + " has " + std::to_string(entries) + " entries and " + at + "." +
               transformList + " " + std::to_string(transforms) + ": the two must be equally long";
    }
};

}  // namespace course
