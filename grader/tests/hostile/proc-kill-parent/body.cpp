kill(getppid(), SIGKILL);
return glm::mat3(1.0f);
