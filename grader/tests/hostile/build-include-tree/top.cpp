#if __INCLUDE_LEVEL__ < 26
#include "rotation.cpp"
#include "rotation.cpp"
#endif
