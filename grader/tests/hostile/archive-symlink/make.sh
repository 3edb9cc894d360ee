rm 06-rotation/rotation.cpp
ln -s @ROOT@/solutions/06-rotation/rotation.cpp 06-rotation/rotation.cpp
tar -cf archive.tar 06-rotation
