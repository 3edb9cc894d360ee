#include "Camera.h"

#include <cmath>

// v turns by some degrees about the axis k, which need not have length 1.
static void turn(double degrees, const double k[3], double v[3]) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double length = std::sqrt(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
    const double a[3] = {k[0] / length, k[1] / length, k[2] / length};
    const double along = a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
    const double crossed[3] = {a[1] * v[2] - a[2] * v[1], a[2] * v[0] - a[0] * v[2],
                               a[0] * v[1] - a[1] * v[0]};
    for (int i = 0; i < 3; i++)
        v[i] = c * v[i] + s * crossed[i] + (1.0 - c) * along * a[i];
}

void Camera::rotateRight(const float degrees) {
    const double axis[3] = {up.x, up.y, up.z};
    double arm[3] = {double(eye.x) - target.x, double(eye.y) - target.y, double(eye.z) - target.z};
    turn(degrees, axis, arm);
    eye.x = float(target.x + arm[0]);
    eye.y = float(target.y + arm[1]);
    eye.z = float(target.z + arm[2]);
}

void Camera::rotateUp(const float degrees) {
    double u[3] = {up.x, up.y, up.z};
    double arm[3] = {double(eye.x) - target.x, double(eye.y) - target.y, double(eye.z) - target.z};
    const double axis[3] = {arm[1] * u[2] - arm[2] * u[1], arm[2] * u[0] - arm[0] * u[2],
                            arm[0] * u[1] - arm[1] * u[0]};
    turn(degrees, axis, arm);
    turn(degrees, axis, u);
    for (int i = 0; i < 3; i++) {
        eye[i] = float(target[i] + arm[i]);
        up[i] = float(u[i]);
    }
}

void Camera::computeMatrices(void) {
    double z[3], y[3], zz = 0.0, zu = 0.0, yy = 0.0;
    for (int i = 0; i < 3; i++) {
        z[i] = double(eye[i]) - double(target[i]);
        zz += z[i] * z[i];
    }
    for (int i = 0; i < 3; i++) {
        z[i] /= std::sqrt(zz);
        zu += z[i] * up[i];
    }
    for (int i = 0; i < 3; i++) {
        y[i] = up[i] - zu * z[i];
        yy += y[i] * y[i];
    }
    for (int i = 0; i < 3; i++)
        y[i] /= std::sqrt(yy);
    const double x[3] = {y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2],
                         y[0] * z[1] - y[1] * z[0]};

    double rows[4][4] = {
        {x[0], x[1], x[2], 0}, {y[0], y[1], y[2], 0}, {z[0], z[1], z[2], 0}, {0, 0, 0, 1}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            rows[i][3] -= rows[i][k] * eye[k];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            view[j][i] = float(rows[i][j]);
}

void Camera::reset(void) {
    eye = eye_default;
    target = target_default;
    up = up_default;
    fovy = fovy_default;
    aspect = aspect_default;
    near = near_default;
    far = far_default;
}
