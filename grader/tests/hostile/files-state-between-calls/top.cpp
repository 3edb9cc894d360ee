#include <fstream>
#include <filesystem>
static int calls = 0;
