// ODE's world without geometry or joints: gravity, quadratic drag, dWorldQuickStep.
#include "lr_bench/leaf.h"
#include "peers/peers.h"

#include <ode/ode.h>

#include <cmath>
#include <vector>

namespace lr_bench {
namespace {

class Ode final : public Subject {
public:
    explicit Ode(const Row& row) {
        dInitODE2(0);
        dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
        world_ = dWorldCreate();
        dWorldSetGravity(world_, 0, -9.81, 0);
        dWorldSetAngularDamping(world_, 0.001);
        dMass mass;
        dMassSetZero(&mass);
        const double* const a = leaf_semi_axes;
        const double m = leaf_density * 4.0 / 3.0 * 3.14159265358979 * a[0] * a[1] * a[2];
        const auto moment = [&](int i, int j) { return m / 5.0 * (a[i] * a[i] + a[j] * a[j]); };
        dMassSetParameters(&mass, m, 0, 0, 0, moment(1, 2), moment(2, 0), moment(0, 1), 0, 0, 0);
        for (size_t i = 0; i < row.bodies; ++i) {
            const auto within = [&](size_t k, double limit) {
                return limit * (2.0 * static_cast<double>(uniform(13 * i + k)) - 1.0);
            };
            const dBodyID body = dBodyCreate(world_);
            dBodySetMass(body, &mass);
            dBodySetPosition(body, within(0, 50), within(1, 50), within(2, 50));
            const dQuaternion q = {within(12, 1), within(9, 1), within(10, 1), within(11, 1) + 0.01};
            dBodySetQuaternion(body, q);
            dBodySetLinearVel(body, within(3, 0.5), within(4, 0.5), within(5, 0.5));
            dBodySetAngularVel(body, within(6, 5), within(7, 5), within(8, 5));
            dBodySetAutoDisableFlag(body, 0);
            bodies_.push_back(body);
        }
    }
    ~Ode() override { dWorldDestroy(world_); }

    bool step() override {
        const DenormalsFlushed flushed;
        for (const dBodyID body : bodies_) {
            const dReal* const v = dBodyGetLinearVel(body);
            const dReal k = -drag_ * std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            dBodyAddForce(body, k * v[0], k * v[1], k * v[2]);
        }
        return dWorldQuickStep(world_, static_cast<dReal>(substep_seconds)) != 0;
    }
    uint64_t lost() const override {
        uint64_t count = 0;
        for (const dBodyID body : bodies_) count += !std::isfinite(dBodyGetPosition(body)[1]);
        return count;
    }

private:
    dWorldID world_ = nullptr;
    std::vector<dBodyID> bodies_;
    dReal drag_ = static_cast<dReal>(leaf_constants().drag);
};

} // namespace

std::unique_ptr<Subject> make_ode(const Row& row) {
    return std::make_unique<Ode>(row);
}

} // namespace lr_bench
