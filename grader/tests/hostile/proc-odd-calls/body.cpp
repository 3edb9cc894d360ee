char zeros[256] = {};
for (const long call : {long(SYS_bpf), long(SYS_keyctl), long(SYS_io_uring_setup), long(SYS_userfaultfd), long(SYS_perf_event_open)})
    if (syscall(call, 1, zeros, -1, -1, 0) >= 0) throw std::runtime_error("it worked");
return glm::mat3(1.0f);
