#include <unistd.h>
#include <cstdint>
#include <cstring>
#include <string>
