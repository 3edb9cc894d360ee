if (ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0) throw std::runtime_error("attached");
return glm::mat3(1.0f);
