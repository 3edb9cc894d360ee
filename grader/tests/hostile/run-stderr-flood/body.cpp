for (;;) std::cerr << "a line that is printed without end\n";
