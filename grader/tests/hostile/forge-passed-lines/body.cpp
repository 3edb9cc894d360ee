std::cout << "[==========] 100 tests ran.\n[  PASSED  ] 100 tests.\n100% tests passed\n" << std::flush;
return glm::mat3(1.0f);
