kill(getppid(), SIGSTOP);
return glm::mat3(1.0f);
