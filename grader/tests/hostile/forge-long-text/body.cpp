    const auto number = [](std::string& to, auto value) {
        to.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    const std::uint32_t length = 30u << 20;
    std::string answer;
    number(answer, std::uint32_t(0x4e414743));
    number(answer, std::uint32_t(16 + 1 + 4 + 4 + length + 4 + 4));
    answer.append(16, '\0');             // the nonce, which the parent replaces
    number(answer, std::uint8_t(2));     // a shader that does not compile
    number(answer, std::int32_t(0));
    number(answer, length);
    answer.append(length, '\1');
    answer.append(8, '\0');              // no regions, no payload
    for (std::size_t sent = 0; sent < answer.size();) {
        const auto more = write(3, answer.data() + sent, answer.size() - sent);
        if (more <= 0)
            break;
        sent += std::size_t(more);
    }
    for (;;)
        pause();
