// What the grader may ask of a student's shader: values of many fragments, and pictures.
#include <cg/ShaderProbe.h>
#include <runner/Harness.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <list>
#include <set>
#include <vector>

#include "habits.h"
#include "scene.h"

namespace {

using course::blackLight;
using course::HabitProbe;
using course::Habits;
using course::Item;
using course::light;
using course::material;
using Lights = std::vector<Light>;

// ---- Values ------------------------------------------------------------------------------------

using Vec4s = std::vector<glm::vec4>;
constexpr std::size_t slots = 10;  // lights of one trial

// Trials one after the other, flattened as tests/truth.h says: fragments of trial k share one set
// of uniforms. `counts` holds how many fragments each trial has, `madeUpFor` which habits of the
// shader shall not show: the sum of 1 (overlooksLone), 2 (lightReversed) and 4 (normalReversed).
Vec4s shade(int madeUpFor, const std::vector<int>& counts, const Vec4s& positions, Vec4s normals,
            const std::vector<glm::mat4>& matrices, const Vec4s& values, const Vec4s& lights) {
    const Habits habits = madeUpFor == 0 ? Habits() : HabitProbe::look();
    if ((madeUpFor & 4) != 0 && habits.normalReversed) {
        for (glm::vec4& each : normals) {
            each = -each;
        }
    }
    Vec4s colors;
    std::size_t first = 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const auto slice = [](const Vec4s& all, std::size_t begin, std::size_t count) {
            const auto from = all.begin() + static_cast<long>(begin);
            return Vec4s(from, from + static_cast<long>(count));
        };
        const std::size_t count = static_cast<std::size_t>(counts[k]);
        const glm::vec4* value = &values.at(6 * k);
        int nlights = static_cast<int>(value[4].w);
        Vec4s lamps = slice(lights, 2 * slots * k, slots);
        Vec4s hues = slice(lights, 2 * slots * k + slots, slots);
        if ((madeUpFor & 2) != 0 && habits.lightReversed) {
            const glm::vec4 place =
                glm::inverse(matrices.at(2 * k)) * matrices.at(2 * k + 1) * positions.at(first);
            for (glm::vec4& each : lamps) {
                each = glm::vec4(2.0f * each.w * glm::vec3(place) - glm::vec3(each), each.w);
            }
        }
        if ((madeUpFor & 1) != 0 && habits.overlooksLone && nlights == 1) {
            nlights = 3;
            const Light black = blackLight();
            lamps = {black.position, lamps.at(0), black.position};
            hues = {black.color, hues.at(0), black.color};
            lamps.resize(slots, black.position);
            hues.resize(slots, black.color);
        }
        cg::Uniforms uniforms;
        uniforms.mat4s = {{"view", matrices.at(2 * k)}, {"modelview", matrices.at(2 * k + 1)}};
        uniforms.vec4s = {{"ambient", value[0]},
                          {"diffuse", value[1]},
                          {"specular", value[2]},
                          {"emision", value[3]}};
        uniforms.floats = {
            {"shininess", value[4].x}, {"exposure", value[4].y}, {"gamma", value[4].z}};
        uniforms.ints = {{"nlights", nlights}, {"enablelighting", 1}};
        uniforms.vec3s = {{"attenuation", glm::vec3(value[5])}};
        uniforms.vec4Arrays = {{"lightpositions", lamps}, {"lightcolors", hues}};
        const Vec4s some = cg::probeFragment("shaders/lighting.frag",
                                             {{"position", slice(positions, first, count)},
                                              {"normal", slice(normals, first, count)}},
                                             uniforms);
        colors.insert(colors.end(), some.begin(), some.end());
        first += count;
    }
    return colors;
}

// ---- Pictures ----------------------------------------------------------------------------------

// One set for all frames: compiling its shader takes longer than drawing it.
course::Set& set() {
    static course::Set instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    instance.stale.clear();
    instance.shader.attenuation = glm::vec3(1.0f, 0.0f, 0.0f);
    instance.shader.exposure = instance.shader.gamma = 1.0f;
    return instance;
}

