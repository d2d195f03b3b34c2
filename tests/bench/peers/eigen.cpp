// Algorithm 2 of the paper with Eigen's vectors and quaternions, in single precision.
#include "lr_bench/leaf.h"
#include "peers/peers.h"

#include <Eigen/Geometry>

#include <cmath>
#include <random>
#include <vector>

namespace lr_bench {
namespace {

using Eigen::Array3f;
using Eigen::Quaternionf;
using Eigen::Vector3f;

struct State {
    Vector3f x;
    Eigen::Vector4f q; // x y z w
    Vector3f v, w;     // body frame

    State operator+(const State& o) const { return {x + o.x, q + o.q, v + o.v, w + o.w}; }
};
State operator*(float s, const State& a) {
    return {s * a.x, s * a.q, s * a.v, s * a.w};
}

class WithEigen final : public Subject {
public:
    explicit WithEigen(const Row& row) : bodies_(row.bodies) {
        const LeafConstants c = leaf_constants();
        mass_ = Array3f(c.mass), inertia_ = Array3f(c.inertia);
        carried_ = Array3f(c.carried), turned_ = Array3f(c.turned);
        weight_ = Vector3f(0.0f, -9.81f * c.weight, 0.0f);
        alpha_ = c.alpha, beta2_ = c.beta2, ell_ = c.ell;
        for (size_t i = 0; i < bodies_.size(); ++i) {
            const auto three = [&](size_t k, float limit) -> Vector3f {
                const Vector3f u(uniform(13 * i + k), uniform(13 * i + k + 1), uniform(13 * i + k + 2));
                return limit * (2.0f * u - Vector3f::Ones());
            };
            State& s = bodies_[i];
            s.x = three(0, 50.0f), s.v = three(3, 0.5f), s.w = three(6, 5.0f);
            s.q << three(9, 1.0f), uniform(13 * i + 12) + 0.01f;
            s.q.normalize();
        }
    }

    bool step() override {
        const DenormalsFlushed flushed;
        const float h = substep_seconds;
        for (State& s : bodies_) {
            const float speed = s.v.norm(), beta = std::sqrt(beta2_ * speed * speed * speed / h);
            const float alpha = alpha_ * speed;
            const Vector3f force = beta * gaussians(), couple = beta / ell_ * gaussians();
            const auto f = [&](const State& at) { return rate(at, alpha, force, couple); };
            const State a = f(s), b = f(s + 0.5f * h * a), c = f(s + 0.5f * h * b), d = f(s + h * c);
            s = s + h / 6.0f * (a + 2.0f * (b + c) + d);
            s.q.normalize();
        }
        return true;
    }
    uint64_t lost() const override {
        uint64_t count = 0;
        for (const State& s : bodies_) count += !(s.x + s.v + s.w).allFinite();
        return count;
    }
    Facts facts() const override { return array_facts(sizeof(State)); }

private:
    Vector3f gaussians() { return {normal_(generator_), normal_(generator_), normal_(generator_)}; }

    State rate(const State& s, float alpha, const Vector3f& force, const Vector3f& couple) const {
        const Quaternionf q(s.q);
        const Vector3f p = mass_ * s.v.array(), l = inertia_ * s.w.array();
        State r;
        r.x = q._transformVector(s.v);
        r.q = 0.5f * (q * Quaternionf(0.0f, s.w.x(), s.w.y(), s.w.z())).coeffs();
        const Vector3f f = p.cross(s.w) + q.conjugate()._transformVector(weight_) +
                           (carried_ * (force - alpha * s.v).array()).matrix();
        const Vector3f g = l.cross(s.w) + p.cross(s.v) + (turned_ * (couple - alpha * s.w).array()).matrix();
        r.v = f.array() / mass_;
        r.w = g.array() / inertia_;
        return r;
    }

    std::vector<State> bodies_;
    Array3f mass_, inertia_, carried_, turned_;
    Vector3f weight_;
    float alpha_, beta2_, ell_;
    std::mt19937 generator_{1};
    std::normal_distribution<float> normal_;
};

} // namespace

std::unique_ptr<Subject> make_eigen(const Row& row) {
    return std::make_unique<WithEigen>(row);
}

} // namespace lr_bench
