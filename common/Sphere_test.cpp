#include "Sphere.h"

#include <cg/Error.h>
#include <cg/GlTest.h>
#include <cg/ReadBack.h>

namespace {

using SphereTest = cg::GlTest;

TEST_F(SphereTest, IsClosedAndLooksOutwards) {
    Sphere sphere;
    sphere.init();
    const cg::ReadBack mesh(sphere);
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
        EXPECT_NEAR(glm::length(mesh.positions[k]), 1.0f, 1e-6f);
        EXPECT_EQ(mesh.positions[k], mesh.normals[k]);
    }
    EXPECT_EQ(sphere.count, static_cast<int>(mesh.indices.size()));
    EXPECT_TRUE(mesh.isClosed());
    float area = 0.0f;
    for (std::size_t k = 0; k < mesh.indices.size() / 3; ++k) {
        EXPECT_GT(glm::dot(mesh.cross(k), mesh.normals[mesh.indices[3 * k]]), 0.0f) << k;
        area += glm::length(mesh.cross(k)) / 2;
    }
    EXPECT_NEAR(area, 4 * 3.14159265f, 0.1f);
}

TEST_F(SphereTest, ItsFinenessCanBeChosen) {
    Sphere sphere;
    sphere.slices = 3;
    sphere.stacks = 2;
    sphere.init();
    EXPECT_EQ(sphere.count, 18);  // two tetrahedra without their common face
    EXPECT_TRUE(cg::ReadBack(sphere).isClosed());
    sphere.stacks = 1;
    const auto message = cg::messageOf<cg::Error>([&] { sphere.init(); });
    EXPECT_NE(message.find("at least 3 slices and 2 stacks, found 3 and 1"), std::string::npos);
}

}  // namespace
