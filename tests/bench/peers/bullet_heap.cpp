#include "bench/peers/bullet_heap.h"

#ifdef LR_BENCH_BULLET
#include <btBulletDynamicsCommon.h>
#endif

namespace bench {
#ifdef LR_BENCH_BULLET
namespace {

constexpr btScalar gravity = 9.81f, fall_speed = 1.5f; // m/s^2, m/s: of a plate in air

class BulletHeap final : public Peer {
public:
    BulletHeap() {
        world_.setGravity({0.0f, -gravity, 0.0f});
        const btRigidBody::btRigidBodyConstructionInfo info(0.0f, nullptr, &ground_, btVector3(0.0f, 0.0f, 0.0f));
        floor_ = std::make_unique<btRigidBody>(info);
        floor_->setFriction(friction);
        world_.addRigidBody(floor_.get());
        plate_.setMargin(0.0002f);
        plate_.calculateLocalInertia(mass, inertia_);
    }
    ~BulletHeap() override {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
        world_.removeRigidBody(floor_.get());
    }
    BulletHeap(const BulletHeap&) = delete;
    BulletHeap& operator=(const BulletHeap&) = delete;

    void add(const lr_body_desc& start) override {
        const btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &plate_, inertia_);
        const float *const x = start.position, *const v = start.linear_velocity, *const q = start.orientation;
        btQuaternion turn(q[0], q[1], q[2], q[3]);
        turn.normalize();
        auto& body = bodies_.emplace_back(std::make_unique<btRigidBody>(info));
        body->setWorldTransform(btTransform(turn, {x[0], x[1], x[2]}));
        body->setLinearVelocity({v[0], v[1], v[2]});
        body->setFriction(friction);
        // Its limits of sleep are for bodies of a metre.
        body->setSleepingThresholds(0.02f, 0.5f);
        world_.addRigidBody(body.get());
    }
    void step() override {
        for (uint32_t i = 0; i < substeps; ++i) {
            for (const auto& body : bodies_) {
                if (!body->isActive()) continue;
                const btVector3 v = body->getLinearVelocity();
                body->applyCentralForce(-(mass * gravity / (fall_speed * fall_speed)) * v.length() * v);
            }
            world_.stepSimulation(step_seconds / substeps, 0);
        }
    }
    Seen look() const override {
        Seen seen{};
        for (const auto& body : bodies_) {
            if (!body->isActive()) continue;
            ++seen.awake;
            if (body->getLinearVelocity().length() > 0.3f) ++seen.fast;
        }
        return seen;
    }
    std::vector<test::Pose> poses() const override {
        std::vector<test::Pose> poses;
        for (const auto& body : bodies_) {
            const btVector3 x = body->getWorldTransform().getOrigin();
            const btQuaternion q = body->getWorldTransform().getRotation();
            const auto wide = [](btScalar value) { return static_cast<double>(value); };
            poses.push_back(
                {{wide(x.x()), wide(x.y()), wide(x.z())}, {wide(q.x()), wide(q.y()), wide(q.z()), wide(q.w())}});
        }
        return poses;
    }

private:
    static constexpr btScalar friction = 0.70710678f; // Bullet multiplies both: 0.5
    static constexpr auto mass = static_cast<btScalar>(plate_mass);

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
    btStaticPlaneShape ground_{{0.0f, 1.0f, 0.0f}, 0.0f};
    btBoxShape plate_{{static_cast<btScalar>(plate_half[0]), static_cast<btScalar>(plate_half[1]),
                       static_cast<btScalar>(thicker* plate_half[2])}};
    btVector3 inertia_;
    std::unique_ptr<btRigidBody> floor_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

} // namespace

std::unique_ptr<Peer> make_bullet_heap() {
    return std::make_unique<BulletHeap>();
}
#else
std::unique_ptr<Peer> make_bullet_heap() {
    return nullptr;
}
#endif
} // namespace bench
