#pragma once

#include <map>
#include <optional>
#include <string>

#include "Fields.h"
#include "Files.h"
#include "batch/Keys.h"
#include "batch/Similarity.h"

namespace grader {

/// What a batch knows already: one folder for each submission, below `folder`/students, and where
/// students must not see all of it another below `folder`/instructor. Crash-safe:
/// files are replaced by rename, and the key, which says that the rest is whole, comes last.
class Ledger {
public:
    explicit Ledger(fs::path folder) : folder_(std::move(folder)) {}

    fs::path folderOf(const std::string& entrant) const { return folder_ / "students" / entrant; }
    fs::path instructorFolderOf(const std::string& entrant) const {
        return folder_ / "instructor" / entrant;
    }

    /// What was kept under a key with the same `deciding`; nothing when there is none, or it cannot
    /// be read.
    struct Known {
        Json result;  ///< the document
        std::string wording;
    };
    std::optional<Known> known(const std::string& entrant, const Key& key) const;

    /// Forgets what was known of the submission: what follows is written anew.
    void begin(const std::string& entrant) const;

    /// Keeps a result. Without a key it is there to be read, and graded again the next time.
    void keep(const std::string& entrant, const std::optional<Key>& key,
              const std::string& result) const;

    /// What the submission is compared by with others; nothing when it was not kept.
    std::optional<Print> print(const std::string& entrant) const;
    void keepPrint(const Print& print) const;

    /// What was taken of the submission, for replay: its files by name, with their contents.
    fs::path submissionOf(const std::string& entrant) const {
        return instructorFolderOf(entrant) / "submission";
    }
    void keepSubmission(const std::string& entrant, const std::map<std::string, std::string>& files,
                        const std::string& assignment) const;

    /// The document with the paths of all pictures, where students must not see them all.
    std::optional<Json> instructorsResult(const std::string& entrant) const;
    void keepInstructorsResult(const std::string& entrant, const std::string& result) const;

    /// What else an instructor has to know; an empty object when nothing is known.
    Json record(const std::string& entrant) const;
    void keepRecord(const std::string& entrant, const Json& record) const;

private:
    fs::path folder_;
};

}  // namespace grader
