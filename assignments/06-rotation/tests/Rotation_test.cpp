// rotation, eq. (6.13). Every property is asked together with the right value: the identity has
// nearly all the properties of a rotation, and earns nothing.
#include "truth.h"

using namespace judge;
using truth::expectRotation;
using truth::otherUnitAxis;
using truth::unitAxis;

TEST(Rotation, ImageOfAVector) {
    check("rotation turns (4, -1, 2) to the right place");
    const glm::vec3 v(4, -1, 2);
    const auto R = subject().call<glm::mat3>("rotation", 50.0f, unitAxis);
    expectClose(say("rotation(50, {}) times {}", unitAxis, v), R * v,
                truth::rotation(50.0f, unitAxis) * v);
}

TEST(Rotation, CounterClockwise) {
    check("35 degrees about z, x and y turn counter-clockwise, to the right places",
          "With the axis z, x turns towards y. If yours turns the other way, look at the sign of "
          "the sine and at rows and columns.");
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const float c = std::cos(glm::radians(35.0f)), s = std::sin(glm::radians(35.0f));
    const auto turned = [](const glm::vec3& axis, const glm::vec3& v) {
        return subject().call<glm::mat3>("rotation", 35.0f, axis) * v;
    };
    expectClose(say("rotation(35, z) times x"), turned(z, x), c * x + s * y);
    expectClose(say("rotation(35, x) times y"), turned(x, y), c * y + s * z);
    expectClose(say("rotation(35, y) times z"), turned(y, z), c * z + s * x);
}

TEST(Rotation, AngleInDegrees) {
    check("rotation by 75 degrees is right: the matrix, and the angle that it turns by",
          "If it is the angle: it comes in degrees, and std::sin and std::cos want radians.");
    const glm::mat3 R = expectRotation("rotation", 75.0f, otherUnitAxis);
    expectClose(say("the angle of rotation(75, {})", otherUnitAxis), truth::angleDegrees(R), 75.0f);
}

TEST(Rotation, Rigid) {
    check("rotation by 115 degrees is right, and rigid: orthogonal columns of length 1",
          "If it bends or stretches: away from 60 degrees, cos and 1 - cos differ; a a^T is a "
          "matrix, not the number 1.");
    const float degrees = 115.0f;
    const glm::mat3 R = expectRotation("rotation", degrees, unitAxis);
    expectClose(say("R^T R for R = rotation({}, {})", degrees, unitAxis), glm::transpose(R) * R,
                glm::mat3(1.0f));
    expectClose(say("the determinant of rotation({}, {})", degrees, unitAxis), glm::determinant(R),
                1.0f);
}

TEST(Rotation, KeepsTheAxis) {
    check("rotation by 130 degrees is right, and what lies on the axis stays where it is");
    const glm::vec3 axis = judge::random().unitVector();
    const glm::mat3 R = expectRotation("rotation", 130.0f, axis);
    expectClose(say("rotation(130, a) times 2 a for a = {}", axis), R * (2.0f * axis), 2.0f * axis);
}

TEST(Rotation, BackByTheNegativeAngle) {
    check("65 and -65 degrees are right, and one turns back what the other turned");
    const glm::mat3 there = expectRotation("rotation", 65.0f, otherUnitAxis);
    const glm::mat3 back = expectRotation("rotation", -65.0f, otherUnitAxis);
    expectClose(say("rotation(-65, a) rotation(65, a) for a = {}", otherUnitAxis), back * there,
                glm::mat3(1.0f));
}

TEST(Rotation, AnglesAddUp) {
    check("40, 70 and 410 degrees are right, and 40 and then 70 degrees are 110");
    const glm::mat3 first = expectRotation("rotation", 40.0f, unitAxis);
    const glm::mat3 second = expectRotation("rotation", 70.0f, unitAxis);
    expectClose(say("rotation(70, a) rotation(40, a) for a = {}", unitAxis), second * first,
                truth::rotation(110.0f, unitAxis));
    expectRotation("rotation", 410.0f, unitAxis);
}

TEST(Rotation, AxisOfAnyLength) {
    check("turns about axes of any length are right",
          "If only these are wrong: exercise 6.1 normalises the axis first, glm::normalize(axis).");
    expectRotation("rotation", 50.0f, glm::vec3(1, 2, 3));
    expectRotation("rotation", 85.0f, 0.2f * otherUnitAxis);
}
