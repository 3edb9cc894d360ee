if (unshare(CLONE_NEWUSER) == 0) throw std::runtime_error("it worked");
return glm::mat3(1.0f);
