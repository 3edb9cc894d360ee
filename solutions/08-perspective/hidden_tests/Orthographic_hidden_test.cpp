#include "truth.h"

using namespace judge;

TEST(Orthographic, DrawnBoxes) {
    check("five boxes drawn from the seed land on the viewing box");
    for (int i = 0; i < 5; ++i) {
        const truth::Box box{
            judge::random().uniform(1.0f, 5.0f), judge::random().uniform(1.4f, 2.2f),
            judge::random().uniform(-1.0f, 2.0f), judge::random().uniform(4.0f, 9.0f)};
        truth::expectCorners(truth::expectProjection(box), box);
    }
}
