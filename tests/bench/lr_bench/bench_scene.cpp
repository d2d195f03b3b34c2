// Scenes of a game, one ingredient more at a time: ns a body and step of 1/60 s with one substep, leaves with a full mass matrix.
//     bench_scene [--csv FILE] [--bodies N] [--only SCENE] [--seconds S]
// Rows are timed in turns, a step each; medians of processor time with one thread, of wall time with two. `hash` is of the world after four steps.
// Peers: Bullet and ODE, as many bodies under gravity and drag alone.
#include "bench/landing_scene.h"
#include "lr_bench/measure.h"
#include "peers/peers.h"

#include <algorithm>
#include <cinttypes>
#include <cstdlib>
#include <cstring>

namespace {

using namespace lr_bench;

enum Ingredient : uint32_t {
    uniform_wind = 1,
    gusts = 2,
    turbulence = 4,
    eddies_within = 8, // two octaves of turbulence, else one
    ground_wind = 16,
    vortices = 32,
    velocity_grid = 64,
    heightfield = 128,
    solids = 256, // a hundred colliders, the heightfield among them
    rules = 512,
    events = 1024,
    transforms = 2048,
    far_sources = 4096,
    callback = 8192,
    batch_force = 16384,
    body_forces = 32768, // on each body, anew in each step
    eight_volumes = 65536
};
constexpr uint32_t wind_of_park = uniform_wind | gusts | turbulence | eddies_within | ground_wind,
                   park = wind_of_park | heightfield | solids | rules;
struct Scene {
    const char* name;
    uint32_t ingredients;
};
constexpr Scene scenes[] = {{"still", 0},
                            {"uniform", uniform_wind},
                            {"gusts", uniform_wind | gusts},
                            {"ground", uniform_wind | gusts | ground_wind},
                            {"turbulence", uniform_wind | gusts | turbulence},
                            {"octaves", uniform_wind | gusts | turbulence | eddies_within},
                            {"wind", wind_of_park | vortices},
                            {"grid", velocity_grid},
                            {"far-sources", gusts | far_sources},
                            {"callback", callback},
                            {"heightfield", heightfield},
                            {"solids", solids},
                            {"rules", rules},
                            {"eight-volumes", rules | eight_volumes},
                            {"batch-force", batch_force},
                            {"body-forces", body_forces},
                            {"events", rules | events},
                            {"transforms", transforms},
                            {"park", park},
                            {"park-seen", park | events | transforms}};

class Subject final : public lr_bench::Subject {
public:
    bool make(const Row& row) {
        const auto* const scene =
            std::find_if(std::begin(scenes), std::end(scenes), [&](const Scene& s) { return row.path == s.name; });
        if (scene == std::end(scenes)) return false;
        with_ = scene->ingredients;
        bodies_ = row.bodies;
        // Dense as in an avenue in autumn: a body in 0.5 m^3, above the highest collider.
        const float high = 1.5f + static_cast<float>(bodies_) * 0.5f / (bench::side * bench::side);
        if (!scene_.make(leaf(), bodies_, row.workers) || !scene_.emit(bodies_, 1.5f, std::max(high, 10.0f)) ||
            !add_wind() || !add_things())
            return false;
        lr_world_info info;
        lr_world_info_init(&info, sizeof info);
        facts_.hashed = lr_world_get_info(scene_.world(), &info) == LR_OK;
        facts_.memory_bytes = static_cast<double>(info.memory_bytes) / bodies_;
        for (int i = 0; i < 4; ++i)
            if (!step()) return false;
        facts_.hash = scene_.hash();
        scene_.save();
        return true;
    }
    bool step() override {
        // Bodies must not land, or the row would be another: every two seconds they begin again.
        if (++steps_ % 120 == 0) scene_.restore();
        if (!lifts_.empty()) {
            auto f = initialised(lr_force_arrays_init);
            f.count = bodies_;
            for (const float*& p : f.force) p = lifts_.data();
            if (lr_batch_add_forces(scene_.world(), scene_.batch(), &f) != LR_OK) return false;
        }
        if (lr_world_step(scene_.world(), bench::step_seconds, 1) != LR_OK) return false;
        if ((with_ & events) != 0) {
            lr_event_list list;
            lr_event_list_init(&list, sizeof list);
            if (lr_world_get_events(scene_.world(), &list) != LR_OK) return false;
        }
        return instances_.empty() ||
               lr_batch_write_transforms(scene_.world(), scene_.batch(), LR_TRANSFORM_3X4_ROW_MAJOR, instances_.data(),
                                         0, bodies_, nullptr) == LR_OK;
    }
    Facts facts() const override { return facts_; }

private:
    template <class D> static D initialised(lr_status (*init)(D*, uint32_t)) {
        D d;
        init(&d, sizeof d);
        return d;
    }
    // 7 cm x 4 cm x 0.2 mm, 0.1 g, its weight off centre.
    static lr_asset* leaf() {
        auto d = initialised(lr_ellipsoid_desc_init);
        d.semi_axes[0] = 0.035, d.semi_axes[1] = 0.02, d.semi_axes[2] = 0.0001;
        d.density = 350.0;
        d.center_of_mass[0] = 0.004, d.center_of_mass[1] = -0.001;
        lr_asset* asset = nullptr;
        return lr_asset_create_ellipsoid(&d, &asset) == LR_OK ? asset : nullptr;
    }
    bool add_wind() {
        lr_world* const world = scene_.world();
        bool ok = true;
        const auto need = [&](lr_status status) { ok = ok && status == LR_OK; };
        if ((with_ & uniform_wind) != 0) need(lr_world_set_uniform_wind(world, 2.0f, 0.0f, 0.5f));
        if ((with_ & gusts) != 0) {
            const auto d = initialised(lr_gusts_desc_init);
            need(lr_world_add_gusts(world, &d, nullptr));
        }
        if ((with_ & ground_wind) != 0) {
            const auto d = initialised(lr_ground_wind_desc_init);
            need(lr_world_add_ground_wind(world, &d, nullptr));
        }
        if ((with_ & turbulence) != 0) {
            auto d = initialised(lr_turbulence_desc_init);
            d.octaves = (with_ & eddies_within) != 0 ? 2 : 1;
            need(lr_world_add_turbulence(world, &d, nullptr));
        }
        for (int i = 0; i < 4 && (with_ & vortices) != 0; ++i) { // of people's size
            auto d = initialised(lr_vortex_desc_init);
            d.position[0] = 10.0f * static_cast<float>(i) - 15.0f, d.position[1] = 2.0f;
            d.outer_radius = d.half_length = 2.0f;
            need(lr_world_add_vortex(world, &d, nullptr));
        }
        for (int i = 0; i < 60 && (with_ & far_sources) != 0; ++i) {
            auto d = initialised(lr_vortex_desc_init);
            d.position[0] = 1e3f;
            d.outer_radius = d.half_length = 20.0f;
            need(lr_world_add_vortex(world, &d, nullptr));
        }
        if ((with_ & velocity_grid) != 0) {
            std::vector<float> samples(3 * 32 * 16 * 32 * 2);
            for (size_t i = 0; i < samples.size(); ++i) samples[i] = 2.0f * uniform(i) - 1.0f;
            auto d = initialised(lr_wind_grid_desc_init);
            d.position[0] = d.position[2] = -0.5f * bench::side;
            d.counts[0] = d.counts[2] = 32, d.counts[1] = 16;
            d.spacing[0] = d.spacing[2] = bench::side / 31.0f, d.spacing[1] = 1.5f;
            d.frames = 2;
            d.samples = samples.data();
            need(lr_world_add_wind_grid(world, &d, nullptr));
        }
        if ((with_ & callback) != 0) {
            const auto shear = [](void*, const lr_wind_query* q) {
                for (uint32_t i = 0; i < q->count; ++i) q->velocity[0][i] = 0.5f * q->position[1][i];
            };
            need(lr_world_set_wind_callback(world, shear, nullptr));
        }
        return ok;
    }
    bool add_things() {
        lr_world* const world = scene_.world();
        bool ok = true;
        if ((with_ & (heightfield | solids)) != 0) ok = scene_.add_ground(false, false, (with_ & solids) != 0 ? 98 : 0);
        if ((with_ & rules) != 0) {
            auto d = initialised(lr_batch_rules_init);
            d.volume_count = (with_ & eight_volumes) != 0 ? 8 : 1;
            for (lr_kill_volume& v : d.volumes)
                v = {LR_VOLUME_BOX, LR_KILL_OUTSIDE, {0, 0, 0}, {100.0f, 100.0f, 100.0f}};
            d.action = LR_END_RESPAWN;
            d.max_age = 60.0f;
            ok = ok && lr_batch_set_rules(world, scene_.batch(), &d) == LR_OK;
        }
        if ((with_ & events) != 0) ok = ok && lr_world_set_events(world, 65536, LR_EVENTS_ALL) == LR_OK;
        if ((with_ & batch_force) != 0) {
            auto f = initialised(lr_batch_force_init);
            f.force[1] = lift;
            ok = ok && lr_batch_set_force(world, scene_.batch(), &f) == LR_OK;
        }
        if ((with_ & body_forces) != 0) lifts_.assign(bodies_, lift);
        if ((with_ & transforms) != 0) instances_.resize(size_t{12} * bodies_);
        return ok;
    }

