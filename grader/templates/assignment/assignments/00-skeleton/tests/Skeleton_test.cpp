// corner(), one task, one file; the suite is the task's id in PascalCase.
#include "truth.h"

using namespace judge;
using truth::expectCorner;

// AUTHOR: each test begins with check() and one sentence that a student understands. Ask in general
// position, and for a value beside each property: a constant must earn nothing in any test.

TEST(Skeleton, FirstOnTop) {
    check("corner 0 is on top, and the others are not");
    expectCorner(0, 5);
    expectCorner(2, 5);
}

TEST(Skeleton, CounterClockwise) {
    check("the corners follow each other counter-clockwise",
          "Corner 1 lies to the left of corner 0: its x is negative.");
    expectCorner(1, 5);
    expectCorner(1, 9);
}

TEST(Skeleton, OnceRound) {
    check("the n corners go round once",
          "The angle from one corner to the next is a full turn, 2 pi, divided by n as a float.");
    for (int i = 1; i < 7; ++i) {
        expectCorner(i, 7);
    }
}
