for (;;) all.emplace_back(1 << 20, 1);
