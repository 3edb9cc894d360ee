char byte;
while (read(3, &byte, 1) == 1) {}
return glm::mat3(1.0f);
