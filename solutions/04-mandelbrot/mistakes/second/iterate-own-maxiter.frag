const int limit = 100;
int iterate(vec2 c) {
    int I = 0;
    bool out_of_circle = false;
    vec2 z = vec2(0.0);
    for (int k = 0; k < limit && !out_of_circle; ++k) {
        z = c + mat2(z.x, z.y, -z.y, z.x) * z;
        out_of_circle = length(z) > 2.0;
        I = out_of_circle ? k : 0;
    }
    return I;
}
