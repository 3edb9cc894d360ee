// I(c) of section 4.4: the loop's index k at the moment when z leaves the circle of radius 2,
// counted from 0, and 0 when it stays inside for maxiter steps. A shader without a function
// `int iterate(vec2)` is judged by the level sets of its pictures.
#include "levels.h"

using namespace judge;
using course::View;
using levels::expectIndices;

namespace {

// Far from the edges of their levels, in all four quadrants; I(c) is 1, 2, 3 ... 16 in this order.
const std::vector<glm::vec2> points{
    {-1.1f, -1.22f},  {-0.67f, 1.13f}, {0.16f, 0.98f},   {-0.12f, -1.13f},
    {0.41f, -0.68f},  {-1.37f, 0.22f}, {0.32f, 0.67f},   {0.42f, -0.4f},
    {-0.49f, -0.66f}, {0.07f, 0.67f},  {-0.03f, -0.98f}, {-1.33f, -0.12f},
    {-0.07f, 0.98f},  {0.2f, -0.58f},  {-0.71f, -0.33f}, {0.44f, -0.38f}};

/// Zero alone proves nothing: a few points with another I(c) come along.
void expectZeros(const std::vector<glm::vec2>& zeros, int maxiter, const View& instead) {
    expectIndices(zeros, maxiter, instead);
    if (!testing::Test::HasFailure())
        expectIndices({points.begin(), points.begin() + 6}, maxiter, instead,
                      "of six points that leave it later, ");
}

}  // namespace

TEST(Iterate, KnownLevels) {
    check("I(c) is the index of the step that leaves the circle",
          "Step first, then compare: z = z^2 + c; if (|z| > 2) the result is k, before the loop "
          "adds 1 to it.");
    expectIndices(points, 60, course::crown);
}

TEST(Iterate, FirstStep) {
    check("I(c) is 0 when z leaves the circle in the first step, and right when it does so later",
          "z starts as 0, so that the first step leads to c; k still is 0 then.");
    expectZeros({{3, 0}, {-2.5f, 1}, {0, 10}, {1.9f, -1.2f}, {-1.7f, -1.6f}}, 40,
                {{-0.3f, 0.9f}, 1.6f, 20});
}

TEST(Iterate, Inside) {
    check("I(c) is 0 when z never leaves the circle, and right when it does so",
          "A c inside the set has I(c) = 0, not maxiter and not -1.");
    expectZeros({{0, 0},
                 {-1, 0},
                 {0.1f, 0.2f},
                 {-0.12f, -0.7f},
                 {-0.3f, 0.4f},
                 {-1.15f, 0.1f},
                 {-1.0f, -0.2f}},
                60, {{-0.55f, 0.3f}, 0.6f, 40});
}

TEST(Iterate, RadiusTwo) {
    check("an escape is |z| > 2: not less, and not more",
          "|z| > 2, or |z|^2 > 4: do not mix the two. With |z| = 2, z is still on the circle.");
    const View instead{{-0.7f, -0.6f}, 0.8f, 30};
    // On the way |z| comes between sqrt(2) and 2, or between 2 and 4.
    expectIndices(
        {{1.2f, 0.9f}, {-1.3f, -1.1f}, {0.9f, -1.2f}, {-1.9f, 0.8f}, {0.6f, 0.6f}, {-0.8f, -0.7f}},
        60, instead);
    // After the first step |z| is 2; both numbers and their squares are exact.
    if (!testing::Test::HasFailure())
        expectIndices({{0, 2}, {2, 0}, {0, -2}}, 60, instead,
                      "with |z| = 2 after the first step, ");
}

TEST(Iterate, LastStep) {
    check("an escape in the last step counts, and its index is maxiter - 1",
          "k runs from 0 to maxiter - 1, and the comparison comes after the step: with k < maxiter "
          "- 1, or with the comparison first, the last escape is lost.");
    if (!levels::valuesOf<std::vector<float>>("iterate", points, 1)) {
        levels::expectLastStepSeen({-0.4f, 0.6f}, 0.7f, 10);
        return;
    }
    for (const int last : {2, 5, 9, 16})
        expectIndices({points[static_cast<std::size_t>(last - 1)]}, last + 1, course::fewSteps);
}

TEST(Iterate, NotLaterThanMaxiter) {
    check(
        "with maxiter 4, 9 and 14, I(c) is right, and 0 for what leaves the circle only afterwards",
        "If it is not 0: the loop's bound is the uniform maxiter, not a number of your own.");
    for (const int maxiter : {4, 9, 14})
        expectIndices(points, maxiter, {{-0.4f, 0.6f}, 0.7f, maxiter});
}

TEST(Iterate, EveryPixel) {
    check("I(c) is right at every point of a grid");
    for (const View& view : {View{{-0.3f, 0.55f}, 0.8f, 45}, View{{-0.6f, -0.5f}, 1.5f, 17}}) {
        std::vector<glm::vec2> grid;
        for (int row = 1; row < levels::kSide; row += 5)
            for (int column = 2; column < levels::kSide; column += 5)
                if (const glm::vec2 c = levels::pointOf(view, column, row);
                    levels::isFirm(c, view.maxiter))
                    grid.push_back(c);
        expectIndices(grid, view.maxiter, view);
    }
}