    bench::Scene scene_;
    uint32_t with_ = 0, bodies_ = 0, steps_ = 0;
    static constexpr float lift = 1e-5f; // N
    std::vector<float> instances_, lifts_;
    Facts facts_;
};

std::unique_ptr<lr_bench::Subject> make(const Row& row, std::string& why_not) {
    if (!row.ours()) return make_peer(row, why_not);
    auto subject = std::make_unique<Subject>();
    if (subject->make(row)) return subject;
    why_not = "scene";
    return nullptr;
}

std::vector<Row> rows_of(uint32_t bodies, const char* only) {
    std::vector<Row> rows;
    const auto add = [&](const char* scene, uint32_t workers, uint32_t count) {
        if (!only || std::strcmp(only, scene) == 0)
            rows.push_back({"langevin_rigid", "aerodynamic", "default", scene, "auto", workers, count, 1});
    };
    for (const Scene& s : scenes) add(s.name, 0, bodies);
    for (const uint32_t count : {bodies / 50, bodies, bodies * 10})
        for (const uint32_t workers : {0u, 1u})
            if (count != bodies || workers != 0) add("park", workers, count);
    std::vector<std::string> missing;
    for (Row& peer : peer_rows(bodies, missing))
        if (!only && peer.model == "drag" && peer.bodies == bodies) rows.push_back(std::move(peer));
    return rows;
}

} // namespace

