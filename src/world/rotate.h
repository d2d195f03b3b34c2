// Vectors between the frames of world and body, in double: a state that is read and set again must come back the same to
// rounding.
#pragma once

namespace lr {

struct WideVector {
    double v[3];
};

// R(q)^T a or R(q) a, for a unit quaternion x y z w.
template <class T> WideVector rotate(const double q[4], const T a[3], bool to_body) {
    const double s = to_body ? -1.0 : 1.0;
    const double x = s * q[0], y = s * q[1], z = s * q[2], w = q[3];
    const double ax = static_cast<double>(a[0]), ay = static_cast<double>(a[1]), az = static_cast<double>(a[2]);
    const double tx = 2.0 * (y * az - z * ay), ty = 2.0 * (z * ax - x * az), tz = 2.0 * (x * ay - y * ax);
    return {{ax + w * tx + y * tz - z * ty, ay + w * ty + z * tx - x * tz, az + w * tz + x * ty - y * tx}};
}

} // namespace lr
