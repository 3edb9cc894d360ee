#include "@ROOT@/solutions/06-rotation/hidden_tests/Rotation_hidden_test.cpp"
