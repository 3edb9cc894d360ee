rm 06-rotation/rotation.cpp
ln -s @SECRET@ 06-rotation/rotation.cpp
