vec2 cprod(vec2 a, vec2 b) {
    vec2 product;
    product.x = 0.0;
    product.y = 0.0;
    return product;
}
