int deeper(volatile int n) { return n + deeper(n + 1) * 2; }
