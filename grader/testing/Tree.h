#pragma once

#include <string>

#include "Files.h"

namespace testing_help {

/// A folder for one test, with files made by name; removed at the end.
class Tree {
public:
    const grader::fs::path& path() const { return work_.path(); }
    grader::fs::path operator/(const std::string& name) const { return path() / name; }
    grader::fs::path write(const std::string& name, const std::string& content) const {
        grader::writeFile(path() / name, content);
        return path() / name;
    }

private:
    grader::WorkFolder work_;
};

/// The text of the exception that `action` throws; empty when it throws none.
template <class Exception, class Action>
std::string whatOf(Action&& action) {
    try {
        action();
    } catch (const Exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace testing_help
