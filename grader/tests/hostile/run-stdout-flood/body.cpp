for (;;) std::cout << "a line that is printed without end\n";
