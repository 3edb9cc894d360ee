printf '#error \033[2J\033[31m \302\233 \342\200\256 gnp.bat\n' >> 06-rotation/rotation.cpp
