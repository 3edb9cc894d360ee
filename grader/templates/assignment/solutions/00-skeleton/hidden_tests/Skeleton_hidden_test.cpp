#include "truth.h"

using namespace judge;

// AUTHOR: asks the same as the public tests, with other numbers; its points are part of the task's.
TEST(Skeleton, DrawnCorners) {
    check("five corners drawn from the seed are right");
    for (int k = 0; k < 5; ++k) {
        const int n = int(judge::random().uniform(5.0f, 20.0f));
        truth::expectCorner(int(judge::random().uniform(1.0f, float(n))), n);
    }
}
