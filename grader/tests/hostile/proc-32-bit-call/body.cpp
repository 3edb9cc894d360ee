long result;
asm volatile("int $0x80" : "=a"(result) : "a"(20L) : "memory");
return glm::mat3(float(result));
