#if __INCLUDE_LEVEL__ < 60
#include "rotation.cpp"
#include "rotation.cpp"
#endif