int main(int argc, char** argv) {
    const char *csv = nullptr, *only = nullptr;
    uint32_t bodies = 100000;
    Schedule schedule;
    schedule.budget = 30.0, schedule.least_rounds = 9;
    for (int i = 1; i < argc; ++i) {
        const auto with_value = [&](const char* name) { return std::strcmp(argv[i], name) == 0 && i + 1 < argc; };
        if (with_value("--csv"))
            csv = argv[++i];
        else if (with_value("--only"))
            only = argv[++i];
        else if (with_value("--bodies"))
            bodies = static_cast<uint32_t>(std::strtoul(argv[++i], nullptr, 10));
        else if (with_value("--seconds"))
            schedule.budget = std::strtod(argv[++i], nullptr);
        else
            return std::fprintf(stderr, "bench_scene: unknown option %s\n", argv[i]), 1;
    }
    if (bodies < 50) return std::fprintf(stderr, "bench_scene: at least 50 bodies\n"), 1;
    schedule.burst = std::min(schedule.burst, schedule.budget / 2000.0);
    const std::vector<Measured> measured = measure(rows_of(bodies, only), make, schedule, 1.0);
    std::printf("%-16s %8s %7s %9s %9s  %s\n", "scene", "bodies", "threads", "CPU ns", "wall ns", "hash");
    for (const Measured& m : measured)
        if (m.row.subject != "clock")
            std::printf("%-16s %8u %7u %9.1f %9.1f  %016" PRIx64 "\n",
                        m.row.ours() ? m.row.path.c_str() : m.row.subject.c_str(), m.row.bodies, m.row.workers + 1,
                        m.cpu_median, m.wall_median, m.facts.hash);
    if (!csv) return 0;
    std::FILE* const file = std::fopen(csv, "w");
    if (!file) return std::fprintf(stderr, "bench_scene: cannot write %s\n", csv), 1;
    write_head(file);
    for (const Measured& m : measured) write_row(file, m);
    return std::fclose(file) == 0 ? 0 : 1;
}
