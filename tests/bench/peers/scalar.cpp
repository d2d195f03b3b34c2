// Algorithm 2 of the paper, straightforward: body by body, arrays of structures, Runge-Kutta, normal numbers from the standard
// library. LANGEVIN loads with the SPEED clock (docs/maintainers/physics.md, 3 and 4).
#include "lr_bench/leaf.h"
#include "peers/peers.h"

#include <cmath>
#include <random>
#include <vector>

namespace lr_bench {
namespace {

struct State {
    float x[3], q[4], v[3], w[3]; // q: x y z w; v, w in the body frame
};

struct Noise {
    float alpha, force[3], couple[3];
};

void cross(const float* a, const float* b, float* out) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

// R(q) v, or R(q)^T v with the vector part of q reversed.
void rotate(const float* q, float sign, const float* v, float* out) {
    const float axis[3] = {sign * q[0], sign * q[1], sign * q[2]};
    float t[3], u[3];
    cross(axis, v, t);
    cross(axis, t, u);
    for (int k = 0; k < 3; ++k) out[k] = v[k] + 2.0f * (q[3] * t[k] + u[k]);
}

State rate(const LeafConstants& c, const Noise& n, const State& s) {
    constexpr float gravity[3] = {0.0f, -9.81f, 0.0f};
    State r;
    float fall[3], p[3], l[3], pw[3], lw[3], pv[3];
    rotate(s.q, 1.0f, s.v, r.x);
    rotate(s.q, -1.0f, gravity, fall);
    for (int k = 0; k < 3; ++k) {
        p[k] = c.mass[k] * s.v[k];
        l[k] = c.inertia[k] * s.w[k];
    }
    cross(p, s.w, pw);
    cross(l, s.w, lw);
    cross(p, s.v, pv);
    for (int k = 0; k < 3; ++k) {
        r.v[k] = (pw[k] + c.weight * fall[k] + c.carried[k] * (n.force[k] - n.alpha * s.v[k])) / c.mass[k];
        r.w[k] = (lw[k] + pv[k] + c.turned[k] * (n.couple[k] - n.alpha * s.w[k])) / c.inertia[k];
    }
    float qw[3];
    cross(s.q, s.w, qw);
    for (int k = 0; k < 3; ++k) r.q[k] = 0.5f * (s.q[3] * s.w[k] + qw[k]);
    r.q[3] = -0.5f * (s.q[0] * s.w[0] + s.q[1] * s.w[1] + s.q[2] * s.w[2]);
    return r;
}

State moved(const State& s, const State& r, float h) {
    State out;
    for (int k = 0; k < 3; ++k) {
        out.x[k] = s.x[k] + h * r.x[k];
        out.v[k] = s.v[k] + h * r.v[k];
        out.w[k] = s.w[k] + h * r.w[k];
    }
    for (int k = 0; k < 4; ++k) out.q[k] = s.q[k] + h * r.q[k];
    return out;
}

class Scalar final : public Subject {
public:
    explicit Scalar(const Row& row) : bodies_(row.bodies) {
        for (size_t i = 0; i < bodies_.size(); ++i) {
            const auto within = [&](size_t k, float limit) { return limit * (2.0f * uniform(13 * i + k) - 1.0f); };
            State& s = bodies_[i];
            for (size_t k = 0; k < 3; ++k) {
                s.x[k] = within(k, 50.0f);
                s.v[k] = within(k + 3, 0.5f);
                s.w[k] = within(k + 6, 5.0f);
            }
            for (size_t k = 0; k < 4; ++k) s.q[k] = within(k + 9, 1.0f);
            normalise(s.q);
        }
    }

    bool step() override {
        const DenormalsFlushed flushed;
        const float h = substep_seconds;
        for (State& s : bodies_) {
            const float speed = std::sqrt(s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
            const float beta = std::sqrt(c_.beta2 * speed * speed * speed / h);
            Noise n;
            n.alpha = c_.alpha * speed;
            for (float& f : n.force) f = beta * normal_(generator_);
            for (float& f : n.couple) f = beta / c_.ell * normal_(generator_);
            const State a = rate(c_, n, s), b = rate(c_, n, moved(s, a, 0.5f * h)),
                        c = rate(c_, n, moved(s, b, 0.5f * h)), d = rate(c_, n, moved(s, c, h));
            s = moved(moved(moved(moved(s, a, h / 6.0f), b, h / 3.0f), c, h / 3.0f), d, h / 6.0f);
            normalise(s.q);
        }
        return true;
    }
    uint64_t lost() const override {
        uint64_t count = 0;
        for (const State& s : bodies_) count += !std::isfinite(s.x[0] + s.v[0] + s.w[0]);
        return count;
    }
    Facts facts() const override { return array_facts(sizeof(State)); }

private:
    static void normalise(float* q) {
        const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int k = 0; k < 4; ++k) q[k] /= length;
    }

    std::vector<State> bodies_;
    LeafConstants c_ = leaf_constants();
    std::mt19937 generator_{1};
    std::normal_distribution<float> normal_;
};

} // namespace

std::unique_ptr<Subject> make_scalar(const Row& row) {
    return std::make_unique<Scalar>(row);
}

} // namespace lr_bench
