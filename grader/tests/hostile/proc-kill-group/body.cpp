kill(0, SIGKILL);
return glm::mat3(1.0f);
