// What a changed assignment grades again, counts again, and leaves alone. The assignment is a copy,
// for a grader that was told to look there.

#include <gmock/gmock.h>

#include "Lab.h"

namespace {

using lab::Graded;
using lab::Json;
using lab::Submission;
using testing::HasSubstr;
using testing::Not;
namespace fs = lab::fs;

const std::string kCamera = "07-camera/Camera.cpp", kManifest = "assignments/07-camera";

class Regrade : public testing::Test {
protected:
    Regrade() {
        for (const char* tree : {"assignments", "solutions", "reference_images"})
            for (const char* id : {"06-rotation", "07-camera"}) {
                fs::create_directories(root() / tree);
                fs::copy(lab::root() / tree / id, root() / tree / id, fs::copy_options::recursive);
            }
        const fs::path ours = fs::path(COURSE_GRADER).parent_path();
        Json toolchain = lab::parseJsonFile((ours / "toolchain.json").string());
        toolchain["root"] = root().string();
        lab::writeFile(grader().parent_path() / "toolchain.json", toolchain.dump());
        std::error_code otherDisk;
        fs::create_hard_link(COURSE_GRADER, grader(), otherDisk);
        if (otherDisk)
            fs::copy_file(COURSE_GRADER, grader());

        put("honest", Submission());
        Submission turned;  // frames that are partly right, and a feature that is missing
        turned.solve(
            kCamera, "rotate-up",
            lab::readFile(lab::root() / "solutions/07-camera/mistakes/up-about-world-x.cpp"));
        turned.solve(
            "07-camera/shaders/transformed_normal.vert", "normal-transform",
            lab::readFile(lab::root() / "solutions/07-camera/mistakes/normal-by-modelview.vert"));
        put("turned", turned);
        Submission broken;
        broken.write(kCamera, "this is no C++\n");
        put("broken", broken);
        lab::writeFile(work_.path() / "class/text.zip", "my homework");
    }

    fs::path root() const { return work_.path() / "course"; }
    fs::path grader() const { return work_.path() / "bin/grader"; }
    fs::path out() const { return work_.path() / "out"; }
    void put(const std::string& name, const Submission& submission) const {
        fs::create_directories(work_.path() / "class" / name);
        fs::copy(submission.folder() / "07-camera", work_.path() / "class" / name / "07-camera",
                 fs::copy_options::recursive);
    }
    Graded batch(std::vector<std::string> more = {}) const {
        std::vector<std::string> command = {
            grader().string(), "batch",     (work_.path() / "class").string(),
            "--assignment",    "07-camera", "--out",
            out().string(),    "--seed",    "7"};
        command.insert(command.end(), more.begin(), more.end());
        const auto result = lab::run(command, 240);
        return {result.exitCode, result.output, nullptr};
    }
    /// Lets `change` loose on assignment.json.
    template <class Change>
    void rewrite(Change change) const {
        const fs::path file = root() / kManifest / "assignment.json";
        Json manifest = lab::parseJsonFile(file.string());
        change(manifest);
        lab::writeFile(file, manifest.dump(2));
    }
    void append(const std::string& file, const std::string& text) const {
        lab::writeFile(root() / file, lab::readFile(root() / file) + text);
    }
    /// All documents and reports, without the times.
    std::map<std::string, std::string> written() const {
        std::map<std::string, std::string> texts;
        for (const auto& entry : fs::recursive_directory_iterator(out())) {
            const std::string name = entry.path().lexically_relative(out()).string();
            if (name.ends_with("result.json")) {
                Json document = lab::parseJsonFile(entry.path().string());
                document.erase("timing");
                texts[name] = document.dump(2);
            } else if (name.ends_with(".html") || name.ends_with(".csv") ||
                       name.ends_with("results.json") || name.ends_with("report.txt")) {
                texts[name] = lab::readFile(entry.path());
            }
        }
        return texts;
    }
    static long countOf(const std::string& text, const std::string& part) {
        long count = 0;
        for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
            ++count;
        return count;
    }

    lab::WorkFolder work_;
};

TEST_F(Regrade, OnlyWhatDecidesResultsGradesAgain) {
    ASSERT_EQ(batch().exitCode, 0);
    append(kManifest + "/README.md", "\nOne more sentence.\n");
    append(kManifest + "/app.cpp", "\n// another window\n");
    append("assignments/06-rotation/README.md", "\nOne more sentence.\n");
    append("assignments/06-rotation/assignment.json", "\n");
    append("solutions/07-camera/mistakes/look-zero.cpp", "\n");
    EXPECT_EQ(countOf(batch().text, "(as before)"), 4) << "nothing that decides has changed";

    append(kManifest + "/harness.cpp", "\n// another harness\n");
    EXPECT_EQ(countOf(batch().text, "(as before)"), 0) << "what is built from has";
    rewrite([](Json& manifest) { manifest["limits"]["call_seconds"] = 3; });
    EXPECT_EQ(countOf(batch().text, "(as before)"), 0) << "a limit has";
    append("solutions/06-rotation/rotation.cpp", "\n// another solution\n");
    EXPECT_EQ(countOf(batch().text, "(as before)"), 0) << "what all inherit has";
}

TEST_F(Regrade, OtherPointsAndWordsCountAgainAsIfGradedAnew) {
    ASSERT_EQ(batch().exitCode, 0);
    const std::string before = lab::readFile(out() / "results.csv");
    rewrite([](Json& manifest) {
        for (Json& task : manifest["tasks"]) {
            task["title"] = "New: " + task["title"].get<std::string>();
            task["hint"] = "A new hint for " + task["id"].get<std::string>() + ".";
        }
        manifest["title"] = "New title";
        manifest["tasks"][0]["points"] = 18;
        manifest["tasks"][1]["points"] = 37;
        manifest["frames"][4]["points"] = 7.3;
        manifest["frames"][4]["title"] = "New frame";
        manifest["frames"][6]["features"][0]["points"] = 1.7;
    });
    const Graded counted = batch();
    EXPECT_EQ(counted.exitCode, 0) << counted.text;
    EXPECT_EQ(countOf(counted.text, "(as before)"), 4) << counted.text;
    const auto now = written();
    EXPECT_NE(now.at("results.csv"), before);
    EXPECT_THAT(now.at("students/turned/report/index.html"),
                HasSubstr("A new hint for rotate-up."));
    EXPECT_THAT(now.at("students/turned/report.txt"), HasSubstr("New: "));

    EXPECT_THAT(batch({"--fresh"}).text, Not(HasSubstr("(as before)")));
    const auto anew = written();
    ASSERT_EQ(now.size(), anew.size());
    for (const auto& [name, text] : anew)
        EXPECT_EQ(now.at(name), text) << name;

    rewrite([](Json& manifest) { manifest["frames"][4]["points"] = 0; });
    EXPECT_EQ(countOf(batch().text, "(as before)"), 0) << "what has no points is not scored";
}

}  // namespace
