rm 06-rotation/rotation.cpp
mkdir 06-rotation/rotation.cpp
