int iterate(vec2 c) {
    float x = c.x, y = c.y;
    int k = 0;
    do {
        float re = (x - y) * (x + y);
        float im = 2.0 * x * y;
        x = re;
        y = im;
        if (sqrt(x * x + y * y) > 2.0) {
            return k;
        }
        k++;
    } while (k < maxiter);
    return 0;
}
