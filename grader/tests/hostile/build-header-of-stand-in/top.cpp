#include <stdexcept>
#include <string>
extern "C" const char stolen[] __attribute__((weak));
