// MuJoCo: free ellipsoids in its ellipsoid fluid model (added mass, blunt and slender drag, Magnus and Kutta lift), without
// contacts and constraints.
#include "lr_bench/leaf.h"
#include "peers/peers.h"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <cstring>

namespace lr_bench {
namespace {

std::string model_text(const Row& row) {
    char line[400];
    std::snprintf(
        line, sizeof line,
        "<mujoco><option timestep=\"%.9g\" integrator=\"%s\" density=\"%g\" viscosity=\"%g\" gravity=\"0 -9.81 0\">"
        "<flag contact=\"disable\" constraint=\"disable\"/></option><worldbody>",
        static_cast<double>(substep_seconds), row.integrator == "rk4" ? "RK4" : "Euler", air_density,
        air_viscosity * air_density);
    std::string text = line;
    for (uint32_t i = 0; i < row.bodies; ++i) {
        const auto within = [&](uint32_t k, double limit) {
            return limit * (2.0 * static_cast<double>(uniform(13 * uint64_t{i} + k)) - 1.0);
        };
        std::snprintf(
            line, sizeof line,
            "<body pos=\"%g %g %g\" quat=\"%g %g %g %g\"><freejoint/><geom type=\"ellipsoid\" size=\"%g %g %g\" "
            "density=\"%g\" fluidshape=\"ellipsoid\"/></body>",
            within(0, 50), within(1, 50), within(2, 50), within(12, 1) + 0.01, within(9, 1), within(10, 1),
            within(11, 1), leaf_semi_axes[0], leaf_semi_axes[1], leaf_semi_axes[2], leaf_density);
        text += line;
    }
    return text + "</worldbody></mujoco>";
}

class Mujoco final : public Subject {
public:
    ~Mujoco() override {
        mj_deleteData(data_);
        mj_deleteModel(model_);
    }

    bool make(const Row& row, std::string& why_not) {
        const std::string text = model_text(row);
        const auto files = std::make_unique<mjVFS>();
        mj_defaultVFS(files.get());
        if (mj_makeEmptyFileVFS(files.get(), "leaves.xml", static_cast<int>(text.size())) != 0) return false;
        std::memcpy(files->filedata[mj_findFileVFS(files.get(), "leaves.xml")], text.data(), text.size());
        char error[300] = "";
        model_ = mj_loadXML("leaves.xml", files.get(), error, sizeof error);
        mj_deleteVFS(files.get());
        if (!model_) why_not = error;
        data_ = model_ ? mj_makeData(model_) : nullptr;
        return data_ != nullptr;
    }

    bool step() override {
        const DenormalsFlushed flushed;
        mj_step(model_, data_);
        return true;
    }
    uint64_t lost() const override {
        uint64_t count = 0;
        for (int i = 0; i < model_->nq; i += 7) count += !std::isfinite(data_->qpos[i + 1]);
        // It resets itself if a number is too large.
        for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
            count += static_cast<uint64_t>(data_->warning[warning].number);
        return count;
    }

private:
    mjModel* model_ = nullptr;
    mjData* data_ = nullptr;
};

} // namespace

std::unique_ptr<Subject> make_mujoco(const Row& row, std::string& why_not) {
    auto made = std::make_unique<Mujoco>();
    if (!made->make(row, why_not)) return nullptr;
    return made;
}

} // namespace lr_bench
