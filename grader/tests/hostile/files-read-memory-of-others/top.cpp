#include <fcntl.h>
#include <stdexcept>
