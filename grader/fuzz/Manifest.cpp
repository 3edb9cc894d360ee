// assignment.json: whatever stands in it, a clear refusal or a manifest that holds together.

#include "Manifest.h"

#include "Error.h"
#include "Fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto manifest =
            grader::Manifest::parse(fuzz::textOf(data, size), "/course/assignments/07-camera");
        double points = 0;
        for (const grader::Task& task : manifest.tasks) {
            points += task.points;
            fuzz::require(manifest.task(task.id) != nullptr, "a task is found by its id");
            fuzz::require(manifest.framePoints(task.id) <= task.points + 1e-6,
                          "frames take no more than their task has");
        }
        fuzz::require(points > 99.99 && points < 100.01, "points add up to 100");
        for (const grader::Frame& frame : manifest.frames)
            fuzz::require(frame.width > 0 && frame.height > 0, "a frame has a size");
    } catch (const grader::Error&) {
    }
    return 0;
}
