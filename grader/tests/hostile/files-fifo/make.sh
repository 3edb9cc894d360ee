rm 06-rotation/rotation.cpp
mkfifo 06-rotation/rotation.cpp
