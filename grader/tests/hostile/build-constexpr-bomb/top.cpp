constexpr long spin() { long n = 0; for (long i = 0; i < 1000000000000; ++i) n += i; return n; }
constexpr long spun = spin();
