// The solver for body contact alone, against closed forms and exact solutions of small systems.
#include "body_contact/body_contact_solver.h"

#include "body_contact/contact_tiles.h"
#include "kernel/integrator/step.h"
#include "support/quick.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

using namespace lr;

namespace {

constexpr float h = 1.0f / 120.0f, gravity = 9.81f;
constexpr double fall = 9.81 / 120.0; // m/s in a substep
constexpr uint32_t nobody = BodyContactPair::nobody;

const int rounds = quick() ? 20 : 300;

float narrow(double x) {
    return static_cast<float>(x);
}
Vector vector_of(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

// Solid balls of 1 kg and 1 m radius at scale 1, without a fluid.
BodyConstants ball() {
    BodyConstants c{};
    c.length = c.unit_mass = 1.0f;
    for (size_t k : {0u, 6u, 11u}) c.full_mass[k] = c.full_inverse[k] = 1.0f;
    for (size_t k : {15u, 18u, 20u}) c.full_mass[k] = 0.4f, c.full_inverse[k] = 2.5f;
    return c;
}

// Balls without spin at the start of a substep, and their contacts.
struct Balls {
    StepWorkers step_workers;
    struct Contact {
        BodyContactFrame frame;
        BodyContactPoint point;
    };
    std::vector<Contact> contacts;
    std::vector<BodyContactPair> units;
    Allocator allocator;
    BodyContactSolver solver{allocator};
    std::vector<uint32_t> tiles; // by body; none yet: all are in one
    uint32_t levels = 0;
    uint32_t count;
    BodyConstants body = ball();

    explicit Balls(uint32_t balls, uint32_t workers = 0) : count(balls) {
        REQUIRE(step_workers.start(workers, {}));
        REQUIRE(solver.reserve_bodies((balls + 31) / 32 * 32));
        for (uint32_t i = 0; i < (balls + 31) / 32 * 32; ++i) {
            SolverBody& b = at(i) = SolverBody{};
            b.scale = b.q[3] = b.q0[3] = 1.0f;
        }
    }
    ~Balls() { step_workers.stop(); }
    Balls(const Balls&) = delete;
    Balls& operator=(const Balls&) = delete;

    SolverBody& at(uint32_t i) { return solver.bodies()[i]; }
    double mass(uint32_t i) { return std::pow(wide(at(i).scale), 3.0); }
    // At x at the start of the substep, with this velocity throughout.
    void place(uint32_t i, float scale, Vector x, Vector v) {
        SolverBody& b = at(i);
        const float from[3] = {x.x, x.y, x.z}, speed[3] = {v.x, v.y, v.z};
        for (size_t k = 0; k < 3; ++k) {
            b.x0[k] = from[k];
            b.x[k] = from[k] + h * speed[k];
            b.v0[k] = b.v[k] = speed[k];
        }
        b.scale = scale;
    }
    void add(uint32_t a, uint32_t b, const BodyContactFrame& frame, const BodyContactPoint& point) {
        contacts.push_back({frame, point});
        units.push_back({a, b, nullptr, nullptr, 1});
    }
    // At the nearest points of their surfaces.
    void touch(uint32_t a, uint32_t b, float friction = 0.0f, float restitution = 0.0f) {
        const Vector from = vector_of(at(a).x0) - vector_of(at(b).x0);
        const float far = length(from);
        const Vector n = 1.0f / far * from;
        add(a, b, {n, {}, {}, friction, restitution, false},
            {-at(a).scale * n, at(b).scale * n, far - at(a).scale - at(b).scale});
    }
    void stand_on(uint32_t a, float floor, float friction = 0.0f) {
        add(a, nobody, {{0.0f, 1.0f, 0.0f}, {}, {}, friction, 0.0f, true},
            {{0.0f, -at(a).scale, 0.0f}, {}, at(a).x[1] - at(a).scale - floor});
    }
    void cut(uint32_t into) {
        std::vector<TiledBody> placed;
        for (uint32_t i = 0; i < count; ++i) placed.push_back({{at(i).x[0], at(i).x[1], at(i).x[2]}, 0, i, i, 0});
        levels = into;
        cut_into_tiles(placed.data(), count, levels);
        tiles.assign((count + 31) / 32 * 32, 0);
        for (const TiledBody& one : placed) tiles[one.body] = one.tile;
    }
    void solve() {
        for (size_t i = 0; i < units.size(); ++i)
            units[i].frame = &contacts[i].frame, units[i].contact = &contacts[i].point;
        const SolverBodyKind kind{&body, 1.0f, 1.0f, 1.0f, 0.0f};
        const BodyContactRange range{0, 0, count};
        const FloatMode mode;
        tiles.resize((count + 31) / 32 * 32);
        const BodyContactScene scene{&kind,        &range, 1, units.data(), static_cast<uint32_t>(units.size()),
                                     tiles.data(), levels};
        REQUIRE(solver.solve(*find_target(LR_SIMD_AUTO)->body_contact, h, gravity, scene, Workers(step_workers, mode)));
    }
    // N s, along the normal of a unit.
    double pressed(size_t unit) { return wide(solver.pressed(units[unit], 0)) * mass(units[unit].a); }
    struct Sums {
        double momentum[3] = {}, angular[3] = {}, energy = 0.0, size = 0.0;
    };
    Sums sums() {
        Sums s;
        for (uint32_t i = 0; i < count; ++i) {
            const SolverBody& b = at(i);
            const double m = mass(i), turns = 0.4 * m * wide(b.scale) * wide(b.scale);
            // Spins are along the body's axes, and the motion can have rotated it a little.
            const Rotation q{b.q[0], b.q[1], b.q[2], b.q[3]};
            const Vector v = rotate(q, vector_of(b.v)), w = rotate(q, vector_of(b.w));
            const double x[3] = {wide(b.x[0]), wide(b.x[1]), wide(b.x[2])},
                         p[3] = {m * wide(v.x), m * wide(v.y), m * wide(v.z)};
            const double own[3] = {turns * wide(w.x), turns * wide(w.y), turns * wide(w.z)};
            for (size_t k = 0; k < 3; ++k) {
                s.momentum[k] += p[k];
                s.angular[k] += own[k] + x[(k + 1) % 3] * p[(k + 2) % 3] - x[(k + 2) % 3] * p[(k + 1) % 3];
                s.energy += 0.5 * p[k] * p[k] / m + 0.5 * own[k] * own[k] / turns;
            }
            s.size += m * wide(length(v));
        }
        return s;
    }
};

// Minimum of 1/2 p.(G p) + (u - t).p over p >= 0, by trying all active sets: the optimum satisfies G p + u >= t.
std::vector<double> exact(const std::vector<std::vector<double>>& g, const std::vector<double>& u,
                          const std::vector<double>& t) {
    const size_t n = u.size();
    double scale = 0.0;
    for (double x : u) scale = std::max(scale, std::abs(x));
    for (uint32_t set = 0; set < 1u << n; ++set) {
        std::vector<size_t> act;
        for (size_t i = 0; i < n; ++i)
            if (set >> i & 1u) act.push_back(i);
        const size_t m = act.size();
        std::vector<std::vector<double>> a(m, std::vector<double>(m + 1));
        for (size_t i = 0; i < m; ++i) {
            for (size_t j = 0; j < m; ++j) a[i][j] = g[act[i]][act[j]];
            a[i][m] = t[act[i]] - u[act[i]];
        }
        bool regular = true;
        for (size_t c = 0; c < m && regular; ++c) {
            size_t best = c;
            for (size_t r = c; r < m; ++r) best = std::abs(a[r][c]) > std::abs(a[best][c]) ? r : best;
            std::swap(a[c], a[best]);
            regular = std::abs(a[c][c]) > 1e-9;
            for (size_t r = 0; r < m && regular; ++r) {
                if (r == c) continue;
                const double by = a[r][c] / a[c][c];
                for (size_t k = c; k <= m; ++k) a[r][k] -= by * a[c][k];
            }
        }
        if (!regular) continue;
        std::vector<double> p(n, 0.0);
        bool good = true;
        for (size_t i = 0; i < m; ++i) {
            p[act[i]] = a[i][m] / a[i][i];
            good = good && p[act[i]] >= 0.0;
        }
        for (size_t i = 0; i < n && good; ++i) {
            double after = u[i] - t[i];
            for (size_t j = 0; j < n; ++j) after += g[i][j] * p[j];
            good = after > -1e-7 * scale;
        }
        if (good) return p;
    }
    return {};
}

} // namespace

TEST_CASE("two balls at every mass ratio leave as momentum and restitution say, and do not overlap") {
    test::Random random(11);
    double worst = 0.0, deepest = 0.0, lost = 0.0;
    for (int i = 0; i < rounds; ++i) {
        const float small = narrow(random.logarithmic(0.01, 1.0)), ratio = narrow(random.logarithmic(1.0, 10.0));
        const float e = 0.5f * static_cast<float>(random.below(3)), speed = narrow(random.uniform(2.0, 10.0) * fall);
        const bool swapped = random.below(2) == 0;
        Balls balls(2);
        const uint32_t a = swapped ? 1 : 0, b = 1 - a;
        const float gap = narrow(random.uniform(0.1, 0.9)) * 1.5f * speed * h;
        const float apart = small + ratio * small + gap;
        balls.place(a, small, {}, {speed, 0.0f, 0.0f});
        balls.place(b, ratio * small, {apart, 0.0f, 0.0f}, {-0.5f * speed, 0.0f, 0.0f});
        balls.touch(0, 1, 0.5f, e);
        const Balls::Sums before = balls.sums();
        balls.solve();
        const Balls::Sums after = balls.sums();
        const double m = balls.mass(a), n = balls.mass(b), v = wide(speed), come = 1.5 * v;
        const double impulse = (1.0 + wide(e)) * come * m * n / (m + n);
        worst = std::max(worst, std::abs(wide(balls.at(a).v[0]) - (v - impulse / m)) / come);
        worst = std::max(worst, std::abs(wide(balls.at(b).v[0]) - (-0.5 * v + impulse / n)) / come);
        worst = std::max(worst, std::abs(balls.pressed(0) - impulse) / impulse);
        lost = std::max(lost, std::abs(after.momentum[0] - before.momentum[0]) / before.size);
        const double between =
            wide(balls.at(b).x[0]) - wide(balls.at(a).x[0]) - wide(small) - wide(ratio) * wide(small);
        deepest = std::max(deepest, -between / wide(small));
    }
    MESSAGE("velocities " << worst << ", momentum " << lost << ", overlap " << deepest);
    CHECK(worst < 1e-3);
    CHECK(lost < 1e-6);
    CHECK(deepest < 1e-3);
}

TEST_CASE("a row of balls that is hit keeps momentum and gains no energy, with any number and mass") {
    test::Random random(12);
    double lost = 0.0, gained = -1.0, through = 0.0;
    for (uint32_t count : {3u, 5u, 10u, 40u})
        for (double spread : {1.0, 3.0}) {
            Balls balls(count);
            float x = 0.0f, former = 0.0f;
            const float speed = 1.0f;
            for (uint32_t i = 0; i < count; ++i) {
                const float scale = 0.1f * narrow(random.logarithmic(1.0, spread + 1e-6));
                if (i > 0) x += former + scale + (i == 1 ? 0.5f * speed * h : 0.0f);
                balls.place(i, scale, {x, 0.0f, 0.0f}, {i == 0 ? speed : 0.0f, 0.0f, 0.0f});
                former = scale;
            }
            for (uint32_t i = 0; i + 1 < count; ++i) balls.touch(i, i + 1, 0.3f, 1.0f);
            const Balls::Sums before = balls.sums();
            balls.solve();
            const Balls::Sums after = balls.sums();
            // The static lock holds speeds below a hundredth of g h.
            double locked = 0.0;
            for (uint32_t i = 0; i < count; ++i) locked += 0.01 * fall * balls.mass(i);
            lost = std::max(lost, std::abs(after.momentum[0] - before.momentum[0]) / locked);
            gained = std::max(gained, after.energy / before.energy - 1.0);
            for (uint32_t i = 0; i + 1 < count; ++i)
                through = std::max(through, wide(balls.at(i).v[0]) - wide(balls.at(i + 1).v[0]));
        }
    MESSAGE("momentum " << lost << ", energy " << gained << ", closing " << through);
    CHECK(lost < 1.0);
    CHECK(gained < 2e-4);
    CHECK(through < 0.05);
}

TEST_CASE("a stack carries its weight: each contact what is above it, the ground all") {
    struct Height {
        uint32_t balls;
        double error; // relative to the weight of all
    };
    for (const Height height : {Height{1, 1e-3}, {2, 1e-3}, {5, 1e-3}, {8, 0.05}})
        for (double scale : {0.003, 0.1, 3.0}) {
            const uint32_t count = height.balls;
            CAPTURE(count);
            CAPTURE(scale);
            Balls balls(count);
            const float r = narrow(scale);
            for (uint32_t i = 0; i < count; ++i) {
                balls.place(i, r, {0.0f, r * static_cast<float>(2 * i + 1), 0.0f}, {0.0f, -gravity * h, 0.0f});
                balls.at(i).v0[1] = 0.0f;
            }
            balls.stand_on(0, 0.0f, 0.5f);
            for (uint32_t i = 0; i + 1 < count; ++i) balls.touch(i + 1, i, 0.5f);
            balls.solve();
            const double weight = balls.mass(0) * fall;
            double off = 0.0, sinks = 0.0, went = 0.0;
            for (uint32_t i = 0; i < count; ++i) {
                off = std::max(off,
                               std::abs(balls.pressed(i) / (count * weight) - static_cast<double>(count - i) / count));
                sinks = std::max(sinks, std::abs(wide(balls.at(i).v[1])) / fall);
                went = std::max(went, std::abs(wide(balls.at(i).x[1]) - wide(balls.at(i).x0[1])) / (wide(h) * fall));
            }
            MESSAGE(count << " of " << scale << ": impulses " << off << ", speed " << sinks << " of g h, way " << went
                          << " of g h^2");
            CHECK(off < height.error);
            CHECK(sinks < 2.0 * height.error);
            CHECK(went < 3.0 * height.error);
        }
}

TEST_CASE("a body lies on one of a five-hundredth of its weight") {
    for (float ratio : {1.0f, 3.0f, 8.0f}) {
        CAPTURE(ratio);
        Balls balls(2);
        balls.place(0, 0.1f, {0.0f, 0.1f, 0.0f}, {0.0f, -gravity * h, 0.0f});
        balls.place(1, 0.1f * ratio, {0.0f, 0.2f + 0.1f * ratio, 0.0f}, {0.0f, -gravity * h, 0.0f});
        balls.stand_on(0, 0.0f);
        balls.touch(0, 1);
        balls.solve();
        const double light = balls.mass(0) * fall, heavy = balls.mass(1) * fall;
        CHECK(balls.pressed(1) == doctest::Approx(heavy).epsilon(1e-3));
        CHECK(balls.pressed(0) == doctest::Approx(light + heavy).epsilon(1e-3));
    }
}

TEST_CASE("small systems without friction come to the velocities of the exact solution") {
    test::Random random(13);
    double worst = 0.0, sum = 0.0;
    int solved = 0;
    for (int i = 0; i < rounds; ++i) {
        const uint32_t count = 2 + random.below(3), links = 1 + random.below(6);
        Balls balls(count);
        for (uint32_t n = 0; n < count; ++n) {
            const auto any = [&](double most) {
                return Vector{random.real(-most, most), random.real(-most, most), random.real(-most, most)};
            };
            balls.place(n, narrow(random.logarithmic(0.5, 2.0)), any(1.0), any(0.9 * fall));
            SolverBody& b = balls.at(n);
            std::copy_n(b.x0, 3, b.x); // it has not moved yet, because the position update leaves all bodies in place
        }
        struct Link {
            uint32_t a, b;
            double n[3], at[3];
        };
        std::vector<Link> all;
        for (uint32_t k = 0; k < links; ++k) {
            const uint32_t a = random.below(count), b = (a + 1 + random.below(count - 1)) % count;
            Vector n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
            n = 1.0f / length(n) * n;
            const Vector from = vector_of(balls.at(a).x0), to = vector_of(balls.at(b).x0);
            const Vector p =
                0.5f * (from + to) + Vector{random.real(-0.5, 0.5), random.real(-0.5, 0.5), random.real(-0.5, 0.5)};
            balls.add(a, b, {n, {}, {}, 0.0f, 0.0f, false}, {p - from, p - to, 0.0f});
            all.push_back({a, b, {wide(n.x), wide(n.y), wide(n.z)}, {wide(p.x), wide(p.y), wide(p.z)}});
        }
        // Rows over all bodies: normals and their moments about the centres.
        const size_t size = 6 * size_t{count};
        std::vector<std::vector<double>> rows(links, std::vector<double>(size)), g(links, std::vector<double>(links));
        std::vector<double> v(size), inverse(size), u(links), target(links, 0.0);
        for (uint32_t n = 0; n < count; ++n)
            for (size_t k = 0; k < 3; ++k) {
                v[6 * size_t{n} + k] = wide(balls.at(n).v[k]);
                inverse[6 * size_t{n} + k] = 1.0 / balls.mass(n);
                inverse[6 * size_t{n} + k + 3] = 2.5 / (balls.mass(n) * std::pow(wide(balls.at(n).scale), 2.0));
            }
        for (uint32_t k = 0; k < links; ++k)
            for (int side = 0; side < 2; ++side) {
                const Link& l = all[k];
                const uint32_t n = side == 0 ? l.a : l.b;
                double arm[3];
                for (size_t c = 0; c < 3; ++c) arm[c] = l.at[c] - wide(balls.at(n).x0[c]);
                for (size_t c = 0; c < 3; ++c) {
                    const double sign = side == 0 ? 1.0 : -1.0;
                    rows[k][6 * size_t{n} + c] = sign * l.n[c];
                    rows[k][6 * size_t{n} + c + 3] =
                        sign * (arm[(c + 1) % 3] * l.n[(c + 2) % 3] - arm[(c + 2) % 3] * l.n[(c + 1) % 3]);
                }
            }
        for (uint32_t k = 0; k < links; ++k)
            for (size_t c = 0; c < size; ++c) {
                u[k] += rows[k][c] * v[c];
                for (uint32_t l = 0; l < links; ++l) g[k][l] += rows[k][c] * inverse[c] * rows[l][c];
            }
        const std::vector<double> p = exact(g, u, target);
        if (p.empty()) continue;
        for (uint32_t k = 0; k < links; ++k)
            for (size_t c = 0; c < size; ++c) v[c] += inverse[c] * rows[k][c] * p[k];
        balls.solve();
        ++solved;
        double apart = 0.0;
        for (uint32_t n = 0; n < count; ++n)
            for (size_t k = 0; k < 3; ++k) {
                apart = std::max(apart, std::abs(wide(balls.at(n).v[k]) - v[6 * size_t{n} + k]));
                const double spin = wide(balls.at(n).w[k]) - v[6 * size_t{n} + k + 3];
                apart = std::max(apart, wide(balls.at(n).scale) * std::abs(spin));
            }
        worst = std::max(worst, apart / fall);
        sum += apart / fall;
    }
    MESSAGE(solved << " systems; worst " << worst << ", mean " << sum / solved << " of g h");
    CHECK(solved > rounds * 9 / 10);
    CHECK(sum / solved < 2e-3);
    CHECK(worst < 0.3); // with nearly parallel contacts twenty sweeps are few
}

TEST_CASE("impulses are equal and opposite: momentum and angular momentum of heaps in the air are kept") {
    test::Random random(14);
    double lost = 0.0, turned = 0.0;
    for (int i = 0; i < rounds / 4; ++i) {
        const uint32_t count = 20;
        Balls balls(count);
        for (uint32_t n = 0; n < count; ++n) {
            const auto any = [&](double most) {
                return Vector{random.real(-most, most), random.real(-most, most), random.real(-most, most)};
            };
            balls.place(n, narrow(random.logarithmic(0.05, 0.5)), any(0.7), any(1.0));
        }
        for (uint32_t a = 0; a < count; ++a)
            for (uint32_t b = a + 1; b < count; ++b) {
                const float between = length(vector_of(balls.at(a).x0) - vector_of(balls.at(b).x0));
                const float gap = between - balls.at(a).scale - balls.at(b).scale;
                if (gap > -0.01f && gap < 0.02f) balls.touch(a, b, 0.5f, 0.3f);
            }
        if (balls.units.empty()) continue;
        const Balls::Sums before = balls.sums();
        balls.solve();
        const Balls::Sums after = balls.sums();
        for (size_t k = 0; k < 3; ++k) {
            lost = std::max(lost, std::abs(after.momentum[k] - before.momentum[k]) / before.size);
            turned = std::max(turned, std::abs(after.angular[k] - before.angular[k]) / before.size);
        }
    }
    MESSAGE("momentum " << lost << ", angular " << turned);
    CHECK(lost < 1e-6);
    CHECK(turned < 0.01); // from sideways motion of the position update itself
}

TEST_CASE("the same bits with any number of workers, and whichever of a pair is named first") {
    constexpr uint32_t count = 4000;
    std::vector<SolverBody> first;
    for (uint32_t workers : {0u, 1u, 3u})
        for (bool swapped : {false, true}) {
            test::Random random(15);
            Balls balls(count, workers);
            for (uint32_t n = 0; n < count; ++n) {
                const uint32_t layer = n / 400, row = n / 20 % 20, column = n % 20;
                const float scale = narrow(random.uniform(0.4, 0.5));
                balls.place(
                    n, scale,
                    {static_cast<float>(column), 0.5f + 0.9f * static_cast<float>(layer), static_cast<float>(row)},
                    {random.real(-0.1, 0.1), -gravity * h, random.real(-0.1, 0.1)});
                if (n < 400) balls.stand_on(n, 0.0f, 0.4f);
            }
            for (uint32_t n = 0; n < count; ++n)
                for (uint32_t other : {n + 1, n + 20, n + 400}) {
                    if (other >= count || (other == n + 1 && n % 20 == 19) || (other == n + 20 && n % 400 >= 380))
                        continue;
                    if (swapped && balls.at(n).scale != balls.at(other).scale)
                        balls.touch(other, n, 0.4f);
                    else
                        balls.touch(n, other, 0.4f);
                }
            balls.cut(tile_levels(count));
            balls.solve();
            if (first.empty()) first.assign(balls.solver.bodies(), balls.solver.bodies() + count);
            uint32_t differ = 0;
            for (uint32_t n = 0; n < count; ++n)
                differ += std::memcmp(balls.at(n).x, first[n].x, sizeof first[n].x) != 0 ||
                          std::memcmp(balls.at(n).v, first[n].v, sizeof first[n].v) != 0;
            CAPTURE(workers);
            CAPTURE(swapped);
            CHECK(differ == 0);
        }
    uint32_t moved = 0;
    for (const SolverBody& b : first) moved += b.v[1] != -gravity * h;
    CHECK(moved > count / 2);
}

// A block must not hold a body twice: the later impulse would be lost. Of a hub's 200 contacts each has to go into a block of its own.
TEST_CASE("a ball between 200 others that fly at it keeps the momentum of all, cut into tiles and not") {
    constexpr uint32_t count = 201;
    for (const bool tiled : {false, true}) {
        CAPTURE(tiled);
        test::Random random(16);
        Balls balls(count);
        balls.place(0, 1.0f, {}, {});
        for (uint32_t n = 1; n < count; ++n) {
            Vector away{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
            away = 1.0f / length(away) * away;
            balls.place(n, 0.3f, 1.31f * away, random.real(-3.0, -1.0) * away);
            balls.touch(n, 0);
        }
        if (tiled) balls.cut(3);
        const Balls::Sums before = balls.sums();
        balls.solve();
        const Balls::Sums after = balls.sums();
        double lost = 0.0, hits = 0.0;
        for (size_t k = 0; k < 3; ++k) lost = std::max(lost, std::abs(after.momentum[k] - before.momentum[k]));
        for (uint32_t n = 0; n + 1 < count; ++n) hits += balls.pressed(n) > 0.0 ? 1.0 : 0.0;
        CHECK(lost < 1e-5 * before.size);
        CHECK(hits > 150.0);
    }
}
