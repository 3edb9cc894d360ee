static const int hang = [] { for (volatile int i = 0;; i = 1 - i) {} return 1; }();
