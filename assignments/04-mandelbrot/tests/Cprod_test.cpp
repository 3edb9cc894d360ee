// The product of complex numbers. A shader without a function `vec2 cprod(vec2, vec2)` multiplies
// somewhere else, and then I(c) tells whether it does so rightly.
#include "products.h"

using namespace judge;
using products::expectProducts;

TEST(Cprod, AllSigns) {
    check("products of numbers with positive and negative parts are right",
          "(a + b i)(c + d i) = (ac - bd) + (ad + bc) i, because i times i is -1.");
    expectProducts({{2, 3}, {-2, 3}, {2, -3}, {-2, -3}}, {{4, 5}, {4, 5}, {-4, 5}, {4, -5}});
}

TEST(Cprod, Imaginary) {
    check("i times i is -1, and a real number only stretches",
          "Two imaginary parts give a negative real part: ac - bd.");
    expectProducts({{0, 1}, {0, -3}, {2.5f, 0}, {0, 2}}, {{0, 1}, {0, 2}, {-1, 4}, {1.5f, -1}});
}

TEST(Cprod, Squares) {
    check("the square of x + y i is x^2 - y^2 + 2xy i, also for negative parts",
          "Write x * x: pow(x, 2.0) is undefined for negative x and gives black places on some "
          "machines. 2xy is the sum of two equal products.");
    const std::vector<glm::vec2> numbers{
        {1.5f, 0.5f}, {-1.2f, 0.7f}, {0.3f, -1.9f}, {-0.8f, -0.6f}};
    expectProducts(numbers, numbers);
}

TEST(Cprod, LengthsMultiply) {
    check("the length of a product is the product of the lengths",
          "If it is not, a sign or one of the four products is wrong.");
    const std::vector<glm::vec2> a{{3, 4}, {-1, 2}, {0.6f, -0.8f}};
    const std::vector<glm::vec2> b{{5, -12}, {-2, -1.5f}, {-0.28f, 0.96f}};
    const auto got = expectProducts(a, b);
    if (!got)
        return;
    for (std::size_t i = 0; i < a.size(); ++i)
        expectClose(say("|cprod(a, b)| for a = {}, b = {}", a[i], b[i]), glm::length(got->at(i)),
                    glm::length(a[i]) * glm::length(b[i]));
}
