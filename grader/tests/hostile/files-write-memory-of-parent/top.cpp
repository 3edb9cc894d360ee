#include <fcntl.h>
#include <unistd.h>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
