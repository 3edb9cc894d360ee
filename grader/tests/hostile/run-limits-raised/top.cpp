#include <sys/resource.h>
#include <vector>
std::vector<std::vector<char>> all;
