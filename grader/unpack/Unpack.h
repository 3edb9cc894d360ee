#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

/// Archives that students hand in: zip, tar, tar.gz, tar.xz and tar.bz2, read by libarchive.
namespace unpack {

struct Limits {
    std::size_t files = 5000;        ///< and folders
    std::size_t bytes = 200u << 20;  ///< of all files together, unpacked
    std::size_t nameBytes = 255;     ///< of one part of a path
    std::size_t depth = 32;          ///< folders within each other
};

/// Unpacks `archive` into the empty folder `target`, regular files and folders only. Owners, times
/// and rights are not taken over.
///
/// Returns why the archive is refused, in one sentence; empty when all of it is there. Refused is
/// what is damaged, cut off, encrypted, empty or of another format; what is too much; and what no
/// honest archive holds: names that lead out of the folder, are absolute, too long, hold
/// characters that steer, or come twice; links and devices. What is not UTF-8 in a name becomes
/// '?'. Nothing outside `target` is touched.
std::string unpack(const std::filesystem::path& archive, const std::filesystem::path& target,
                   const Limits& limits = {});

/// Why an entry may not have this name; empty when it may.
std::string whyNotCalled(const std::string& name, const Limits& limits = {});

}  // namespace unpack
