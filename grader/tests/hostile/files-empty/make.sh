: > 06-rotation/rotation.cpp
