#include <limits>
