#define private public
#define class struct
#include <sstream>
