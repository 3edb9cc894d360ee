    const std::string parent = "/proc/" + std::to_string(getppid());
    const int memory = open((parent + "/mem").c_str(), O_RDWR);
    std::ifstream maps(parent + "/maps");
    std::string line;
    while (memory >= 0 && std::getline(maps, line)) {
        unsigned long start = 0;
        char word[8];
        if (std::sscanf(line.c_str(), "%lx-%*x rw", &start) == 1 &&
            pread(memory, word, sizeof word, long(start)) == sizeof word &&
            pwrite(memory, word, sizeof word, long(start)) == sizeof word)
            throw std::runtime_error("it says: written");
    }
    throw std::runtime_error("it says: it is closed");
