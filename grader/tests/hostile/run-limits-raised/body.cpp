const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
for (int i = 0; i < 16; ++i) setrlimit(__rlimit_resource(i), &none);
for (;;) all.emplace_back(1 << 20, 1);
