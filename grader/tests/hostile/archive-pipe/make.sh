rm 06-rotation/rotation.cpp
mkfifo 06-rotation/rotation.cpp
tar -cf archive.tar 06-rotation
