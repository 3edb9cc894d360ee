#include "@SIBLING@/06-rotation/rotation.cpp"
