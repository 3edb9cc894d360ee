#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
