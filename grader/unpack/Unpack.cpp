#include "unpack/Unpack.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstring>
#include <memory>
#include <set>
#include <stdexcept>

#include "Files.h"
#include "report/PlainText.h"

namespace unpack {

namespace {

namespace fs = std::filesystem;

/// Why the archive as a whole is refused.
struct Refusal : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Old zip programs write names in the letters of their own country: what is not UTF-8 becomes '?'.
std::string inUtf8(std::string name) {
    for (auto bad = grader::firstInvalidUtf8(name); bad != std::string::npos;
         bad = grader::firstInvalidUtf8(name, bad))
        name[bad] = '?';
    return name;
}

/// A name as a sentence can hold it.
std::string shown(const std::string& name) {
    return "\"" + grader::shortened(grader::harmless(name), 80) + "\"";
}

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0)
            close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

private:
    int number_;
};

/// libarchive passes over the checksum at the end of a gzip stream, and what is damaged may well
/// unpack to something: zlib looks at it, in what may be unpacked at all.
bool isDamagedGzip(const fs::path& file, std::size_t most) {
    const gzFile stream = gzopen(file.c_str(), "rbe");
    if (!stream)
        return false;
    std::size_t bytes = 0;
    char block[65536];
    int got = 1;
    while (got > 0 && bytes <= most && !gzdirect(stream)) {
        got = gzread(stream, block, sizeof block);
        bytes += static_cast<std::size_t>(std::max(got, 0));
    }
    return gzclose_r(stream) != Z_OK || got < 0;
}

class Unpacker {
public:
    Unpacker(const fs::path& target, const Limits& limits)
        : target_(target), limits_(limits), reader_(archive_read_new(), archive_read_free) {
        archive_read_support_format_zip(reader_.get());
        archive_read_support_format_tar(reader_.get());
        archive_read_support_filter_gzip(reader_.get());
        archive_read_support_filter_xz(reader_.get());
        archive_read_support_filter_bzip2(reader_.get());
    }

    void run(const fs::path& file) {
        constexpr std::size_t kBlock = 65536;
        if (isDamagedGzip(file, limits_.bytes))
            throw Refusal("it is damaged or cut off: its checksum does not agree");
        if (archive_read_open_filename(reader_.get(), file.c_str(), kBlock) != ARCHIVE_OK)
            throw Refusal("it is no zip, tar, tar.gz, tar.xz or tar.bz2 archive, or a damaged one");
        while (archive_entry* entry = next())
            take(entry);
        if (files_ == 0)
            throw Refusal("it holds no file");
    }

private:
    archive_entry* next() {
        archive_entry* entry = nullptr;
        const int result = archive_read_next_header(reader_.get(), &entry);
        if (result == ARCHIVE_EOF)
            return nullptr;
        // A warning is about a name's letters or a time; the name is looked at below.
        if (result != ARCHIVE_OK && result != ARCHIVE_WARN)
            throw Refusal("it is damaged or cut off: " + reason());
        if (++entries_ > limits_.files)
            throw Refusal(fmt::format("it has more than {} files and folders", limits_.files));
        return entry;
    }

    void take(archive_entry* entry) {
        const char* utf8 = archive_entry_pathname_utf8(entry);
        const char* raw = utf8 ? utf8 : archive_entry_pathname(entry);
        const std::string name = inUtf8(raw ? raw : "");
        if (const std::string why = whyNotCalled(name, limits_); !why.empty())
            throw Refusal(why);
        if (archive_entry_hardlink(entry) || archive_entry_symlink(entry))
            throw Refusal(shown(name) + " is a link: hand in the file itself");
        if (archive_entry_is_encrypted(entry))
            throw Refusal("it is encrypted: hand in an archive without a password");
        const fs::path path = fs::path(name).lexically_normal();
        switch (archive_entry_filetype(entry)) {
            case AE_IFDIR:
                if (path != ".")  // what tar calls the folder that was packed
                    makeFolder(path, name);
                return;
            case AE_IFREG:
                if (path == ".")
                    throw Refusal(shown(name) + " is no name for a file");
                write(path, name);
                return;
            default:
                throw Refusal(shown(name) + " is neither a file nor a folder");
        }
    }

    void makeFolder(const fs::path& path, const std::string& name) {
        std::error_code failed;
        fs::create_directories(target_ / path, failed);
        if (failed)
            throw Refusal(shown(name) + " is a file and a folder");
    }

    void write(const fs::path& path, const std::string& name) {
        if (!names_.insert(path.string()).second)
            throw Refusal(shown(name) + " is in it twice");
        makeFolder(path.parent_path(), name);
        const Descriptor file(open((target_ / path).c_str(),
                                   O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
        if (file.number() < 0)
            throw Refusal(shown(name) + " is a file and a folder");
        ++files_;
        char block[65536];
        for (;;) {
            const auto got = archive_read_data(reader_.get(), block, sizeof block);
            if (got == 0)
                return;
            if (got < 0)
                throw Refusal(shown(name) + " is damaged or cut off: " + reason());
            bytes_ += static_cast<std::size_t>(got);
            if (bytes_ > limits_.bytes)
                throw Refusal(
                    fmt::format("its files take more than {} MiB unpacked", limits_.bytes >> 20));
            writeAll(file, block, static_cast<std::size_t>(got));
        }
    }

    /// The system may take less than all of it at once.
    static void writeAll(const Descriptor& file, const char* data, std::size_t size) {
        while (size > 0) {
            const ssize_t wrote = ::write(file.number(), data, size);
            if (wrote < 0 && errno == EINTR)
                continue;
            if (wrote < 0)
                throw std::runtime_error(std::string("cannot unpack: ") + std::strerror(errno));
            data += wrote;
            size -= static_cast<std::size_t>(wrote);
        }
    }

    std::string reason() const {
        const char* text = archive_error_string(reader_.get());
        return text ? grader::shortened(grader::harmless(text), 120) : "no more is known";
    }

    const fs::path& target_;
    const Limits& limits_;
    std::unique_ptr<archive, int (*)(archive*)> reader_;
    std::set<std::string> names_;
    std::size_t entries_ = 0, files_ = 0, bytes_ = 0;
};

}  // namespace

std::string whyNotCalled(const std::string& name, const Limits& limits) {
    if (name.empty())
        return "a file in it has no name";
    if (grader::harmless(name) != name || name.find('\\') != std::string::npos)
        return "the name " + shown(name) + " has a character that no file name should have";
    const fs::path path(name);
    if (path.is_absolute())
        return shown(name) + " is an absolute path";
    std::size_t depth = 0;
    for (const fs::path& part : path) {
        if (part == "..")
            return shown(name) + " leads out of the archive's folder";
        if (part.string().size() > limits.nameBytes)
            return fmt::format("the name {} is longer than {} bytes", shown(name),
                               limits.nameBytes);
        if (++depth > limits.depth)
            return fmt::format("{} is more than {} folders deep", shown(name), limits.depth);
    }
    return "";
}

std::string unpack(const fs::path& archive, const fs::path& target, const Limits& limits) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // libarchive needs one for names that are not ASCII
    try {
        Unpacker(target, limits).run(archive);
        return "";
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
}

}  // namespace unpack
