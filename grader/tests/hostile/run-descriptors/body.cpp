while (open("/dev/null", O_RDONLY) >= 0) {}
return glm::mat3(1.0f);
