#include <signal.h>
#include <unistd.h>
#include <cstdint>
#include <vector>
