#include "Manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Fields.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_help::Tree;
using testing_help::whatOf;

Json validManifest() {
    return Json::parse(R"json({
        "format": 1, "id": "07-camera", "title": "Camera", "chapter": 7, "summary": "A camera.",
        "submit": ["Camera.h", "Camera.cpp", "shaders/phong.frag"],
        "inherits": {"rotation.cpp": "06-rotation"},
        "limits": {"build_seconds": 30, "call_seconds": 1.5, "memory_mib": 512},
        "tasks": [
            {"id": "rotate-up", "title": "Up", "points": 60, "needs": ["06-rotation/rotation"],
             "hint": "Turn up too."},
            {"id": "look-at", "title": "View", "points": 40}],
        "frames": [{"id": "pole", "title": "Pole", "size": [400, 300], "task": "rotate-up",
                    "points": 6}],
        "starter_passes": ["LookAt.Something"]})json");
}

class LoadingManifest : public testing::Test {
protected:
    Manifest load() { return Manifest::load(written()); }
    /// The complaint about the manifest as it is now; it must name the file.
    std::string complaint() {
        const fs::path folder = written();
        std::string text = whatOf<Error>([&] { Manifest::load(folder); });
        const std::string file = (folder / "assignment.json").string();
        EXPECT_TRUE(text.empty() || text.starts_with(file + ": ")) << text;
        return text.empty() ? "none" : text.substr(file.size());
    }

    Json json = validManifest();

private:
    fs::path written() const {
        tree_.write("assignments/07-camera/assignment.json", json.dump(2));
        return tree_ / "assignments/07-camera";
    }
    Tree tree_;
};

TEST_F(LoadingManifest, AValidOneHasAllItsFields) {
    const Manifest manifest = load();
    EXPECT_EQ(manifest.id, "07-camera");
    EXPECT_EQ(manifest.title, "Camera");
    EXPECT_EQ(manifest.summary, "A camera.");
    EXPECT_EQ(manifest.chapter, 7);
    EXPECT_THAT(manifest.submit, ElementsAre("Camera.h", "Camera.cpp", "shaders/phong.frag"));
    EXPECT_EQ(manifest.inherits.at("rotation.cpp"), "06-rotation");
    EXPECT_EQ(manifest.limits.buildSeconds, 30);
    EXPECT_EQ(manifest.limits.callSeconds, 1.5);
    EXPECT_EQ(manifest.limits.frameSeconds, 4) << "what is not said has its default";
    EXPECT_EQ(manifest.limits.memoryMib, 512);
    ASSERT_EQ(manifest.tasks.size(), 2u);
    EXPECT_EQ(manifest.tasks[0].points, 60);
    EXPECT_THAT(manifest.tasks[0].needs, ElementsAre("06-rotation/rotation"));
    EXPECT_EQ(manifest.tasks[0].hint, "Turn up too.");
    ASSERT_EQ(manifest.frames.size(), 1u);
    EXPECT_EQ(manifest.frames[0].width, 400);
    EXPECT_EQ(manifest.frames[0].height, 300);
    EXPECT_EQ(manifest.frames[0].tolerance, 0.0005);
    EXPECT_THAT(manifest.starterPasses, ElementsAre("LookAt.Something"));
    EXPECT_EQ(manifest.framePoints("rotate-up"), 6);
    EXPECT_EQ(manifest.framePoints("look-at"), 0);
    EXPECT_EQ(manifest.task("look-at")->title, "View");
    EXPECT_EQ(manifest.task("none"), nullptr);
}

TEST_F(LoadingManifest, VisibilityIsOneOfThreeWords) {
    json["visibility"] = {{"LookAt.Something", "after_due_date"}, {"pole", "hidden"}};
    const Manifest manifest = load();
    EXPECT_EQ(manifest.visibilityOf("LookAt.Something"), kAfterDueDate);
    EXPECT_EQ(manifest.visibilityOf("pole"), kHidden);
    EXPECT_EQ(manifest.visibilityOf("LookAt.Other"), kVisible);
    json["visibility"] = {{"pole", "after_published"}};
    EXPECT_EQ(complaint(),
              ": field \"visibility\": \"pole\": expected visible, after_due_date or hidden, found "
              "\"after_published\"");
}

