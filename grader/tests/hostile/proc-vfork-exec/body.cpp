if (fork() == 0) {
    execl("/proc/self/exe", "runner", "/dev/null", "/", "auto", "3", nullptr);
    _exit(1);
}
return glm::mat3(1.0f);
