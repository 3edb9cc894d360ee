#include "truth.h"

using namespace judge;

namespace {

truth::Lens drawnLens() {
    return {judge::random().uniform(25.0f, 90.0f), judge::random().uniform(0.5f, 0.9f),
            judge::random().uniform(0.5f, 2.0f), judge::random().uniform(4.0f, 9.0f)};
}

}  // namespace

TEST(Perspective, DrawnLenses) {
    check("five lenses drawn from the seed have the right matrix");
    for (int i = 0; i < 5; ++i)
        truth::expectProjection(drawnLens());
}

TEST(Perspective, DrawnCorners) {
    check("the corners of three frusta drawn from the seed land on the viewing box");
    for (int i = 0; i < 3; ++i) {
        truth::Lens lens = drawnLens();
        lens.aspect += 0.8f;
        truth::expectCorners(truth::expectProjection(lens), lens);
    }
}
