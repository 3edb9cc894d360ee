int iterate(vec2 c) {
    int k = 0;
    for (;;) { k = 1 - k; if (k > 5) break; }
    return k;
}
