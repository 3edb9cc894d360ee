#pragma once

#include <string>
#include <vector>

#include "Fields.h"

namespace grader {

/// How one result document differs from another in what a mark rests on: status and points of the
/// whole and of every check. A sentence each; none when they agree.
std::vector<std::string> differencesOf(const Json& then, const Json& now);

/// What decides results and is another now than then: compiler, renderer, processor, … A sentence
/// each.
std::vector<std::string> changesOfEnvironment(const Json& then, const Json& now);

}  // namespace grader
