#include "levels.h"

using namespace judge;

TEST(Colour, HiddenPlaces) {
    check("two more places drawn from the seed are right");
    for (int i = 0; i < 2; ++i)
        levels::expectPicture(course::drawnView(judge::random()));
}
