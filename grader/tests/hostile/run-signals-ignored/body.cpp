sigset_t all;
sigfillset(&all);
sigprocmask(SIG_BLOCK, &all, nullptr);
for (int i = 1; i < 65; ++i) signal(i, SIG_IGN);
for (volatile int i = 0;; i = 1 - i) {}
