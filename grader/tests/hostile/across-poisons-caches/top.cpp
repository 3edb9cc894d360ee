#include <cstdlib>
#include <fstream>
#include <filesystem>
