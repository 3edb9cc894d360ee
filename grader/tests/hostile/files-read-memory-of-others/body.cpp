// What is at the start of a process' memory can never be read; whether all of it can, opening says.
if (open("/proc/1/mem", O_RDONLY) >= 0)
    throw std::runtime_error("it says: it is open");
throw std::runtime_error("it says: it is closed");
