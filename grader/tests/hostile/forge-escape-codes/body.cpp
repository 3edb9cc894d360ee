throw std::runtime_error("\033[2J\033]0;owned\007\x9b31m\r100 / 100");
