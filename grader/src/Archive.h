#pragma once

#include <optional>

#include "Build.h"
#include "unpack/Unpack.h"

namespace grader {

/// Bytes of an archive that is taken, at most, as it is and unpacked.
inline constexpr std::size_t kLargestArchive = unpack::Limits{}.bytes;

/// Why what the grader may not read is refused.
inline constexpr const char* kUnreadable = "it cannot be read: check its permissions";

/// What became of an archive that a student handed in.
struct Unpacked {
    fs::path folder;      ///< of the files, in the job's folder
    std::string refusal;  ///< why it is not taken, one sentence; empty when it is
    std::string notice;   ///< what an instructor should know about it; may be empty
};

/// Unpacks a zip, tar, tar.gz, tar.xz or tar.bz2 in the sandbox, see grader/unpack/Unpack.h. Where
/// all of it is in one folder that is not named like one of the `known` assignments, that folder is
/// taken, and said. A file that may not be read is refused; throws Error when it cannot be read for
/// another reason.
Unpacked unpackArchive(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                       const fs::path& archive, const std::vector<std::string>& known);

/// The git repository of a clone, or of a bare one; nothing where the folder is neither.
std::optional<fs::path> repositoryIn(const fs::path& folder);

/// The same with the commit that a git repository's HEAD names. Git runs in the sandbox, on a copy
/// of the objects and references alone: no hook or configuration of the repository is ever there.
Unpacked unpackClone(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                     const fs::path& repository, const std::vector<std::string>& known);

}  // namespace grader
