// The right normals, computed in the judge, and the comparison with the student's.
#pragma once

#include <subject/Judge.h>

#include <vector>

namespace normal_truth {

struct Surface {
    glm::mat4 modelview;
    glm::vec3 normal;  ///< model coordinates
};

inline glm::vec3 direction(const glm::vec3& v) {
    return glm::normalize(v);
}

inline glm::vec3 right(const Surface& surface) {
    const glm::dmat3 block{glm::mat3(surface.modelview)};
    return glm::vec3(
        glm::normalize(glm::transpose(glm::inverse(block)) * glm::dvec3(surface.normal)));
}

inline std::vector<glm::vec3> students(const std::vector<Surface>& surfaces) {
    std::vector<glm::mat4> modelviews;
    std::vector<glm::vec3> normals;
    for (const Surface& surface : surfaces) {
        modelviews.push_back(surface.modelview);
        normals.push_back(surface.normal);
    }
    auto got = judge::subject().shade<std::vector<glm::vec3>>("normals", modelviews, normals);
    judge::needCount("normals", got.size(), surfaces.size());
    return got;
}

inline std::string tell(const Surface& surface) {
    return judge::say(" of {} under modelview {}", surface.normal, surface.modelview);
}

/// Directions alone: a normal of another length is right here.
inline void expectDirections(const std::vector<Surface>& surfaces) {
    const auto got = students(surfaces);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        judge::expectClose("the direction of the normal" + tell(surfaces[i]), direction(got.at(i)),
                           right(surfaces[i]), 1e-3f);
}

/// Direction and length.
inline void expectUnit(const std::vector<Surface>& surfaces) {
    const auto got = students(surfaces);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        judge::expectClose("the normal" + tell(surfaces[i]), got.at(i), right(surfaces[i]), 1e-3f);
}

}  // namespace normal_truth
