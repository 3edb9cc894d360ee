#include <cg/Todo.h>

#include <algorithm>
#include <cstddef>
#include <iostream>

namespace cg {
namespace {

struct Record {
    std::vector<std::string> reached;
    std::size_t announced = 0;  // how many of them were printed
    bool announcing = false;

    void announce() {
        for (; announcing && announced < reached.size(); ++announced) {
            std::cerr << "TODO " << reached[announced] << ": not implemented yet\n";
        }
    }
};

Record& record() {
    static Record instance;
    return instance;
}

}  // namespace

void todo(const char* id) {
    Record& all = record();
    if (std::find(all.reached.begin(), all.reached.end(), id) == all.reached.end()) {
        all.reached.emplace_back(id);
        all.announce();
    }
}

const std::vector<std::string>& reachedTodos() {
    return record().reached;
}

void clearTodos() {
    record().reached.clear();
    record().announced = 0;
}

void announceTodos(bool on) {
    record().announcing = on;
    record().announce();
}

}  // namespace cg
