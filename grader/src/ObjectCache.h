#pragma once

#include <optional>
#include <string>

#include "Files.h"

namespace grader {

/// What the compiler made, kept under the hash of everything that went into it.
///
/// Only successful results are kept, with what the compiler said. The kMostEntries that were used
/// last stay, none of them larger than kLargestEntry.
class ObjectCache {
public:
    static constexpr std::size_t kMostEntries = 400;
    static constexpr std::uintmax_t kLargestEntry = 16u << 20;  // bytes

    explicit ObjectCache(fs::path folder) : folder_(std::move(folder)) {}

    /// Copies the entry to `target` and returns the compiler's log; nothing when it is not known.
    std::optional<std::string> fetch(const std::string& key, const fs::path& target) const;

    void store(const std::string& key, const fs::path& made, const std::string& log) const;

private:
    void forgetOldest() const;

    fs::path folder_;
};

}  // namespace grader
