chmod 000 06-rotation/rotation.cpp
