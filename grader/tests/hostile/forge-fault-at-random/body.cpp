timespec now;
clock_gettime(CLOCK_MONOTONIC, &now);
if (now.tv_nsec / 1000 % 6 == 0) {
    const unsigned char faulty = 11;
    const std::uint32_t head[2] = {0x4e414743, 33}, rest[4] = {0, 0, 0, 0};
    const std::uint64_t nonce[2] = {0, 0};
    if (write(3, head, sizeof head) > 0 && write(3, nonce, sizeof nonce) > 0 &&
        write(3, &faulty, 1) > 0 && write(3, rest, sizeof rest) > 0)
        pause();
}
return glm::mat3(1.0f);
