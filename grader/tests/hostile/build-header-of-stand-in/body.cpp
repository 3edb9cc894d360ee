    const std::string text = stolen ? stolen : "nothing was taken in";
    const auto at = text.find("Column j");
    throw std::runtime_error("it says: " + text.substr(at == std::string::npos ? 0 : at, 300));
