if (mount("none", "/tmp", "tmpfs", 0, nullptr) == 0) throw std::runtime_error("it worked");
return glm::mat3(1.0f);
