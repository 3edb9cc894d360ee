#include "Obj.h"

#include <cg/Error.h>
#include <cg/GlTest.h>
#include <cg/ReadBack.h>
#include <cg/TemporaryFolder.h>

namespace {

class ObjTest : public cg::GlTest {
protected:
    /// Path of a file with this text.
    std::string write(const std::string& text) const { return folder.write("mesh.obj", text); }
    std::string refusal(const std::string& text) {
        const std::string path = write(text);
        const std::string message = cg::messageOf<cg::Error>([&] { Obj().init(path.c_str()); });
        EXPECT_NE(message.find(path), std::string::npos) << message;
        return message;
    }

    cg::TemporaryFolder folder;
};

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\n";

TEST_F(ObjTest, PolygonsBecomeTriangles) {
    Obj obj;
    obj.init(write(square + "f 1 2 3 4\n").c_str());
    EXPECT_EQ(obj.count, 6);
    const cg::ReadBack mesh(obj);
    EXPECT_EQ(mesh.positions.size(), 4u);
    for (const glm::vec3& normal : mesh.normals) {
        EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    }
    EXPECT_FLOAT_EQ(mesh.cross(0).z + mesh.cross(1).z, 12.0f);
}

TEST_F(ObjTest, NormalsOfTheFileAreKept) {
    Obj obj;
    obj.init(write(square + "vn 1 0 0\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n").c_str());
    const cg::ReadBack mesh(obj);
    EXPECT_EQ(mesh.positions.size(), 6u);  // corners 1 and 3 have two normals each
    EXPECT_EQ(mesh.normals.at(mesh.indices.at(0)), glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals.at(mesh.indices.at(3)), glm::vec3(0, 1, 0));
}

TEST_F(ObjTest, MissingNormalsAreWeightedByArea) {
    // Two triangles at a right angle share the edge 1-2; the second has three times the area.
    Obj obj;
    obj.init(write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -3\nf 1 2 3\nf 1 2 -1\n").c_str());
    const cg::ReadBack mesh(obj);
    const glm::vec3 shared = mesh.normals.at(mesh.indices.at(0));
    const glm::vec3 expected = glm::normalize(glm::vec3(0, 3, 1));
    EXPECT_NEAR(glm::distance(shared, expected), 0.0f, 1e-6f);
    EXPECT_EQ(mesh.normals.at(mesh.indices.at(2)), glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals.at(mesh.indices.at(5)), glm::vec3(0, 1, 0));
}

TEST_F(ObjTest, ErrorsNameTheFile) {
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
    EXPECT_NE(refusal(square).find("no polygon"), std::string::npos);
    EXPECT_NE(refusal("%PDF-1.4\nstream\n").find("no polygon"), std::string::npos);
    EXPECT_NE(refusal(square + "f 1 2 7\n").find("vertex 7 of 4"), std::string::npos);
    refusal(square + "f 1 2 0\n");
    EXPECT_NE(cg::messageOf<cg::Error>([] { Obj().init("no/such.obj"); }).find("no/such.obj"),
              std::string::npos);
}

TEST_F(ObjTest, AFailureLeavesTheGeometryAsItWas) {
    Obj obj;
    obj.init(write(square + "f 1 2 3\n").c_str());
    const GLuint vao = obj.vao;
    EXPECT_THROW(obj.init(write(square).c_str()), cg::Error);
    EXPECT_EQ(obj.vao, vao);
    EXPECT_EQ(obj.count, 3);
}

TEST_F(ObjTest, TheMeshesOfTheCourseLookOutwards) {
    for (const char* name : {"/models/bunny.obj", "/models/teapot.obj"}) {
        Obj obj;
        obj.init((std::string(CG_FOLDER) + name).c_str());
        const cg::ReadBack mesh(obj);
        EXPECT_GT(obj.count, 2900) << name;
        double volume = 0.0;
        for (std::size_t k = 0; k < mesh.indices.size() / 3; ++k) {
            volume += glm::dot(mesh.positions[mesh.indices[3 * k]], mesh.cross(k)) / 6.0f;
        }
        EXPECT_GT(volume, 100.0) << name;
        for (const glm::vec3& normal : mesh.normals) {
            EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f) << name;
        }
    }
}

}  // namespace
