// The unit normal that shaders/transformed_normal.vert hands down, (7.41).
#include <subject/Judge.h>

#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "normal_truth.h"

using namespace judge;
using normal_truth::direction;
using normal_truth::expectDirections;
using normal_truth::expectUnit;
using normal_truth::Surface;

namespace {

const glm::mat4 one(1.0f);
const glm::mat4 turn = glm::rotate(glm::translate(one, {0.4f, -0.7f, -3.0f}), glm::radians(40.0f),
                                   glm::normalize(glm::vec3(0.3f, 0.9f, -0.2f)));
const glm::mat4 stretch = glm::scale(one, {1.0f, 2.0f, 0.5f});
const glm::vec3 slanted = direction({0.6f, 0.3f, 0.7f}), other = direction({-0.4f, 0.8f, 0.2f});

glm::mat4 shear() {
    glm::mat4 matrix(1.0f);
    matrix[1] = {0.7f, 1.0f, 0.0f, 0.0f};
    matrix[2] = {0.0f, -0.4f, 1.0f, 0.0f};
    return matrix;
}

}  // namespace

TEST(NormalTransform, Turned) {
    check("a normal turns with its model",
          "The 3x3 block of modelview is what acts on directions.");
    expectDirections({{turn, slanted}, {turn, other}});
}

TEST(NormalTransform, Stretched) {
    check("on a stretched model a normal stays orthogonal to the surface",
          "Take the inverse transpose of the 3x3 block, (7.40), not the block itself.");
    expectDirections({{turn * stretch, slanted}, {turn * stretch, other}});
}

TEST(NormalTransform, Sheared) {
    check("on a sheared model, too");
    expectDirections({{turn * shear(), slanted}, {turn * shear() * stretch, other}});
}

TEST(NormalTransform, UnitLength) {
    check("the normal that comes out has length 1, however long the one was that went in",
          "Normalise at the end.");
    expectUnit({{turn * stretch, slanted}, {turn, 0.6f * slanted}, {turn, 1.8f * other}});
}

TEST(NormalTransform, FarAway) {
    check("where the model stands changes nothing",
          "With vec4 and the 4x4 matrix, drop w before you normalise: it is not 0 any more.");
    glm::mat4 far = turn * stretch;
    far[3] = {6.0f, -4.0f, -15.0f, 1.0f};
    expectUnit({{far, slanted}, {far, other}});
}
