throw std::runtime_error(std::string(10 << 20, 'A'));