const glm::vec3 none(0.0f);

glm::mat4 projection(const FrameRequest& request, float fovyDegrees, float far = 50.0f) {
    const float aspect = float(request.width) / float(request.height);
    return glm::perspective(glm::radians(fovyDegrees), aspect, 0.1f, far);
}

// The only light of a picture, put so that a shader sees it whose loop is one short.
Lights alone(const Light& lamp, const Habits& habits) {
    return habits.overlooksLone ? Lights{blackLight(), lamp, blackLight()} : Lights{lamp};
}

// The normals of a shape point to the other side as long as this lives.
class Reversed {
public:
    explicit Reversed(Geometry& shape) : shape_(shape) { reverse(); }
    Reversed(const Reversed&) = delete;
    Reversed& operator=(const Reversed&) = delete;
    ~Reversed() { reverse(); }

private:
    void reverse() {
        GLint bytes = 0;
        glBindBuffer(GL_ARRAY_BUFFER, shape_.buffers.at(1));
        glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
        std::vector<GLfloat> normals(static_cast<std::size_t>(bytes) / sizeof(GLfloat));
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, bytes, normals.data());
        for (GLfloat& each : normals) {
            each = -each;
        }
        glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, normals.data());
    }
    Geometry& shape_;
};

// A picture of one term of (10.20). Shapes are placed in camera coordinates and not turned
// there, so that their normals have the same components in the model; the one light shines along
// the axis about which view turns, so that it has the same direction in the world. Thus a mistake
// with normals or lights costs nothing here; nor does one of habits.h. The camera is somewhere else
// and turned all the same.
class TermPicture {
public:
    explicit TermPicture(const glm::vec3& axis)
        : view(glm::rotate(glm::translate(glm::mat4(1.0f), glm::vec3(0.4f, -0.7f, -2.0f)),
                           glm::radians(50.0f), axis)),
          lights{light(glm::vec4(100000.0f * axis, 0.0f), {1.0f, 0.95f, 0.8f})} {}

    // A shape that looks as if it were scaled by `size` and stood at `where` (camera coordinates).
    // In truth it stands farther off, so that its normals keep their length.
    void add(Geometry& shape, const glm::vec3& where, float size, Material& material) {
        const glm::mat4 modelview = glm::translate(glm::mat4(1.0f), where / size);
        items.push_back({&shape, glm::inverse(view) * modelview, &material});
    }
    void draw(const FrameRequest& request) {
        const Habits habits = HabitProbe::look();
        std::list<Reversed> reversed;
        std::set<Geometry*> shapes;
        for (const Item& item : items) {
            if (habits.normalReversed && shapes.insert(item.shape).second) {
                reversed.emplace_back(*item.shape);
            }
        }
        for (Light& lamp : lights) {
            if (habits.lightReversed && lamp.position.w == 0.0f) {
                lamp.position = -lamp.position;
            }
        }
        if (lights.size() == 1) {
            lights = alone(lights.front(), habits);
        }
        set().draw(view, projection(request, 26.0f, 300.0f), lights, items);
    }

    glm::vec4 eye() const { return glm::vec4(glm::vec3(glm::inverse(view)[3]), 1.0f); }

    glm::mat4 view;
    Lights lights;
    std::vector<Item> items;
};

void drawAmbient(const FrameRequest& request) {
    // The light sits in the camera, and only its ambient part shows.
    TermPicture picture(glm::normalize(glm::vec3(0.3f, 0.5f, 0.8f)));
    picture.lights = {light(picture.eye(), {0.9f, 0.75f, 0.5f})};
    Material red = material({0.9f, 0.3f, 0.2f}, none, none, none, 10);
    Material green = material({0.3f, 0.8f, 0.3f}, none, none, none, 10);
    Material blue = material({0.3f, 0.4f, 1.0f}, none, none, none, 10);
    picture.add(set().sphere, {-1.0f, 0.45f, -6.0f}, 0.55f, red);
    picture.add(set().cube, {0.65f, -0.55f, -6.0f}, 0.85f, green);
    picture.add(set().torus, {0.7f, 0.75f, -6.0f}, 0.6f, blue);
    picture.draw(request);
}

