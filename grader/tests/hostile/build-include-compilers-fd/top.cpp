#include "/proc/self/fd/3"
