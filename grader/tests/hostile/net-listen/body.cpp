const int in = socket(AF_INET6, SOCK_STREAM, 0);
if (in >= 0) throw std::runtime_error(listen(in, 1) == 0 ? "connected" : "has a socket");
return glm::mat3(1.0f);
