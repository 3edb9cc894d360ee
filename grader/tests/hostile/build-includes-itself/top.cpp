#include "rotation.cpp"
