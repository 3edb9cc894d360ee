char huge[1ull << 40];
char* hold = huge;
