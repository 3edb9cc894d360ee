addrinfo* found = nullptr;
if (getaddrinfo("deb.debian.org", "80", nullptr, &found) == 0) throw std::runtime_error("connected");
return glm::mat3(1.0f);
