kill(-1, SIGKILL);
return glm::mat3(1.0f);
