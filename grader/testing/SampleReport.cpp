#include <cmath>

#include "report/HtmlReport.h"
#include "testing/Results.h"

/// sample_report FOLDER [TEXT]: writes a report that has everything a report can have, from results
/// made by hand. With TEXT, each text that can come from a student is that one.

namespace {

using namespace grader;
using testing_help::check;
using testing_help::task;

constexpr int kWidth = 400, kHeight = 300;

struct Ball {
    double x, y, radius;
    bool glint;
    bool covers(int px, int py) const { return std::hypot(px - x, py - y) <= radius; }
    bool shines(int px, int py) const {
        return glint && std::hypot(px - x + radius / 3, py - y + radius / 3) <= radius / 5;
    }
};

Picture drawn(const Ball& ball) {
    Picture picture{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double light =
                1 - std::hypot(x - ball.x + 30, y - ball.y + 30) / (2 * ball.radius);
            const auto shade = static_cast<std::uint8_t>(60 + 180 * std::max(0.0, light));
            if (ball.shines(x, y))
                picture.rgba.insert(picture.rgba.end(), {255, 250, 235, 255});
            else if (ball.covers(x, y))
                picture.rgba.insert(picture.rgba.end(),
                                    {shade, static_cast<std::uint8_t>(shade / 2), 40, 255});
            else
                picture.rgba.insert(picture.rgba.end(), {26, 51, 77, 255});
        }
    return picture;
}

Picture maskOf(const Ball& ball) {
    Picture picture{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const std::uint8_t value = ball.shines(x, y) ? 255 : 0;
            picture.rgba.insert(picture.rgba.end(), {value, value, value, 255});
        }
    return picture;
}

CheckResult frameOf(const std::string& id, Status status, const Ball& yours,
                    const Ball& reference) {
    CheckResult frame = check(id, status, status == Status::pass ? 10 : 4, 10);
    frame.kind = "frame";
    frame.title = "A ball under a lamp";
    frame.pictures.emplace();
    frame.pictures->submission = drawn(yours);
    frame.pictures->reference = drawn(reference);
    frame.pictures->score.outliers = status == Status::pass ? 0 : 0.081;
    if (status == Status::pass)
        return frame;
    frame.message = "8.1 % of the pixels differ, mostly in the middle";
    frame.hint = "Look at where the highlight is.";
    frame.features = {
        {"outline", "the outline of the ball", 4, 5, "86 % of it is where it belongs", {}},
        {"glint", "the highlight", 0, 3, "there is none at the top left", maskOf(reference)},
        {"ground", "the background", 2, 2, "", {}}};
    return frame;
}

AssignmentResult sample() {
    AssignmentResult result = testing_help::sampleResult();
    CheckResult& lost = result.tasks[1].checks[1];
    lost.message = "rotation(50, (1, 2, 3)): two entries are wrong";
    lost.comparison = {"rotation(50, (1, 2, 3))",
                       {{0.6683, -0.5631, 0.486}, {0.6652, 0.7449, -0.051}, {-0.33, 0.36, 0.87}},
                       {{0.6683, 0.5631, 0.486}, {0.6652, 0.7449, -0.051}, {-0.33, NAN, 0.87}},
                       0.0001};
    const Ball right{200, 150, 80, true}, wrong{212, 154, 80, false};
    result.tasks.push_back(
        task("highlights", Status::partial,
             {frameOf("glossy", Status::partial, wrong, right),
              frameOf("matt", Status::pass, right, right),
              check("Highlights.A", Status::fail, 0, 5, "expected 1, got 2", "Halve it."),
              check("Highlights.B", Status::fail, 0, 5, "expected (1, 2), got (2, 1)", "Halve it."),
              check("Highlights.C", Status::crash, 0, 5, "std::runtime_error: out of range")}));
    result.tasks[2].recognised = {
        {"highlight-missing"}, "The highlight is missing: h is not normalised.", "10.3.3"};
    result.tasks.push_back(
        task("fog", Status::notImplemented,
             {check("Fog.A", Status::notImplemented, 0, 10, "`fog` is not implemented yet")}));
    result.diagnostics = {
        {"Camera.cpp", 17, 11, "warning", "unused variable 'a'", "    float a = b;"}};
    result.notices = {"Camera.h is missing: graded with the starter's file"};
    return result;
}

void overwrite(AssignmentResult& result, const std::string& text) {
    result.notices = result.ignoredFiles = {text};
    result.diagnostics = {{text, 1, 2, "error", text, text}, {text, 1, 2, "warning", text, text}};
    for (TaskResult& each : result.tasks)
        for (CheckResult& check : each.checks) {
            check.message = check.hint = text;
            if (check.comparison)
                check.comparison->what = text;
            for (FeatureResult& feature : check.features)
                feature.message = text;
        }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2)
        return 2;
    std::vector<AssignmentResult> results = {sample()};
    if (argc > 2)
        overwrite(results[0], argv[2]);
    writeReportPictures(results, argv[1]);
    writeFile(fs::path(argv[1]) / "index.html", htmlReport(results, argv[1]));
}
