int start[2];
pipe(start);
for (int i = 0; i < 40; ++i)
    if (fork() == 0) {
        char byte;
        close(start[1]);
        read(start[0], &byte, 1);
        mmap(nullptr, 600 << 20, PROT_READ | PROT_WRITE,
             MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
        pause();
    }
close(start[1]);
sleep(100);
return glm::mat3(1.0f);