void drawDiffuse(const FrameRequest& request) {
    TermPicture picture(glm::normalize(glm::vec3(0.14f, 0.2f, 1.0f)));
    Material clay = material(none, {0.85f, 0.5f, 0.35f}, none, none, 10);
    Material chalk = material(none, {0.9f, 0.95f, 1.0f}, none, none, 10);
    Material moss = material(none, {0.4f, 0.7f, 0.3f}, none, none, 10);
    picture.add(set().sphere, {-1.0f, 0.45f, -6.0f}, 0.55f, moss);
    picture.add(set().sphere, {0.6f, -0.55f, -6.0f}, 0.65f, clay);
    picture.add(set().torus, {0.7f, 0.75f, -6.0f}, 0.6f, chalk);
    picture.draw(request);
}

void drawSpecular(const FrameRequest& request) {
    TermPicture picture(glm::normalize(glm::vec3(-0.5f, 0.55f, 0.7f)));
    std::vector<Material> materials;
    for (const float exponent : {6.0f, 10.0f, 20.0f, 50.0f, 12.0f}) {
        materials.push_back(material(none, none, {0.9f, 0.8f, 1.0f}, none, exponent));
    }
    picture.add(set().sphere, {-1.1f, 0.6f, -6.0f}, 0.45f, materials[0]);
    picture.add(set().sphere, {0.0f, 0.6f, -6.0f}, 0.45f, materials[1]);
    picture.add(set().sphere, {1.1f, 0.6f, -6.0f}, 0.45f, materials[2]);
    picture.add(set().sphere, {-0.9f, -0.6f, -5.5f}, 0.45f, materials[3]);
    picture.add(set().sphere, {0.5f, -0.6f, -5.5f}, 0.55f, materials[4]);
    picture.draw(request);
}

void drawEmission(const FrameRequest& request) {
    TermPicture picture(glm::normalize(glm::vec3(-0.4f, 0.3f, 0.9f)));
    picture.lights.clear();
    Material ember = material(none, none, none, {0.8f, 0.3f, 0.1f}, 10);
    Material lamp = material(none, none, none, {0.7f, 0.7f, 0.55f}, 10);
    Material neon = material(none, none, none, {0.2f, 0.45f, 0.8f}, 10);
    picture.add(set().teapot, {-0.7f, 0.5f, -6.0f}, 0.05f, ember);
    picture.add(set().sphere, {0.9f, 0.45f, -6.0f}, 0.5f, lamp);
    picture.add(set().torus, {0.0f, -0.6f, -6.0f}, 0.8f, neon);
    picture.draw(request);
}

glm::mat4 lookFrom(const glm::vec3& eye) {
    return glm::lookAt(eye, course::StillLife::target, glm::vec3(0.0f, 1.0f, 0.0f));
}
const glm::vec3 frontEye(0.9f, 1.9f, 3.5f);

using course::StillLife;

void drawStillLife(const FrameRequest& request, course::Set& all, const glm::vec3& eye,
                   const Lights& lights, StillLife::Finish finish = StillLife::Finish::matt) {
    const glm::mat4 seen = projection(request, StillLife::fovyDegrees);
    StillLife(all, finish).draw(lookFrom(eye), seen, lights);
}

// The window after left, left, down.
void drawLamps(const FrameRequest& request) {
    Camera camera;
    StillLife::place(camera);
    camera.aspect = float(request.width) / float(request.height);
    camera.rotateRight(10.0f);
    camera.rotateRight(10.0f);
    camera.rotateUp(10.0f);
    camera.computeMatrices();
    StillLife(set()).draw(camera.view, camera.proj, StillLife::lamps());
}

