char huge[4ull << 30] = {1};
