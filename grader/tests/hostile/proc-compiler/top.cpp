#include <signal.h>
#include <unistd.h>
#include <cstdlib>
#include <stdexcept>