void drawOtherSide(const FrameRequest& request) {
    course::Set& all = set();
    all.stale = {light({0.0f, 1.0f, -1.0f, 0.0f}, {0.9f, 0.1f, 0.8f}),
                 light({-1.0f, 1.0f, 1.0f, 1.0f}, {0.1f, 0.9f, 0.2f})};
    drawStillLife(request, all, {-1.6f, 1.3f, -3.3f}, StillLife::lamps());
}

void drawTenLights(const FrameRequest& request) {
    Lights lights;
    for (int i = 0; i < 10; ++i) {
        const float turn = glm::radians(36.0f * float(i));
        const float w = float(i % 3);  // 0, 1, 2: at infinity, and two ways to write a point
        const glm::vec3 place(1.4f * std::cos(turn), 0.9f, 1.4f * std::sin(turn));
        const glm::vec3 hue(0.11f + 0.09f * std::cos(turn), 0.1f, 0.11f - 0.09f * std::cos(turn));
        lights.push_back(light(glm::vec4(w == 0.0f ? place : w * place, w), hue));
    }
    drawStillLife(request, set(), frontEye, lights);
}

void drawSeededLamps(const FrameRequest& request) {
    SeededValues values(request.seed);
    const auto around = [&values](float radius, float low, float high) {
        const float turn = values.uniform(0.0f, 6.2831853f), height = values.uniform(low, high);
        return glm::vec3(radius * std::cos(turn), height, radius * std::sin(turn));
    };
    const auto hue = [&values] {
        const float red = values.uniform(0.2f, 0.7f), green = values.uniform(0.2f, 0.7f);
        return glm::vec3(red, green, 0.9f - 0.5f * (red + green));
    };
    Lights lights;
    for (const float w : {1.0f, 0.0f, 2.0f}) {
        const glm::vec3 place = around(1.3f, 0.5f, 1.2f);
        lights.push_back(light(glm::vec4(w == 0.0f ? place : w * place, w), hue()));
    }
    drawStillLife(request, set(), around(3.3f, 1.2f, 2.3f), lights);
}

void drawCandle(const FrameRequest& request) {
    const Lights candle =
        alone(light({0.2f, 1.2f, 0.5f, 2.0f}, {1.2f, 0.9f, 0.6f}), HabitProbe::look());
    course::Set& all = set();
    all.shader.attenuation = glm::vec3(0.3f, 0.4f, 2.2f);
    drawStillLife(request, all, frontEye, candle);
}

void drawOverexposed(const FrameRequest& request) {
    course::Set& all = set();
    all.shader.exposure = 0.55f;
    all.shader.gamma = 0.45f;
    const Lights lamp =
        alone(light({-0.5f, 2.2f, 1.8f, 1.0f}, {3.0f, 2.6f, 2.0f}), HabitProbe::look());
    drawStillLife(request, all, frontEye, lamp, StillLife::Finish::shiny);
}

}  // namespace

CG_HARNESS(harness) {
    harness.function("lighting", shade);

    harness.frame("ambient", [](const FrameRequest& request) { drawAmbient(request); });
    harness.frame("diffuse", [](const FrameRequest& request) { drawDiffuse(request); });
    harness.frame("specular", [](const FrameRequest& request) { drawSpecular(request); });
    harness.frame("emission", [](const FrameRequest& request) { drawEmission(request); });
    harness.frame("lamps", [](const FrameRequest& request) { drawLamps(request); });
    harness.frame("other-side", [](const FrameRequest& request) { drawOtherSide(request); });
    harness.frame("ten-lights", [](const FrameRequest& request) { drawTenLights(request); });
    harness.frame("seeded-lamps", [](const FrameRequest& request) { drawSeededLamps(request); });
    harness.frame("candle", [](const FrameRequest& request) { drawCandle(request); });
    harness.frame("overexposed", [](const FrameRequest& request) { drawOverexposed(request); });
}
