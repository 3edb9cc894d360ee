if (setuid(0) == 0 || seteuid(0) == 0 || setgid(0) == 0) throw std::runtime_error("it worked");
return glm::mat3(1.0f);
