printf '\0\0\0' >> 06-rotation/rotation.cpp
