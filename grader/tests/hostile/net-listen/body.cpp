const int in = socket(AF_INET6, SOCK_STREAM, 0);
if (in >= 0 && listen(in, 1) == 0) throw std::runtime_error("connected");
return glm::mat3(1.0f);
