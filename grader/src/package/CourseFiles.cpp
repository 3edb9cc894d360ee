#include "package/CourseFiles.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "Error.h"
#include "Git.h"

namespace grader {

namespace {

/// What git says about the course; throws Error where it says no.
std::string asked(const fs::path& root, const std::vector<std::string>& arguments) {
    const ProcessResult ran = git(root, arguments);
    if (ran.cut || ran.timedOut)
        throw Error("{}: a package is made of what git keeps, and git {} {}", root.string(),
                    arguments.front(),
                    ran.cut ? "lists more than is read: is something large kept by mistake?"
                            : "did not end within a minute: try again");
    if (!ran.succeeded())
        throw Error(
            "{}: a package is made of what git keeps, and git says: {}Make it a repository "
            "(git init, git add, git commit), or use a clone.",
            root.string(), ran.errors);
    return ran.output;
}

void refuseUncommitted(const fs::path& root) {
    const auto parts =
        zeroEnded(asked(root, {"status", "--porcelain", "-z", "--untracked-files=no", "--", "."}));
    std::string changed;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::string status = parts[i].substr(0, 2);
        changed += "\n  " + parts[i].substr(3);
        if (status.find_first_of("RC") != std::string::npos)
            ++i;  // the name of before
    }
    if (!changed.empty())
        throw Error(
            "a package is made of what is committed, and these files have changes that are "
            "not:{}\nCommit them, or put them away (git stash).",
            changed);
}

/// What is new in these folders and was forgotten would be missing without a word.
void refuseUntracked(const fs::path& root) {
    const std::string files = asked(
        root, {"ls-files", "-z", "--others", "--exclude-standard", "--", "assignments", "cmake",
               "common", "docs", "grader", "reference_images", "scripts", "solutions", "students"});
    std::string forgotten;
    for (const std::string& path : zeroEnded(files))
        forgotten += "\n  " + path;
    if (!forgotten.empty())
        throw Error(
            "a package is made of what is committed, and git does not keep these files:{}\nCommit "
            "them (git add, git commit), or take them away.",
            forgotten);
}

constexpr int kFileMode = 0644, kProgramMode = 0755;

struct CloseArchive {
    void operator()(archive* each) const { archive_write_free(each); }
};

void check(archive* writer, int status, const fs::path& file) {
    if (status < ARCHIVE_OK)
        throw Error("{} cannot be written: {}", file.string(), archive_error_string(writer));
}

/// libarchive writes a zip's times in the time zone of who packs; so that is UTC here. (Not while
/// other threads ask for the time.)
class InUtc {
public:
    InUtc() {
        if (const char* zone = std::getenv("TZ"))
            before_ = zone;
        setenv("TZ", "UTC0", 1);
        tzset();
    }
    ~InUtc() {
        before_ ? setenv("TZ", before_->c_str(), 1) : unsetenv("TZ");
        tzset();
    }
    InUtc(const InUtc&) = delete;
    InUtc& operator=(const InUtc&) = delete;

private:
    std::optional<std::string> before_;
};

void writeEntries(const CourseFiles& course, archive* writer, const fs::path& file) {
    for (const auto& [path, each] : course.files) {
        const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                             archive_entry_free);
        archive_entry_set_pathname_utf8(entry.get(), path.c_str());
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), each.executable ? kProgramMode : kFileMode);
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(each.content.size()));
        archive_entry_set_mtime(entry.get(), course.seconds, 0);
        check(writer, archive_write_header(writer, entry.get()), file);
        if (archive_write_data(writer, each.content.data(), each.content.size()) < 0)
            check(writer, ARCHIVE_FATAL, file);
    }
}

}  // namespace

void CourseFiles::remove(const std::string& path) {
    files.erase(path);
    std::erase_if(files, [&](const auto& each) { return each.first.starts_with(path + "/"); });
}

CourseFiles committedFiles(const fs::path& root, const std::string& without) {
    refuseUncommitted(root);
    refuseUntracked(root);
    CourseFiles course;
    course.commit = asked(root, {"rev-parse", "HEAD"}).substr(0, 40);
    course.seconds = std::stoll(asked(root, {"show", "-s", "--format=%ct", "HEAD"}));
    std::vector<std::string> list = {"ls-files", "-z", "--", "."};
    if (!without.empty())
        list.push_back(fmt::format(":(exclude,attr:{})", without));
    for (const std::string& path : zeroEnded(asked(root, list))) {
        const fs::path file = root / path;
        if (!fs::is_regular_file(fs::symlink_status(file)))
            throw Error("{}: expected a file; a package takes no link and no repository within",
                        file.string());
        const bool executable =
            (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none;
        course.files[path] = {readFile(file), executable};
    }
    return course;
}

void writeTree(const CourseFiles& course, const fs::path& folder) {
    static const std::set<std::string> archives = {".zip", ".tar", ".gz",  ".tgz", ".bz2", ".tbz",
                                                   ".xz",  ".txz", ".zst", ".7z",  ".rar"};
    if (archives.contains(folder.extension()))
        throw Error("{}: expected the name of a folder; no such archive is written here",
                    folder.string());
    if (fs::exists(folder) && !fs::is_directory(folder))
        throw Error("{} is a file: name a folder that is empty, or that does not exist yet",
                    folder.string());
    if (fs::exists(folder) && !fs::is_empty(folder))
        throw Error("{} is not empty: name a folder that is, or that does not exist yet",
                    folder.string());
    for (const auto& [path, each] : course.files) {
        fs::create_directories((folder / path).parent_path());
        writeFile(folder / path, each.content);
        fs::permissions(folder / path,
                        static_cast<fs::perms>(each.executable ? kProgramMode : kFileMode));
    }
}

void writeArchive(const CourseFiles& course, const fs::path& archive) {
    const std::string end = archive.extension();
    if (end != ".zip" && end != ".tar")
        throw Error("{}: expected a name that ends with .zip or .tar", archive.string());
    if (archive.has_parent_path())
        fs::create_directories(archive.parent_path());
    const fs::path made = archive.string() + ".new";
    const InUtc utc;
    try {
        const std::unique_ptr<::archive, CloseArchive> writer(archive_write_new());
        check(writer.get(),
              end == ".zip" ? archive_write_set_format_zip(writer.get())
                            : archive_write_set_format_pax_restricted(writer.get()),
              archive);
        check(writer.get(), archive_write_open_filename(writer.get(), made.c_str()), archive);
        writeEntries(course, writer.get(), archive);
        check(writer.get(), archive_write_close(writer.get()), archive);
        fs::rename(made, archive);
    } catch (...) {
        std::error_code ignored;
        fs::remove(made, ignored);
        throw;
    }
}

}  // namespace grader
