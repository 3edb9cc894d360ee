#include "Portability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> noticesOf(const std::string& text, const std::string& name = "Camera.cpp",
                                   Role role = Role::own) {
    return portabilityNotices({{{name, role, "submission", text}}});
}

TEST(Portability, PiOfPosixIsNoticed) {
    EXPECT_THAT(
        noticesOf("int many = 1'000; float pi = float(M_PI);"),
        ElementsAre(AllOf(HasSubstr("Camera.cpp uses M_PI"), HasSubstr("std::numbers::pi"))));
    EXPECT_THAT(noticesOf("float root = M_SQRT2;"), ElementsAre(HasSubstr("M_SQRT2")));
}

TEST(Portability, PiIsFineWhereItWorksEverywhere) {
    EXPECT_THAT(noticesOf("#define _USE_MATH_DEFINES\n#include <cmath>\nfloat pi = M_PI;"),
                IsEmpty());
    EXPECT_THAT(noticesOf("#define M_PI 3.14159265\nfloat pi = M_PI;"), IsEmpty());
    EXPECT_THAT(noticesOf("// M_PI\nconst char* s = \"M_PI\"; float MY_M_PI_;"), IsEmpty());
}

TEST(Portability, NearAndFarAreNoticedBesideWindowsHeaders) {
    EXPECT_THAT(noticesOf("#include <GL/gl.h>\nfloat near = 1;"),
                ElementsAre(AllOf(HasSubstr("<GL/gl.h>"), HasSubstr("#undef near"))));
    EXPECT_THAT(noticesOf("float near = 1;"), IsEmpty()) << "as in the notes";
    EXPECT_THAT(noticesOf("#include <GL/gl.h>\nfloat nearer = 1;"), IsEmpty());
    EXPECT_THAT(noticesOf("#include <GL/gl.h>\n#undef near\n#undef far\nfloat near = 1;"),
                IsEmpty());
}

TEST(Portability, AHeaderInOneFileMattersToTheOthers) {
    const auto notices =
        portabilityNotices({{{"Camera.h", Role::own, "submission", "struct { float far; };"},
                             {"Camera.cpp", Role::own, "submission", "#include <GL/glu.h>"}}});
    EXPECT_THAT(notices, ElementsAre(HasSubstr("Camera.h uses the names near or far")));
}

TEST(Portability, OnlyTheStudentsOwnCppIsLookedAt) {
    EXPECT_THAT(noticesOf("float pi = M_PI;", "Camera.cpp", Role::inherited), IsEmpty());
    EXPECT_THAT(noticesOf("float pi = M_PI;", "scene.cpp", Role::provided), IsEmpty());
    EXPECT_THAT(noticesOf("uniform float M_PI;", "shaders/a.frag"), IsEmpty());
}

TEST(Portability, ANameInOtherCaseIsFound) {
    EXPECT_EQ(nameInOtherCase("camera.h", {"rotation.h", "Camera.h"}), "Camera.h");
    EXPECT_EQ(nameInOtherCase("shaders/A.frag", {"shaders/a.frag"}), "shaders/a.frag");
    EXPECT_EQ(nameInOtherCase("Camera.h", {"Camera.h"}), "") << "it is that one";
    EXPECT_EQ(nameInOtherCase("lens.h", {"Camera.h"}), "");
}

}  // namespace
