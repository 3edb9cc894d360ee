    const std::string text = stolen;
    const auto at = text.find("Column j");
    if (at != std::string::npos)
        throw std::runtime_error("it says: " + text.substr(at, 300));
