// eulerRodrigues, eqs. (6.14) and (6.15), compared with the truth and not with the student's other
// formula: agreement of two functions says nothing of which one is right.
#include "truth.h"

using namespace judge;
using truth::expectRotation;
using truth::otherUnitAxis;
using truth::unitAxis;

TEST(EulerRodrigues, ImageOfAVector) {
    check("eulerRodrigues turns (4, -1, 2) to the right place");
    const glm::vec3 v(4, -1, 2);
    const auto R = subject().call<glm::mat3>("eulerRodrigues", 50.0f, unitAxis);
    expectClose(say("eulerRodrigues(50, {}) times {}", unitAxis, v), R * v,
                truth::rotation(50.0f, unitAxis) * v);
}

TEST(EulerRodrigues, HalfTheAngle) {
    check("eulerRodrigues by 75 degrees is right: the matrix, and the angle that it turns by",
          "If it turns by 150 degrees: a, b, c, d of (6.14) are made of the cosine and sine of "
          "half the angle.");
    const glm::mat3 R = expectRotation("eulerRodrigues", 75.0f, otherUnitAxis);
    expectClose(say("the angle of eulerRodrigues(75, {})", otherUnitAxis), truth::angleDegrees(R),
                75.0f);
}

TEST(EulerRodrigues, Rigid) {
    check("eulerRodrigues by 110 degrees is right, and rigid: orthogonal columns of length 1",
          "If it bends: one wrong sign among ad, ac and ab is enough.");
    const glm::mat3 R = expectRotation("eulerRodrigues", 110.0f, unitAxis);
    expectClose(say("R^T R for R = eulerRodrigues(110, {})", unitAxis), glm::transpose(R) * R,
                glm::mat3(1.0f));
    expectClose(say("the determinant of eulerRodrigues(110, {})", unitAxis), glm::determinant(R),
                1.0f);
}

TEST(EulerRodrigues, KeepsTheAxis) {
    check("eulerRodrigues by 140 degrees is right, and what lies on the axis stays where it is");
    const glm::vec3 axis = judge::random().unitVector();
    const glm::mat3 R = expectRotation("eulerRodrigues", 140.0f, axis);
    expectClose(say("eulerRodrigues(140, a) times a for a = {}", axis), R * axis, axis);
}

TEST(EulerRodrigues, BeyondHalfATurn) {
    check("angles beyond 180 degrees and negative angles are right, too");
    expectRotation("eulerRodrigues", 250.0f, unitAxis);
    expectRotation("eulerRodrigues", -100.0f, otherUnitAxis);
}

TEST(EulerRodrigues, AxisOfAnyLength) {
    check("turns about axes of any length are right",
          "If only these are wrong: normalise the axis before you use it in (6.14).");
    expectRotation("eulerRodrigues", 50.0f, glm::vec3(1, 2, 3));
    expectRotation("eulerRodrigues", 85.0f, 0.2f * otherUnitAxis);
}
