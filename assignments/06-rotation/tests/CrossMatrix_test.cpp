// crossMatrix, eq. (6.7): [u x] v = u x v.
#include "truth.h"

using namespace judge;

namespace {

glm::mat3 crossMatrix(const glm::vec3& u) {
    return subject().call<glm::mat3>("crossMatrix", u);
}

void expectProduct(const glm::vec3& u, const glm::vec3& v) {
    expectClose(say("crossMatrix({}) times {}", u, v), crossMatrix(u) * v, glm::cross(u, v));
}

}  // namespace

TEST(CrossMatrix, OneTwoThree) {
    check("crossMatrix((1, 2, 3)) sends (4, 5, 6) to (-3, 6, -3)");
    expectProduct(glm::vec3(1, 2, 3), glm::vec3(4, 5, 6));
}

TEST(CrossMatrix, BasisVectors) {
    check("x cross y is z, y cross z is x, z cross x is y");
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    expectProduct(x, y);
    expectProduct(y, z);
    expectProduct(z, x);
}

TEST(CrossMatrix, EveryEntry) {
    check("all nine entries of the matrix are those of eq. (6.7)");
    const glm::vec3 u(2.0f, -3.0f, 5.0f);
    expectClose(say("crossMatrix({})", u), crossMatrix(u), truth::crossMatrix(u));
}

TEST(CrossMatrix, SwappingChangesTheSign) {
    check("u x v and v x u are right, one the negative of the other");
    const glm::vec3 u(0.5f, 2.0f, -1.5f), v(3.0f, -1.0f, 0.25f);
    expectProduct(u, v);
    expectProduct(v, u);
    const glm::mat3 M = crossMatrix(u);
    expectClose(say("the transpose of crossMatrix({})", u), glm::transpose(M),
                -truth::crossMatrix(u));
}

TEST(CrossMatrix, OrthogonalToBoth) {
    check("u x v is right, and orthogonal to u and to v");
    const glm::vec3 u = 2.0f * judge::random().unitVector(),
                    v = 3.0f * judge::random().unitVector();
    expectProduct(u, v);
    const glm::vec3 w = crossMatrix(u) * v;
    expectClose(say("(u x v) . u for u = {}, v = {}", u, v), glm::dot(w, u), 0.0f);
    expectClose(say("(u x v) . v for u = {}, v = {}", u, v), glm::dot(w, v), 0.0f);
}

TEST(CrossMatrix, GrowsWithItsVector) {
    check("the matrices of a vector and of twice the vector are right, the second twice the first");
    const glm::vec3 u(-0.3f, 0.4f, 1.2f);
    const glm::mat3 M = crossMatrix(u), twice = crossMatrix(2.0f * u);
    expectClose(say("crossMatrix({})", u), M, truth::crossMatrix(u));
    expectClose(say("crossMatrix({})", 2.0f * u), twice, 2.0f * truth::crossMatrix(u));
}
