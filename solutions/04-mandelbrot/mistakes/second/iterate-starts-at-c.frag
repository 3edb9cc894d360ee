int iterate(vec2 c) {
    float re = c.x, im = c.y;
    int result = 0;
    for (int k = 0; k < maxiter; k++) {
        float old = re;
        re = re * re - im * im + c.x;
        im = 2.0 * old * im + c.y;
        if (sqrt(re * re + im * im) > 2.0) {
            result = k;
            break;
        }
    }
    return result;
}
