#include "Torus.h"

#include <cg/Error.h>
#include <cg/GlTest.h>
#include <cg/ReadBack.h>

namespace {

using TorusTest = cg::GlTest;

TEST_F(TorusTest, IsClosedAndLooksOutwards) {
    Torus torus;
    torus.init();
    const cg::ReadBack mesh(torus);
    ASSERT_EQ(mesh.positions.size(), 64u * 32u);
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
        const glm::vec3 p = mesh.positions[k];
        const glm::vec3 middle = glm::normalize(glm::vec3(p.x, 0.0f, p.z));
        EXPECT_NEAR(glm::distance(p, middle), 0.4f, 1e-6f);
        EXPECT_NEAR(glm::distance(mesh.normals[k], (p - middle) / 0.4f), 0.0f, 1e-5f);
    }
    EXPECT_TRUE(mesh.isClosed());
    float area = 0.0f;
    for (std::size_t k = 0; k < mesh.indices.size() / 3; ++k) {
        EXPECT_GT(glm::dot(mesh.cross(k), mesh.normals[mesh.indices[3 * k]]), 0.0f) << k;
        area += glm::length(mesh.cross(k)) / 2;
    }
    EXPECT_NEAR(area, 4 * 3.14159265f * 3.14159265f * 0.4f, 0.1f);
}

TEST_F(TorusTest, RefusesWhatIsNoTorus) {
    Torus torus;
    torus.tube = 1.5f;
    const auto message = cg::messageOf<cg::Error>([&] { torus.init(); });
    EXPECT_NE(message.find("a tube between 0 and 1"), std::string::npos);
    EXPECT_EQ(torus.vao, 0u);
}

}  // namespace
