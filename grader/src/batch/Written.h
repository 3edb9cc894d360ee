#pragma once

#include <string>

#include "Files.h"
#include "batch/Essence.h"
#include "report/PlainText.h"

namespace grader {

/// What `take` makes of a JSON file that a batch wrote. Throws Error that names the file and what
/// to do when it is not as it was written: cut off, or without one of its fields.
template <class Take>
auto fromWritten(const fs::path& file, const std::string& remedy, Take take) {
    const std::string text = readFile(file);
    try {
        return take(Json::parse(text));
    } catch (const nlohmann::json::exception& error) {
        throw Error("{} is not as ./grade batch wrote it ({}): {}", harmless(file.string()),
                    error.what(), remedy);
    }
}

/// What to do about results.json, and about what is in students/.
inline constexpr const char* kGradeAgain = "run the same ./grade batch again";

/// The result document of a submission.
inline Json resultIn(const fs::path& file) {
    return fromWritten(file, kGradeAgain, [](Json document) {
        essenceOf(document);  // or a field would be missed later, where nobody knows the file
        return document;
    });
}

}  // namespace grader
