mkdir -p 06-rotation
cat > 06-rotation/rotation.cpp << 'END'
#include "rotation.h"
glm::mat3 crossMatrix(const glm::vec3&) { return glm::mat3(0.0f); }
glm::mat3 rotation(float, const glm::vec3&) { return glm::mat3(0.5f); }
END
