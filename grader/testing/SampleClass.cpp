// sample_class FOLDER COUNT: writes the overview of a class of so many, from results made by hand,
// as a batch leaves it: for tests of the page in a browser.

#include <iostream>

#include "ImageModule.h"
#include "batch/Overview.h"
#include "testing/Results.h"

namespace {

using namespace grader;

const std::string kHostileName = "<img src=x onerror=\"window.hacked=1\"> \"the\" 'first'";
constexpr int kSide = 24;

Picture greyOf(std::uint8_t grey) {
    Picture picture{kSide, kSide, {}};
    for (int i = 0; i < kSide * kSide; ++i)
        picture.rgba.insert(picture.rgba.end(), {grey, grey, 90, 255});
    return picture;
}

Manifest manifest() {
    Manifest made;
    made.id = "07-camera";
    made.title = "Camera";
    made.tasks = {{"look-at", "View", "", 60, {}}, {"rotate-up", "Up", "", 40, {}}};
    made.frames.resize(2);
    made.frames[0].id = "orbit";
    made.frames[1].id = "turned";
    return made;
}

/// The k-th student: some late, some without a mark, one of an odd name.
Mark markOf(int k, const fs::path& out) {
    Mark mark;
    mark.student = {fmt::format("s{:03}", k), k == 0 ? kHostileName : fmt::format("Name {}", k), "",
                    k % 2 ? "A" : "B"};
    mark.status = k % 50 == 7 ? "missing" : k % 50 == 8 ? "refused" : "graded";
    mark.maxPoints = 100;
    const double up = k % 41;
    mark.tasks = {{"look-at", 60, 60, 60, false, ""}, {"rotate-up", up, up, 40, false, ""}};
    if (mark.status != "graded") {
        mark.sentence = mark.status == "refused" ? "the archive is refused: it is encrypted" : "";
        mark.tasks[0].points = mark.tasks[1].points = 0;
        return mark;
    }
    mark.points = 60 + up;
    if (k % 10 == 3)
        mark.lateness = {true, 2, 0, "2 days late"};
    mark.submission = mark.student.id;
    Essence essence;
    for (const char* frame : {"orbit", "turned"}) {
        const std::string path = fmt::format("07-camera/{}.submission.png", frame);
        writePicture(out / "students" / mark.submission / "report" / path,
                     greyOf(static_cast<std::uint8_t>(k % 256)));
        essence.checks.push_back(
            {frame, "a frame", up < 40 ? "fail" : "pass", up, 40, "", interned(path)});
    }
    writeFile(out / "students" / mark.submission / "report/index.html", "<!doctype html>report");
    essence.tasks = {{"rotate-up", up, k % 3 ? "You turn the target." : "You tilt."}};
    mark.result = std::make_shared<Essence>(std::move(essence));
    return mark;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    const fs::path out = argv[1];
    std::vector<Mark> marks;
    for (int k = 0; k < std::stoi(argv[2]); ++k)
        marks.push_back(markOf(k, out));
    writePicture(out / "students/s000/report/07-camera/orbit.reference.png", greyOf(200));
    const Manifest made = manifest();
    const std::vector<std::string> notTaken = {"list.txt: neither a folder nor an archive"}, none;
    writeOverview({made,
                   marks,
                   notTaken,
                   {{"s001", "s002", 0.9, false}},
                   none,
                   7,
                   Json{{"sandbox", "bubblewrap"}}},
                  out);
}
