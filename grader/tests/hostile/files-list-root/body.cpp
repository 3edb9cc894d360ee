std::string all;
for (const auto& entry : std::filesystem::directory_iterator("/")) all += entry.path().string() + " ";
for (const auto& entry : std::filesystem::directory_iterator("/tmp")) all += entry.path().string() + " ";
throw std::runtime_error("they are: " + all);
