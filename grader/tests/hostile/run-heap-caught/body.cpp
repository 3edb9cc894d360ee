for (;;) try { all.emplace_back(1 << 20, 1); } catch (const std::bad_alloc&) {}
