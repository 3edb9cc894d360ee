{ printf "int deep = "; head -c 100000 /dev/zero | tr "\0" "("; echo 1; } >> 06-rotation/rotation.cpp
