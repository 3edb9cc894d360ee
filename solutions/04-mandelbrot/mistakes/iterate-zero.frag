int iterate(vec2 c) {
    return 0;
}
