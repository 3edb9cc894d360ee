std::mutex m;
m.lock();
std::thread([&] { m.lock(); }).join();
return glm::mat3(1.0f);
