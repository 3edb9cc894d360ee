#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

static void number(std::string& to, std::uint32_t value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// An answer as the runner frames it: a white picture.
static std::string whitePicture() {
    const std::uint32_t bytes = 400 * 300 * 4;
    std::string answer;
    number(answer, 0x4e414743);
    number(answer, 16 + 1 + 4 + 4 + 4 + 4 + bytes);
    answer.append(16, '\0');  // the nonce
    answer.append(1, '\0');   // all is well
    for (const std::uint32_t each : {0u, 0u, 0u, bytes})
        number(answer, each);
    return answer.append(bytes, '\xff');
}

static void answerLater() {
    static bool begun = false;
    if (begun)
        return;
    begun = true;
    std::thread([] {
        const std::string answer = whitePicture();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        for (std::size_t sent = 0; sent < answer.size();) {
            const auto more = write(3, answer.data() + sent, answer.size() - sent);
            if (more <= 0)
                return;
            sent += std::size_t(more);
        }
    }).detach();
}
