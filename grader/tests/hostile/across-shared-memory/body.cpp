shmget(0x41414141, 4096, IPC_CREAT | 0666);
semget(0x41414141, 1, IPC_CREAT | 0666);
shm_open("/@LEFT@", O_CREAT | O_RDWR, 0666);
mq_open("/@LEFT@", O_CREAT | O_RDWR, 0666, nullptr);
return glm::mat3(1.0f);
