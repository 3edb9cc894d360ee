#pragma once

#include <glm/glm.hpp>

class Camera {
public:
    glm::vec3 eye{5.0f, 0.0f, 0.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float fovy{30.0f};
    float aspect{4.0f / 3.0f};
    float near{0.01f};
    float far{100.0f};

    glm::vec3 eye_default{5.0f, 0.0f, 0.0f};
    glm::vec3 target_default{0.0f, 0.0f, 0.0f};
    glm::vec3 up_default{0.0f, 1.0f, 0.0f};
    float fovy_default{30.0f};
    float aspect_default{4.0f / 3.0f};
    float near_default{0.01f};
    float far_default{100.0f};

    glm::mat4 view{1.0f};
    glm::mat4 proj{1.0f};

    void rotateRight(const float degrees);
    void rotateUp(const float degrees);
    void computeMatrices();
    void reset();

private:
    struct Basis {
        glm::vec3 right, top, back;
        glm::vec3 toWorld(const glm::vec3& v) const;
        glm::vec3 toCamera(const glm::vec3& v) const;
    };
    Basis basis() const;
    void place(const Basis& basis, const glm::vec3& arm, const glm::vec3& newUp);
};
