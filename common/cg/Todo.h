#pragma once

#include <string>
#include <vector>

namespace cg {

/// Marks a place that a student has yet to fill. It notes that task `id` was reached, so that a
/// report can say "not implemented" instead of "wrong". Each id is noted once.
void todo(const char* id);

/// The same for a place that must return something: notes `id` and gives back `neutral`, a value
/// with which the rest of the program still makes sense (the identity for a matrix).
///     return cg::todo<glm::mat3>("rotation");
template <class T>
T todo(const char* id, T neutral = T{}) {
    todo(id);
    return neutral;
}

/// Ids noted so far in this process, in the order in which they were first reached.
const std::vector<std::string>& reachedTodos();

/// Forgets the ids noted so far, so that the next request can be told apart from the last.
void clearTodos();

/// Whether each id also prints "TODO id: not implemented yet" to stderr, once (ids noted before the
/// call included). Off at the start; windows turn it on.
void announceTodos(bool on);

}  // namespace cg
