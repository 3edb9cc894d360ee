#include "levels.h"

using namespace judge;

TEST(Iterate, DrawnPoints) {
    check("I(c) is right at two hundred points drawn from the seed");
    const course::View view = course::drawnView(judge::random());
    std::vector<glm::vec2> points;
    while (points.size() < 200) {
        const float x = judge::random().uniform(-1.0f, 1.0f);
        const float y = judge::random().uniform(-1.0f, 1.0f);
        const glm::vec2 c = view.center + view.zoom * glm::vec2(x, y);
        if (levels::isFirm(c, view.maxiter))
            points.push_back(c);
    }
    levels::expectIndices(points, view.maxiter, view);
}
