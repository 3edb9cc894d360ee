cd 06-rotation
echo "#error forged" | tee rotation.h scene.h harness.cpp > Todo.h
mkdir -p cg runner glm; echo "#error forged" | tee cg/Todo.h runner/Harness.h > glm/glm.hpp
