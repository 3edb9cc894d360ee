{ seq 1 100000 | sed "s/.*/error_number_& x&;/"; } > 06-rotation/rotation.cpp
