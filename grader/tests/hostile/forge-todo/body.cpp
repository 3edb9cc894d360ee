cg::todo<glm::mat3>("cross-matrix");
cg::todo<glm::mat3>("no-such-region");
return glm::mat3(1.0f);
