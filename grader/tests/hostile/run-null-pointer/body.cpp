volatile int* p = nullptr;
return glm::mat3(float(*p));
