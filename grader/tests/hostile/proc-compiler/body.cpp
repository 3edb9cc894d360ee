std::system("echo int main | g++ -x c++ - -o /tmp/made && /tmp/made");
return glm::mat3(1.0f);
