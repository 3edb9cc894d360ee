for (;;) pause();
