    const float t = glm::radians(degrees) / 2.0f;
    const glm::vec4 q(std::cos(t), axis.x * std::sin(t), axis.y * std::sin(t),
                      axis.z * std::sin(t));
    const glm::mat4 left(q[0], q[1], q[2], q[3],
                         -q[1], q[0], q[3], -q[2],
                         -q[2], -q[3], q[0], q[1],
                         -q[3], q[2], -q[1], q[0]);
    const glm::mat4 right(q[0], -q[1], -q[2], -q[3],
                          q[1], q[0], q[3], -q[2],
                          q[2], -q[3], q[0], q[1],
                          q[3], q[2], -q[1], q[0]);
    const glm::mat4 M = left * right;
    return glm::mat3(glm::vec3(M[1][1], M[1][2], M[1][3]), glm::vec3(M[2][1], M[2][2], M[2][3]),
                     glm::vec3(M[3][1], M[3][2], M[3][3]));
