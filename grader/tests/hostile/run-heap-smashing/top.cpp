#include <cstring>
#include <memory>
