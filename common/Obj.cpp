#include "Obj.h"

#include <cg/Error.h>
#include <cg/Resources.h>

#include <fstream>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <utility>

// The whole library in this file, so that whoever links cg needs nothing else.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace {

struct Mesh {
    std::vector<GLfloat> positions, normals;
    std::vector<GLuint> indices;
};

struct Source {
    std::string path;
    tinyobj::attrib_t table;
    std::vector<tinyobj::index_t> corners;  // three per triangle
};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw cg::Error("cannot use the mesh " + path + ": " + why);
}

Source read(const char* name) {
    Source source;
    source.path = cg::findResource(name);
    std::ifstream file(source.path, std::ios::binary);
    if (!file || file.peek() == std::ifstream::traits_type::eof()) {
        refuse(source.path, "it is empty or cannot be read");
    }
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    if (!tinyobj::LoadObj(&source.table, &shapes, &materials, &warning, &error, &file)) {
        refuse(source.path, error.empty() ? "it is no OBJ file" : error);
    }
    for (const tinyobj::shape_t& shape : shapes) {
        const auto& corners = shape.mesh.indices;
        source.corners.insert(source.corners.end(), corners.begin(), corners.end());
    }
    if (source.corners.empty()) {
        refuse(source.path, "it holds no polygon");
    }
    return source;
}

/// Whether every corner names a position that is there, and whether every one names a normal.
bool checkCorners(const Source& source) {
    const auto positions = static_cast<int>(source.table.vertices.size() / 3);
    const auto normals = static_cast<int>(source.table.normals.size() / 3);
    bool allHaveNormals = true;
    for (const tinyobj::index_t& corner : source.corners) {
        if (corner.vertex_index < 0 || corner.vertex_index >= positions) {
            refuse(source.path, "a polygon names vertex " +
                                    std::to_string(corner.vertex_index + 1) + " of " +
                                    std::to_string(positions));
        }
        allHaveNormals &= corner.normal_index >= 0 && corner.normal_index < normals;
    }
    return allHaveNormals;
}

glm::vec3 entry(const std::vector<tinyobj::real_t>& list, std::size_t index) {
    return {list[3 * index], list[3 * index + 1], list[3 * index + 2]};
}

glm::vec3 entry(const std::vector<tinyobj::real_t>& list, int index) {
    return entry(list, static_cast<std::size_t>(index));
}

void append(std::vector<GLfloat>& values, const glm::vec3& v) {
    values.insert(values.end(), {v.x, v.y, v.z});
}

/// Replaces the normals of `source` by one per position.
void computeNormals(Source& source) {
    std::vector<glm::vec3> sums(source.table.vertices.size() / 3, glm::vec3(0.0f));
    for (std::size_t k = 0; k + 2 < source.corners.size(); k += 3) {
        tinyobj::index_t* corner = &source.corners[k];
        const glm::vec3 a = entry(source.table.vertices, corner[0].vertex_index);
        const glm::vec3 b = entry(source.table.vertices, corner[1].vertex_index);
        const glm::vec3 c = entry(source.table.vertices, corner[2].vertex_index);
        const glm::vec3 twiceTheArea = glm::cross(b - a, c - a);
        for (int i = 0; i < 3; ++i) {
            sums[static_cast<std::size_t>(corner[i].vertex_index)] += twiceTheArea;
            corner[i].normal_index = corner[i].vertex_index;
        }
    }
    source.table.normals.clear();
    for (const glm::vec3& sum : sums) {
        const float length = glm::length(sum);
        const glm::vec3 normal = length > 0.0f ? sum / length : glm::vec3(0.0f, 1.0f, 0.0f);
        source.table.normals.insert(source.table.normals.end(), {normal.x, normal.y, normal.z});
    }
}

/// One vertex for each pair of position and normal that occurs.
Mesh assemble(const Source& source) {
    Mesh mesh;
    std::map<std::pair<int, int>, GLuint> known;
    for (const tinyobj::index_t& corner : source.corners) {
        const auto next = static_cast<GLuint>(mesh.positions.size() / 3);
        const auto [at, isNew] =
            known.try_emplace({corner.vertex_index, corner.normal_index}, next);
        if (isNew) {
            append(mesh.positions, entry(source.table.vertices, corner.vertex_index));
            append(mesh.normals, entry(source.table.normals, corner.normal_index));
        }
        mesh.indices.push_back(at->second);
    }
    return mesh;
}

}  // namespace

void Obj::init(const char* file) {
    Source source = read(file);
    if (!checkCorners(source)) {
        computeNormals(source);
    }
    const Mesh mesh = assemble(source);
    build({{3, mesh.positions}, {3, mesh.normals}}, mesh.indices);
}
