volatile int zero = 0;
return glm::mat3(float(7 / zero));
