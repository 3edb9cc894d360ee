#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
