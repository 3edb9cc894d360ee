#include <stdexcept>
#include <string>