TEST_F(LoadingManifest, WhatMayBeLeftOut) {
    for (const char* name : {"inherits", "limits", "frames", "starter_passes"})
        json.erase(name);
    const Manifest manifest = load();
    EXPECT_EQ(manifest.limits.callSeconds, 2);
    EXPECT_TRUE(manifest.frames.empty());
}

TEST_F(LoadingManifest, AnIdIsANameOfFilesAndFolders) {
    for (const char* id : {"../../x", "a.b", "", "-a", "a b", "a/b"}) {
        json = validManifest();
        json["frames"][0]["id"] = id;
        EXPECT_THAT(complaint(), HasSubstr("is no id: expected letters, digits, - and _")) << id;
        json = validManifest();
        json["tasks"][0]["id"] = id;
        EXPECT_THAT(complaint(), HasSubstr("is no id")) << id;
    }
    json = validManifest();
    json["inherits"] = {{"rotation.cpp", "../06-rotation"}};
    EXPECT_THAT(complaint(), HasSubstr("is no id"));
}

TEST_F(LoadingManifest, AnUnknownFieldIsNamedWithTheAllowedOnes) {
    json["colour"] = "red";
    EXPECT_THAT(complaint(), AllOf(HasSubstr("unknown field \"colour\""), HasSubstr("chapter"),
                                   HasSubstr("starter_passes")));
}

TEST_F(LoadingManifest, AnUnknownFieldInsideIsFoundInItsPlace) {
    json["tasks"][1]["point"] = 3;
    EXPECT_THAT(complaint(), AllOf(HasSubstr("tasks[1]: unknown field \"point\""),
                                   HasSubstr("hint, id, manual, needs, points, title")));
    json = validManifest();
    json["frames"][0]["wide"] = 3;
    EXPECT_THAT(complaint(), HasSubstr("frames[0]: unknown field \"wide\""));
    json = validManifest();
    json["limits"]["seconds"] = 3;
    EXPECT_THAT(complaint(),
                AllOf(HasSubstr("limits: unknown field \"seconds\""), HasSubstr("call_seconds")));
}

TEST_F(LoadingManifest, ALimitThatNothingCanKeepIsRefused) {
    for (const char* name : {"build_seconds", "memory_mib", "output_kib"}) {
        json = validManifest();
        json["limits"][name] = 0;
        EXPECT_THAT(complaint(), HasSubstr("expected a number above 0"));
        json["limits"][name] = 18446744073709551615u;
        EXPECT_THAT(complaint(), HasSubstr("expected a whole number"));
    }
    json = validManifest();
    json["limits"]["frame_seconds"] = -1.5;
    EXPECT_THAT(complaint(), HasSubstr("expected a number above 0, at most 3600, found -1.5"));
    json["limits"]["frame_seconds"] = 1e9;
    EXPECT_THAT(complaint(), HasSubstr("at most 3600"));
}

TEST_F(LoadingManifest, AnotherFormatIsRefusedFirst) {
    json["format"] = 2;
    json["colour"] = "red";
    EXPECT_THAT(complaint(), HasSubstr("field \"format\": expected 1, found 2"));
}

TEST_F(LoadingManifest, AMissingFieldIsNamed) {
    json.erase("title");
    EXPECT_THAT(complaint(), HasSubstr("field \"title\" is missing"));
    json = validManifest();
    json["tasks"][0].erase("points");
    EXPECT_THAT(complaint(), HasSubstr("tasks[0]: field \"points\" is missing"));
    json = validManifest();
    json.erase("tasks");
    EXPECT_THAT(complaint(), HasSubstr("must add up to 100, found 0"));
}

