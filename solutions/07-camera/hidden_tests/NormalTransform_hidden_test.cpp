#include <glm/gtc/matrix_transform.hpp>

#include "normal_truth.h"

using namespace judge;

TEST(NormalTransform, DrawnModels) {
    check("five models drawn from the seed have the right normals");
    std::vector<normal_truth::Surface> surfaces;
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 shift = 3.0f * judge::random().unitVector();
        const glm::vec3 axis = judge::random().unitVector();
        const float degrees = judge::random().angle();
        const float x = judge::random().uniform(0.4f, 0.9f),
                    y = judge::random().uniform(1.1f, 2.5f);
        const glm::mat4 placed =
            glm::rotate(glm::translate(glm::mat4(1.0f), shift), glm::radians(degrees), axis);
        const glm::vec3 normal = judge::random().uniform(0.5f, 2.0f) * judge::random().unitVector();
        surfaces.push_back({glm::scale(placed, {x, y, 1.0f}), normal});
    }
    normal_truth::expectUnit(surfaces);
}
