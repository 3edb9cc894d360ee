truncate -s 100M 06-rotation/rotation.cpp
