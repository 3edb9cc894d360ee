#include "products.h"

using namespace judge;

TEST(Cprod, DrawnNumbers) {
    check("twenty products drawn from the seed are right");
    std::vector<glm::vec2> a, b;
    for (int i = 0; i < 20; ++i) {
        const auto part = [] { return judge::random().uniform(-3.0f, 3.0f); };
        const float ax = part(), ay = part(), bx = part(), by = part();
        a.emplace_back(ax, ay);
        b.emplace_back(bx, by);
    }
    products::expectProducts(a, b);
}
