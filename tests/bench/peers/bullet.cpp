// Bullet's rigid bodies alone: gravity, quadratic drag, its own integration and motion. No broad phase, contacts or
// islands, because a storm in the air does not need them.
#include "lr_bench/leaf.h"
#include "peers/peers.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <vector>

namespace lr_bench {
namespace {

class Bullet final : public Subject {
public:
    explicit Bullet(const Row& row) {
        const double* const a = leaf_semi_axes;
        const double mass = leaf_density * 4.0 / 3.0 * 3.14159265358979 * a[0] * a[1] * a[2];
        const auto moment = [&](int i, int j) { return static_cast<float>(mass / 5.0 * (a[i] * a[i] + a[j] * a[j])); };
        const btVector3 inertia(moment(1, 2), moment(2, 0), moment(0, 1));
        const btRigidBody::btRigidBodyConstructionInfo info(static_cast<float>(mass), nullptr, &shape_, inertia);
        bodies_.reserve(row.bodies);
        for (size_t i = 0; i < row.bodies; ++i) {
            auto& body = bodies_.emplace_back(std::make_unique<btRigidBody>(info));
            const auto within = [&](size_t k, float limit) { return limit * (2.0f * uniform(13 * i + k) - 1.0f); };
            btQuaternion q(within(9, 1.0f), within(10, 1.0f), within(11, 1.0f), within(12, 1.0f) + 0.01f);
            q.normalize();
            body->setCenterOfMassTransform(btTransform(q, {within(0, 50.0f), within(1, 50.0f), within(2, 50.0f)}));
            body->setLinearVelocity({within(3, 0.5f), within(4, 0.5f), within(5, 0.5f)});
            body->setAngularVelocity({within(6, 5.0f), within(7, 5.0f), within(8, 5.0f)});
            body->setGravity({0.0f, -9.81f, 0.0f});
            body->setDamping(0.0f, 0.3f);
        }
    }

    bool step() override {
        const DenormalsFlushed flushed;
        for (const auto& body : bodies_) {
            const btVector3 v = body->getLinearVelocity();
            body->applyGravity();
            body->applyCentralForce(-drag_ * v.length() * v);
            body->integrateVelocities(substep_seconds);
            body->applyDamping(substep_seconds);
            btTransform next;
            body->predictIntegratedTransform(substep_seconds, next);
            body->proceedToTransform(next);
            body->clearForces();
        }
        return true;
    }
    uint64_t lost() const override {
        uint64_t count = 0;
        for (const auto& body : bodies_) count += !std::isfinite(body->getCenterOfMassPosition().length2());
        return count;
    }

private:
    btSphereShape shape_{0.01f};
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    float drag_ = leaf_constants().drag;
};

} // namespace

std::unique_ptr<Subject> make_bullet(const Row& row) {
    return std::make_unique<Bullet>(row);
}

} // namespace lr_bench
