#include <time.h>
#include <unistd.h>

#include <cstdint>
