#include "Files.h"

#include <sha2.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "Error.h"

namespace grader {

std::string readFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    if (!file || fs::is_directory(path))
        throw Error("{} cannot be read: {}", path.string(),
                    fs::is_directory(path) ? "it is a folder" : std::strerror(errno));
    return content.str();
}

void writeFile(const fs::path& path, const std::string& content) {
    if (path.has_parent_path())
        fs::create_directories(path.parent_path());
    const fs::path temporary = path.string() + ".new" + std::to_string(getpid());
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    file.close();
    if (!file) {
        const int why = errno;
        unlink(temporary.c_str());
        throw Error("{} cannot be written: {}", path.string(), std::strerror(why));
    }
    fs::rename(temporary, path);
}

std::string sha256(const std::string& data) {
    char digest[SHA256_DIGEST_STRING_LENGTH];
    SHA256Data(reinterpret_cast<const std::uint8_t*>(data.data()), data.size(), digest);
    return digest;
}

std::size_t firstInvalidUtf8(const std::string& text, std::size_t from) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (std::size_t i = from; i < text.size();) {
        const unsigned char first = byte(i);
        std::size_t following = 0;
        unsigned low = 0x80, high = 0xBF;  // of the second byte
        if (first >= 0xC2 && first <= 0xDF)
            following = 1;
        else if (first >= 0xE0 && first <= 0xEF)
            following = 2, low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
        else if (first >= 0xF0 && first <= 0xF4)
            following = 3, low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
        else if (first >= 0x80)
            return i;
        if (first == 0 || i + following >= text.size() + (following == 0))
            return i;
        for (std::size_t k = 1; k <= following; ++k, low = 0x80, high = 0xBF)
            if (byte(i + k) < low || byte(i + k) > high)
                return i;
        i += following + 1;
    }
    return std::string::npos;
}

WorkFolder::WorkFolder() {
    std::string name = (fs::temp_directory_path() / "course-XXXXXX").string();
    if (!mkdtemp(name.data()))
        throw Error("no folder can be made for the work in {}: {}",
                    fs::temp_directory_path().string(), std::strerror(errno));
    path_ = name;
    chmod(name.c_str(), 0711);  // sandboxes pass through, nobody can list it
}

WorkFolder::~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace grader
