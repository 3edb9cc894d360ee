head -c 10000 /dev/urandom > 06-rotation/rotation.cpp
