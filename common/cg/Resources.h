#pragma once

#include <string>

namespace cg {

/// Path of the file that `name` ("shaders/normal.frag") stands for: looked up in the current
/// folder first, then in the folders added below, in the order in which they were added. An
/// absolute name stands for itself. Throws cg::Error, which lists the places tried.
std::string findResource(const std::string& name);

/// Adds a folder to search; a folder that was added before is not added again.
void addResourceFolder(const std::string& path);

}  // namespace cg
