#include "peers/peers.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace lr_bench {

DenormalsFlushed::DenormalsFlushed() : before_(0) {
#if defined(__x86_64__)
    before_ = _mm_getcsr();
    _mm_setcsr(before_ | 0x8040u); // flush to zero, denormals are zero
#endif
}

DenormalsFlushed::~DenormalsFlushed() {
#if defined(__x86_64__)
    _mm_setcsr(before_);
#endif
}

std::vector<Row> peer_rows(uint32_t most, [[maybe_unused]] std::vector<std::string>& missing) {
    std::vector<Row> rows;
    const auto add = [&](const char* subject, const char* model, const char* integrator,
                         std::initializer_list<uint32_t> counts) {
        for (const uint32_t bodies : counts)
            if (bodies <= most) rows.push_back({subject, model, integrator, "diagonal", "compiler", 0, bodies, 1});
    };
    add("scalar", "langevin-speed", "rk4", {1, 1000, 10000, 100000});
#ifdef LR_BENCH_EIGEN
    add("eigen", "langevin-speed", "rk4", {1000, 10000, 100000});
#else
    missing.push_back("Eigen");
#endif
#ifdef LR_BENCH_BULLET
    add("bullet", "drag", "euler", {1000, 10000, 100000});
#else
    missing.push_back("Bullet");
#endif
#ifdef LR_BENCH_ODE
    add("ode", "drag", "euler", {1000, 10000, 100000});
#else
    missing.push_back("ODE");
#endif
#ifdef LR_BENCH_MUJOCO
    add("mujoco", "ellipsoid-fluid", "euler", {1, 10, 100, 1000});
    add("mujoco", "ellipsoid-fluid", "rk4", {1, 10, 100, 1000});
#else
    missing.push_back("MuJoCo");
#endif
    return rows;
}

std::unique_ptr<Subject> make_peer(const Row& row, std::string& why_not) {
    if (row.subject == "sketch") return make_sketch(row, why_not);
    if (row.subject == "scalar") return make_scalar(row);
#ifdef LR_BENCH_EIGEN
    if (row.subject == "eigen") return make_eigen(row);
#endif
#ifdef LR_BENCH_BULLET
    if (row.subject == "bullet") return make_bullet(row);
#endif
#ifdef LR_BENCH_ODE
    if (row.subject == "ode") return make_ode(row);
#endif
#ifdef LR_BENCH_MUJOCO
    if (row.subject == "mujoco") return make_mujoco(row, why_not);
#endif
    why_not = "not part of this build";
    return nullptr;
}

} // namespace lr_bench
