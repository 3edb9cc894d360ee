#include "Carry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_help::Tree;
using testing_help::whatOf;

std::string region(const std::string& id, const std::string& body) {
    return "// BEGIN TODO(" + id + ")\n" + body + "\n// END TODO(" + id + ")\n";
}
const std::string kBlank = region("turn", "return cg::todo<int>(\"turn\");");
const std::string kSolved = region("turn", "return 1;");

/// A course of three: the second inherits a file of the first, and both hand in notes.cpp.
class Carries : public testing::Test {
protected:
    Carries() {
        addAssignment("01-turn", R"("turn.h", "turn.cpp", "notes.cpp")", "");
        addAssignment("02-look", R"("look.cpp", "notes.cpp")",
                      R"("turn.h": "01-turn", "turn.cpp": "01-turn")");
        addAssignment("03-rest", R"("rest.cpp")", "");
        write("01-turn/turn.h", "int turn();");
        write("01-turn/turn.cpp", kSolved);
        write("01-turn/notes.cpp", kSolved);
        write("02-look/notes.cpp", kBlank);
        write("02-look/look.cpp", kBlank);
        write("03-rest/rest.cpp", kBlank);
    }
    void addAssignment(const std::string& id, const std::string& submit,
                       const std::string& inherits) {
        write(id + "/assignment.json",
              fmt::format(R"({{"format": 1, "id": "{}", "title": "T", "chapter": 1,
                "summary": "S", "submit": [{}], "inherits": {{{}}},
                "tasks": [{{"id": "turn", "title": "T", "points": 100}}], "frames": []}})",
                          id, submit, inherits));
    }
    void write(const std::string& name, const std::string& text) {
        course.write("assignments/" + name, text);
    }
    std::string read(const std::string& name) const {
        return readFile(course / ("assignments/" + name));
    }
    bool exists(const std::string& name) const {
        return fs::exists(course / ("assignments/" + name));
    }
    std::string carried(bool force = false) const {
        return carry(course.path(), "01-turn", "02-look", force);
    }
    std::string refusal(const std::string& from = "01-turn",
                        const std::string& to = "02-look") const {
        return whatOf<Error>([&] { carry(course.path(), from, to, false); });
    }

    Tree course;
};

TEST_F(Carries, WhatIsInheritedAndWhatBothHandInIsCopied) {
    const std::string text = carried();
    EXPECT_EQ(read("02-look/turn.cpp"), kSolved);
    EXPECT_EQ(read("02-look/turn.h"), "int turn();");
    EXPECT_EQ(read("02-look/notes.cpp"), kSolved);
    EXPECT_EQ(read("02-look/notes.cpp.before-carry"), kBlank) << "even a starter is kept";
    EXPECT_EQ(read("01-turn/turn.cpp"), kSolved) << "a copy, not a move";
    EXPECT_THAT(text, HasSubstr("copied to assignments/02-look/turn.cpp\n"));
    EXPECT_THAT(text, HasSubstr("copied to assignments/02-look/notes.cpp; what was there is kept"));
    EXPECT_THAT(text, HasSubstr("From now on these count for 02-look"));
    EXPECT_THAT(carried(), HasSubstr("assignments/02-look/turn.cpp is the same file already"));
}

TEST_F(Carries, WhatTheStudentChangedIsNotOverwritten) {
    write("02-look/notes.cpp", region("turn", "return 2;"));
    EXPECT_THAT(refusal(), AllOf(HasSubstr("notes.cpp in "), HasSubstr("nothing was copied"),
                                 HasSubstr("--force")));
    EXPECT_FALSE(exists("02-look/turn.cpp")) << "nothing means nothing";
    EXPECT_EQ(read("02-look/notes.cpp"), region("turn", "return 2;"));

    carried(true);
    EXPECT_EQ(read("02-look/notes.cpp"), kSolved);
    EXPECT_EQ(read("02-look/notes.cpp.before-carry"), region("turn", "return 2;"));
    write("02-look/notes.cpp", "third");
    carried(true);
    EXPECT_EQ(read("02-look/notes.cpp.before-carry2"), "third") << "no backup is overwritten";
    EXPECT_EQ(read("02-look/notes.cpp.before-carry"), region("turn", "return 2;"));
}

TEST_F(Carries, WhatWasGoneOnWithInTheOldPlaceIsNotLostEither) {
    carried();
    write("01-turn/turn.cpp", kSolved + "// later\n");
    EXPECT_THAT(refusal(), HasSubstr("turn.cpp in "));
    carried(true);
    EXPECT_EQ(read("02-look/turn.cpp"), kSolved + "// later\n");
    EXPECT_EQ(read("02-look/turn.cpp.before-carry"), kSolved);
}

TEST_F(Carries, AStarterIsNotCarried) {
    write("01-turn/turn.cpp", kBlank);
    write("01-turn/notes.cpp", kBlank);
    EXPECT_THAT(refusal(), HasSubstr("01-turn has not been begun"));
    write("01-turn/turn.cpp", "// written without the regions\nint turn() { return 1; }\n");
    write("01-turn/notes.cpp", "// this one, too\n");
    EXPECT_EQ(refusal(), "");
}

TEST_F(Carries, WithNothingToCarryThePossiblePairsAreNamed) {
    EXPECT_THAT(refusal("01-turn", "03-rest"),
                AllOf(HasSubstr("03-rest uses no file that 01-turn hands in"),
                      HasSubstr("possible are: 01-turn 02-look")));
    EXPECT_THAT(refusal("02-look", "02-look"), HasSubstr("possible are"));
    EXPECT_THAT(refusal("04-none", "02-look"), HasSubstr("01-turn, 02-look, 03-rest"));
    EXPECT_THAT(refusal("01-turn", "04-none"), HasSubstr("04-none"));
}

TEST_F(Carries, AMissingFileIsNamed) {
    fs::remove(course / "assignments/01-turn/turn.h");
    EXPECT_THAT(refusal(), HasSubstr("assignments/01-turn/turn.h is missing"));
}

TEST_F(Carries, AFolderInTheWayIsNamed) {
    fs::create_directory(course / "assignments/02-look/turn.cpp");
    EXPECT_THAT(refusal(), HasSubstr("found something else"));
}

TEST_F(Carries, NamesAreThoseOfTheManifests) {
    EXPECT_THAT(carriedNames(loadAssignment(course.path(), "01-turn"),
                             loadAssignment(course.path(), "02-look")),
                ElementsAre("turn.h", "turn.cpp", "notes.cpp"));
}

}  // namespace
