rm 06-rotation/rotation.cpp
mknod 06-rotation/rotation.cpp c 1 5 || mkfifo 06-rotation/rotation.cpp
