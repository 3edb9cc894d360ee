std::abort();
