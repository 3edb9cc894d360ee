std::vector<std::thread> all;
for (int i = 0; i < 16; ++i) all.emplace_back([] { for (volatile int i = 0;; i = 1 - i) {} });
all.front().join();
return glm::mat3(1.0f);
