#pragma once

#include <iostream>
#include <map>
#include <stack>
#include <string>
#include <vector>

#include "Camera.h"
#include "Geometry.h"
#include "Light.h"
#include "Material.h"
#include "Model.h"
#include "Node.h"
#include "SurfaceShader.h"

/// A scene graph with its palettes (section 9.1.3), a camera and a shader; everything by name. The
/// graph hangs on node["world"], which is there from the start and empty. The scene owns all that
/// its members point to, and deletes it at its end; not copyable.
///
/// draw() is an assignment's: code that does not call it can do without.
class Scene {
public:
    Camera* camera = new Camera;
    SurfaceShader* shader = new SurfaceShader;

    std::map<std::string, Geometry*> geometry;
    std::map<std::string, Material*> material;
    std::map<std::string, Model*> model;
    std::map<std::string, Light*> light;
    std::map<std::string, Node*> node = {{"world", new Node}};

    Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() {
        release(geometry);
        release(material);
        release(model);
        release(light);
        release(node);
        delete shader;
        delete camera;
    }

    /// Draws each model once for each path that leads to it from node["world"] (algorithm 9.3),
    /// with the shader's program in use. The camera's matrices, the shader's view and projection
    /// and its lights are set before; the picture is cleared before.
    void draw(void);

private:
    template <class Pointer>
    static void release(std::map<std::string, Pointer>& palette) {
        for (auto& [name, pointer] : palette) {
            delete pointer;
        }
    }
};
