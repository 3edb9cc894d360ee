#include "batch/Gallery.h"

#include <algorithm>
#include <map>
#include <set>

#include "Error.h"
#include "Manifest.h"
#include "batch/OverviewAssets.h"
#include "batch/Written.h"
#include "report/Html.h"

namespace grader {

namespace {

/// One picture of a frame, and how many have it.
struct Shown {
    std::string file;
    std::size_t count = 0;
};

class Gallery {
public:
    Gallery(const Manifest& manifest, const fs::path& students, const fs::path& into)
        : manifest_(manifest), students_(students), into_(into) {}

    GalleryCount write(const std::set<std::string>& submissions) {
        std::string sections;
        for (const Frame& frame : manifest_.frames)
            sections += section(frame, submissions);
        if (count_.pictures == 0)
            throw Error("no student in {} has a picture of {}", students_.string(), manifest_.id);
        count_.students = shown_.size();
        writeFile(
            into_ / "index.html",
            fmt::format("<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n"
                        "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; "
                        "style-src 'unsafe-inline'; img-src file: 'self'\">\n"
                        "<meta name=viewport content=\"width=device-width\">\n"
                        "<title>{0}</title>\n<style>{1}</style></head>\n"
                        "<body><h1>{0} <small>pictures of {2} students</small></h1>\n{3}"
                        "</body></html>\n",
                        escaped(manifest_.id + " " + manifest_.title), kOverviewStyle,
                        count_.students, sections));
        return count_;
    }

private:
    /// Where a student's report has a picture of the frame.
    fs::path pictureOf(const std::string& submission, const Frame& frame, const char* kind) const {
        return students_ / submission / "report" / manifest_.id /
               fmt::format("{}.{}.png", frame.id, kind);
    }

    std::string section(const Frame& frame, const std::set<std::string>& submissions) {
        std::map<std::string, Shown> byHash;  // an order that says nothing of whose they are
        fs::path reference;
        for (const std::string& each : submissions) {
            if (reference.empty() && fs::exists(pictureOf(each, frame, "reference")))
                reference = pictureOf(each, frame, "reference");
            const fs::path picture = pictureOf(each, frame, "submission");
            if (!fs::exists(picture))
                continue;
            const std::string bytes = readFile(picture), hash = sha256(bytes);
            Shown& shown = byHash[hash];
            if (shown.count++ == 0)
                shown.file = place(fmt::format("{}-{}.png", frame.id, hash.substr(0, 12)), bytes);
            shown_.insert(each);
        }
        if (byHash.empty())
            return "";
        std::vector<Shown> all;
        for (const auto& [hash, shown] : byHash)
            all.push_back(shown);
        std::stable_sort(all.begin(), all.end(),
                         [](const Shown& a, const Shown& b) { return a.count > b.count; });
        std::string figures;
        if (!reference.empty())
            figures = figure(frame, place(frame.id + ".png", readFile(reference)), "the reference",
                             " class=truth");
        for (const Shown& each : all)
            figures += figure(
                frame, each.file,
                each.count == 1 ? "one student" : fmt::format("{} students", each.count), "");
        count_.pictures += all.size();
        return fmt::format("<h2>{}</h2>\n<div class=gallery>\n{}</div>\n", escaped(frame.title),
                           figures);
    }

    /// Writes a picture. Returns its path, as seen from the page.
    std::string place(const std::string& name, const std::string& bytes) const {
        writeFile(into_ / manifest_.id / name, bytes);
        return manifest_.id + "/" + name;
    }

    static std::string figure(const Frame& frame, const std::string& file,
                              const std::string& caption, const char* attribute) {
        return fmt::format(
            "<figure{0}><a href=\"{1}\"><img loading=lazy src=\"{1}\" alt=\"{2}: {3}\"></a>"
            "<figcaption>{3}</figcaption></figure>\n",
            attribute, file, escaped(frame.title), caption);
    }

    const Manifest& manifest_;
    const fs::path students_, into_;
    std::set<std::string> shown_;  ///< submissions
    GalleryCount count_;
};

}  // namespace

GalleryCount writeGallery(const fs::path& course, const fs::path& results, const fs::path& into) {
    const fs::path file = results / "results.json";
    if (!fs::exists(file))
        throw Error("{} is not there: give the --out of a ./grade batch that ran to its end",
                    file.string());
    if (fs::exists(into) && !(fs::is_directory(into) && fs::is_empty(into)))
        throw Error("{} is there already and not an empty folder: choose another", into.string());
    std::string assignment;
    std::set<std::string> submissions;
    fromWritten(file, kGradeAgain, [&](const Json& document) {
        assignment = document.at("assignment");
        for (const Json& student : document.at("students"))
            if (const std::string name = student.at("submission"); !name.empty())
                submissions.insert(name);
    });
    const Manifest manifest = loadAssignment(course, assignment);
    return Gallery(manifest, results / "students", into).write(submissions);
}

}  // namespace grader
