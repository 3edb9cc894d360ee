#include "Camera.h"

#include <gtest/gtest.h>

namespace {

void expectNear(const glm::vec3& got, const glm::vec3& expected) {
    EXPECT_NEAR(glm::distance(got, expected), 0.0f, 1e-5f) << got.x << " " << got.y << " " << got.z;
}

TEST(Camera, TurnsAsTheNotesSay) {
    Camera camera;
    camera.reset();
    camera.rotateRight(90.0f);
    expectNear(camera.eye, {0, 0, -5});
    camera.reset();
    camera.rotateUp(90.0f);
    expectNear(camera.eye, {0, 5, 0});
    expectNear(camera.up, {-1, 0, 0});
}

TEST(Camera, TurnsAboutATargetThatIsNotTheOrigin) {
    Camera camera;
    camera.target_default = {1, 2, 3};
    camera.eye_default = {1, 2, 8};
    camera.reset();
    camera.rotateRight(90.0f);
    expectNear(camera.eye, {6, 2, 3});
    expectNear(camera.target, {1, 2, 3});
}

TEST(Camera, ItsMatricesAreThoseOfTheNotes) {
    Camera camera;
    camera.reset();
    camera.fovy = 40.0f;
    camera.aspect = 1.6f;
    camera.near = 1.0f;
    camera.far = 6.0f;
    camera.computeMatrices();
    const glm::vec4 target = camera.view * glm::vec4(camera.target, 1.0f);
    expectNear(glm::vec3(target), {0, 0, -5});
    EXPECT_NEAR(camera.proj[0][0], 1.717f, 1e-3f);
    EXPECT_NEAR(camera.proj[1][1], 2.74748f, 1e-4f);
    EXPECT_NEAR(camera.proj[2][2], -1.4f, 1e-5f);
    EXPECT_NEAR(camera.proj[3][2], -2.4f, 1e-5f);
    EXPECT_EQ(camera.proj[2][3], -1.0f);
}

}  // namespace
