int iterate(vec2 c) {
    float s = 0.0;
    for (int i = 0; i < 60000; ++i)
        for (int j = 0; j < 60000; ++j)
            for (int k = 0; k < 60000; ++k) s += sin(float(i * j + k) + c.x);
    return int(s);
}