TEST_F(LoadingManifest, AWrongKindIsNamedWithTheExpectedOne) {
    struct Case {
        const char* pointer;
        Json value;
        const char* complaint;
    };
    const Case cases[] = {
        {"/title", 7, "\"title\": expected a text, found 7"},
        {"/chapter", 7.5, "\"chapter\": expected a whole number, found 7.5"},
        {"/chapter", true, "\"chapter\": expected a whole number, found true"},
        {"/chapter", 5000000000, "\"chapter\": expected a whole number, found 5000000000"},
        {"/format", true, "\"format\": expected a whole number"},
        {"/submit", "Camera.h", "\"submit\": expected an array, each element a text"},
        {"/submit", {"a", 1}, "\"submit\": expected an array, each element a text"},
        {"/inherits", {{"a", 1}}, "\"inherits\": expected an object, each value a text"},
        {"/limits", 5, "limits: expected an object, found number"},
        {"/limits/memory_mib", "1G", "limits: field \"memory_mib\": expected a whole number"},
        {"/tasks", 5, "\"tasks\": expected an array, found number"},
        {"/tasks/0", "x", "tasks[0]: expected an object, found string"},
        {"/tasks/0/points", "60", "tasks[0]: field \"points\": expected a number, found \"60\""},
        {"/frames/0/size",
         {400.5, 300},
         "\"size\": expected an array, each element a whole number"},
    };
    for (const Case& each : cases) {
        json = validManifest();
        json[Json::json_pointer(each.pointer)] = each.value;
        EXPECT_THAT(complaint(), HasSubstr(each.complaint)) << each.pointer;
    }
}

TEST_F(LoadingManifest, PointsMustAddUp) {
    json["tasks"][1]["points"] = 39;
    EXPECT_THAT(complaint(), HasSubstr("must add up to 100, found 99"));
    json["tasks"][1]["points"] = -1;
    EXPECT_THAT(complaint(), HasSubstr("tasks[1]: points must be above 0, found -1"));
}

TEST_F(LoadingManifest, FramesBelongToATaskAndTakeNoMoreThanItHas) {
    json["frames"][0]["task"] = "rotate-left";
    EXPECT_THAT(complaint(), HasSubstr("frame \"pole\" names the unknown task \"rotate-left\""));
    json["frames"][0]["task"] = "rotate-up";
    json["frames"][0]["points"] = 61;
    EXPECT_THAT(complaint(), HasSubstr("frames of task \"rotate-up\" have more points"));
    json["frames"][0]["points"] = -6;
    EXPECT_THAT(complaint(), HasSubstr("frames[0]: points must not be below 0"));
}

TEST_F(LoadingManifest, AManualTasksFramesAreOnlyLookedAt) {
    json["frames"][0]["task"] = "rotate-up";
    json["frames"][0]["points"] = 6;
    for (Json& task : json["tasks"])
        task["manual"] = task["id"] == "rotate-up";
    EXPECT_THAT(complaint(), HasSubstr("task \"rotate-up\" is manual: its frames are looked at"));
}

TEST_F(LoadingManifest, IdsAreDistinct) {
    json["tasks"][1]["id"] = "rotate-up";
    EXPECT_THAT(complaint(), HasSubstr("two tasks have the id \"rotate-up\""));
    json = validManifest();
    json["frames"].push_back(json["frames"][0]);
    EXPECT_THAT(complaint(), HasSubstr("two frames have the id \"pole\""));
}

TEST_F(LoadingManifest, FileNamesStayInTheirFolder) {
    for (const char* name : {"../x", "/etc/passwd", "a/../../x", "", "./x", "a//", ".."}) {
        json = validManifest();
        json["submit"] = {name};
        EXPECT_THAT(complaint(), HasSubstr("is no file name below the assignment's folder"))
            << name;
        json = validManifest();
        json["inherits"] = {{name, "06-rotation"}};
        EXPECT_THAT(complaint(), HasSubstr("is no file name below the assignment's folder"))
            << name;
    }
}

TEST_F(LoadingManifest, ALooserToleranceNeedsAReason) {
    json["frames"][0]["tolerance"] = 0.001;
    EXPECT_THAT(complaint(), HasSubstr("frames[0]: a tolerance above 0.0005 needs a \"why\""));
    json["frames"][0]["why"] = "thin lines";
    EXPECT_EQ(load().frames[0].tolerance, 0.001);
    json["frames"][0] = validManifest()["frames"][0];
    json["frames"][0]["tolerance"] = 0.0001;
    EXPECT_EQ(load().frames[0].tolerance, 0.0001) << "a tighter one needs none";
}

