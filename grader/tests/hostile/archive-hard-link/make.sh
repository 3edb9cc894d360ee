ln 06-rotation/rotation.cpp 06-rotation/other.cpp
tar -cf archive.tar 06-rotation
