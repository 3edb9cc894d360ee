struct Hang { ~Hang() { for (volatile int i = 0;; i = 1 - i) {} } } hang;