TEST_F(LoadingManifest, ASizeIsTwoSidesInPixels) {
    for (const Json& size :
         {Json{400}, Json{400, 300, 2}, Json{0, 300}, Json{400, -1}, Json{3001, 1}}) {
        json["frames"][0]["size"] = size;
        EXPECT_THAT(complaint(),
                    HasSubstr("\"size\": expected [width, height] in pixels, 1 to 3000"))
            << size.dump();
    }
}

TEST_F(LoadingManifest, TheIdIsTheFoldersName) {
    json["id"] = "08-camera";
    EXPECT_THAT(complaint(),
                HasSubstr("expected the folder's name \"07-camera\", found \"08-camera\""));
}

TEST(Manifest, WhatIsNoJsonIsNamedWithThePlace) {
    const Tree tree;
    tree.write("a/assignment.json", "{\n  \"format\": 1,\n}");
    EXPECT_THAT(whatOf<Error>([&] { Manifest::load(tree / "a"); }),
                AllOf(HasSubstr("a/assignment.json: not JSON"), HasSubstr("line 3")));
    tree.write("a/assignment.json", "[]");
    EXPECT_THAT(whatOf<Error>([&] { Manifest::load(tree / "a"); }),
                HasSubstr("expected an object, found array"));
    EXPECT_THAT(whatOf<Error>([&] { Manifest::load(tree / "b"); }), HasSubstr("No such file"));
}

TEST(Manifest, ASuiteIsTheIdInPascalCase) {
    const auto suiteOf = [](const std::string& id) {
        Task task;
        task.id = id;
        return task.suite();
    };
    EXPECT_EQ(suiteOf("rotate-up"), "RotateUp");
    EXPECT_EQ(suiteOf("look-at"), "LookAt");
    EXPECT_EQ(suiteOf("rotation"), "Rotation");
    EXPECT_EQ(suiteOf("phase-2-light"), "Phase2Light");
}

TEST(Assignments, AnUnknownOneListsTheKnownOnesInOrder) {
    const Tree tree;
    tree.write("assignments/08-perspective/assignment.json", "{}");
    tree.write("assignments/06-rotation/assignment.json", "{}");
    tree.write("assignments/shared/notes.md", "no assignment");
    tree.write("assignments/FORMAT.md", "");
    EXPECT_THAT(knownAssignments(tree.path()), ElementsAre("06-rotation", "08-perspective"));
    EXPECT_EQ(whatOf<Error>([&] { loadAssignment(tree.path(), "07-kamera"); }),
              "there is no assignment \"07-kamera\"; known are 06-rotation, 08-perspective");
    EXPECT_THAT(whatOf<Error>([&] { loadAssignment(tree.path(), "../x"); }),
                HasSubstr("there is no assignment"));
}

TEST(Assignments, AFolderWithTheIdOfAnotherIsLeftOutAndNamedOnce) {
    const Tree tree;
    tree.write("assignments/07-camera/assignment.json", validManifest().dump());
    tree.write("assignments/07-camera (copy)/assignment.json", validManifest().dump());
    testing::internal::CaptureStderr();
    for (int i = 0; i < 2; ++i)
        EXPECT_THAT(knownAssignments(tree.path()), ElementsAre("07-camera"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "assignments/07-camera (copy) is a copy of 07-camera, left out: its assignment.json "
              "has that id\n");
    EXPECT_THAT(whatOf<Error>([&] { loadAssignment(tree.path(), "07-camera (copy)"); }),
                HasSubstr("expected the folder's name \"07-camera (copy)\", found \"07-camera\""));
}

TEST(Assignments, ACourseWithoutAnyIsRefused) {
    const Tree tree;
    fs::create_directories(tree / "assignments");
    EXPECT_THAT(whatOf<Error>([&] { knownAssignments(tree.path()); }),
                HasSubstr("holds no assignment"));
}

}  // namespace
