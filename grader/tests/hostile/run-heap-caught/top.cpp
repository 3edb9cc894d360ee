#include <new>
#include <vector>
std::vector<std::vector<char>> all;
