const std::uint32_t depth = 10'000'000, size = 2 * depth;
std::vector<std::uint8_t> answer(8 + 16 + 1 + 4 + 4 + 4 + 4 + size, 0);
const auto put = [&](std::size_t at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) answer[at + std::size_t(i)] = std::uint8_t(value >> (8 * i));
};
put(0, 0x4e414743);
put(4, std::uint32_t(answer.size() - 8));
put(answer.size() - size - 4, size);
for (std::size_t i = answer.size() - size; i < answer.size(); i += 2) {
    answer[i] = 0x40;
    answer[i + 1] = 1;
}
for (std::size_t done = 0; done < answer.size();) {
    const auto wrote = write(3, answer.data() + done, answer.size() - done);
    if (wrote <= 0) break;
    done += std::size_t(wrote);
}
for (;;) pause();
