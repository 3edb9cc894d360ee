// buildTable: the nodes and transforms of a table with four legs. A piece is right when it fills
// the right box, whichever way round the cube lies in it.
#include "table.h"

using namespace judge;
using namespace truth;

namespace {

const Table ordinary{{1.7f, 1.1f, 0.9f}, 0.12f};
const Table low{{0.8f, 0.35f, 2.3f}, 0.07f};

}  // namespace

TEST(BuildATable, Top) {
    check("the top is as wide and deep as the table, and its upper side is at the table's height",
          "The cube reaches from -0.5 to 0.5: the top's middle is half a thickness below the "
          "height.");
    expectBox(ordinary, built(ordinary).pieces, ordinary.top());
}

TEST(BuildATable, Legs) {
    check(
        "four legs stand on the floor, reach the lower side of the top and are flush with its "
        "corners",
        "A leg's middle is half a thickness inside the corner, and it is height - thickness long.");
    const Built got = built(ordinary);
    for (const Box& leg : ordinary.legs()) {
        if (!expectBox(ordinary, got.pieces, leg))
            return;
    }
}

TEST(BuildATable, Whole) {
    check("the table has these five pieces and no other");
    expectWhole(ordinary);
}

TEST(BuildATable, AnotherSize) {
    check("a low, long table follows from the same function",
          "Use size and thickness; do not write numbers that suit one table.");
    expectWhole(low);
}

TEST(BuildATable, SharedLeg) {
    check("the four legs are one node: what hangs in it appears under every leg",
          "Hang one model in leg, and connect table with leg four times.");
    const Built got = built(ordinary);
    if (!expectThat(ordinary.tell() + ": edges from table to leg", got.legEdges == 4,
                    say("expected 4, found {}", got.legEdges)))
        return;
    std::vector<mat4> legs;
    for (const mat4& foot : got.feet)
        legs.push_back(foot * got.legPiece);
    for (const Box& leg : ordinary.legs()) {
        if (!expectBox(ordinary, legs, leg))
            return;
    }
}
