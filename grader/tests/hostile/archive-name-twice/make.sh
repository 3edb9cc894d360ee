tar -cf archive.tar 06-rotation
echo x >> 06-rotation/rotation.cpp
tar -rf archive.tar 06-rotation/rotation.cpp
