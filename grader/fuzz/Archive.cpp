// An archive that a student handed in: refused with a sentence, or unpacked inside its folder.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "Fuzz.h"
#include "report/PlainText.h"
#include "unpack/Unpack.h"

namespace fs = std::filesystem;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fs::path home = "/dev/shm/fuzz-archive-" + std::to_string(getpid());
    const fs::path file = home / "archive", target = home / "target";
    fs::create_directories(target);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), std::streamsize(size));
    const unpack::Limits limits{20, 1 << 20, 100, 5};
    const std::string refusal = unpack::unpack(file, target, limits);
    fuzz::require(grader::harmless(refusal) == refusal, "a refusal is harmless text");
    std::size_t files = 0, bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(target)) {
        fuzz::require(entry.is_directory() || entry.is_regular_file(), "files and folders only");
        fuzz::require(!entry.is_symlink(), "no links");
        bytes += entry.is_regular_file() ? entry.file_size() : 0;
        ++files;
    }
    fuzz::require(files <= limits.files * limits.depth && bytes <= limits.bytes, "within limits");
    fuzz::require(!refusal.empty() || files > 0, "what is not refused holds something");
    for (const auto& entry : fs::directory_iterator(home))
        fuzz::require(entry.path() == file || entry.path() == target, "nothing beside the folder");
    fs::remove_all(home);
    return 0;
}
