const bool before = calls++ > 0 || std::filesystem::exists("/tmp/state") || std::filesystem::exists("state") || std::filesystem::exists("/dev/shm/state");
std::ofstream("/tmp/state") << 1;
std::ofstream("state") << 1;
std::ofstream("/dev/shm/state") << 1;
return glm::mat3(before ? 2.0f : 1.0f);
