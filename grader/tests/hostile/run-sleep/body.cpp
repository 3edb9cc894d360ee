sleep(1000);
return glm::mat3(1.0f);
