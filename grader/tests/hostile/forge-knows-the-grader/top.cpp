#include <unistd.h>
#include <cstdlib>
