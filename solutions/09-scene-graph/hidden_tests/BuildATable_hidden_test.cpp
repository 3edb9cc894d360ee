#include "table.h"

using namespace judge;
using namespace truth;

TEST(BuildATable, DrawnSizes) {
    check("five tables with sizes drawn from the seed are right");
    for (int k = 0; k < 5; ++k) {
        const auto length = [] { return judge::random().uniform(0.4f, 2.5f); };
        const float width = length(), height = length(), depth = length();
        if (!expectWhole({{width, height, depth}, judge::random().uniform(0.03f, 0.12f)}))
            return;
    }
}
