for (int descriptor = 0; descriptor < 64; ++descriptor) close(descriptor);
return glm::mat3(1.0f);
