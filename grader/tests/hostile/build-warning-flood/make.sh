{ seq 1 100000 | sed "s/.*/#warning number &/"; cat 06-rotation/rotation.cpp; } > new && mv new 06-rotation/rotation.cpp
