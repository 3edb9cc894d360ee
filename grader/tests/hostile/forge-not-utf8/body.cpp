throw std::runtime_error(std::string("\xff\xfe\0\xc3(", 6));
