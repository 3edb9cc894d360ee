// Whatever GLM has a function for. No regions.
#include "rotation.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

glm::mat3 crossMatrix(const glm::vec3 u) {
    const glm::mat3 basis(1.0f);
    return {glm::cross(u, basis[0]), glm::cross(u, basis[1]), glm::cross(u, basis[2])};
}

glm::mat3 rotation(const float degrees, const glm::vec3 axis) {
    return glm::mat3(glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis));
}

glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {
    return glm::mat3_cast(glm::angleAxis(glm::radians(degrees), glm::normalize(axis)));
}
