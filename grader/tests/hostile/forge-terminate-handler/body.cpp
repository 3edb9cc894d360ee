std::set_terminate([] { _exit(0); });
std::terminate();
