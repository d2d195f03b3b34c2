#include "body_contact/body_contact_solver.h"

#include "base/pose.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

namespace lr {
namespace {

constexpr auto lanes = static_cast<uint32_t>(contact_lanes);
constexpr uint32_t usual_colours = 64; // as bits; units without a free colour get blocks of their own
constexpr uint32_t body_contact_sweeps = 30, roll_every = 4;
constexpr uint32_t bounce_rounds = 2, bounce_sweeps = 3;
constexpr uint32_t held_sweeps = 4; // extra sweeps over fixed things: a heap must not press a body into a collider
// Blocks and groups of bodies that justify another thread: some microseconds of work.
constexpr uint32_t block_grain = 4, group_grain = 16;
} // namespace

bool BodyContactSolver::reserve_bodies(uint32_t count) {
    if (!grow(*allocator_, bodies_, size_t{count} + 1) || !grow(*allocator_, twists_, size_t{count} + 1) ||
        !grow(*allocator_, twists_before_, count) || !grow(*allocator_, directions_, count) ||
        !grow(*allocator_, used_colours_, count) || !grow(*allocator_, kind_of_, count / lanes + 1))
        return false;
    body_count_ = count;
    return true;
}

float BodyContactSolver::mass(const SolverBodyKind* kinds, uint32_t body) const {
    const float s = bodies_[body].scale;
    return kinds[kind_of(body)].body->unit_mass * s * s * s;
}

// Impulses are in the lighter body's mass unit: with sizes that differ by a thousand, the heavier one's would overflow.
void BodyContactSolver::order_pairs(const BodyContactScene& scene) {
    for (BodyContactPair& unit : std::span(scene.units, scene.unit_count)) {
        unit.swapped = unit.b != BodyContactPair::nobody && mass(scene.kinds, unit.b) < mass(scene.kinds, unit.a);
        if (unit.swapped) std::swap(unit.a, unit.b);
    }
}

// Each pair takes the lowest colour that its bodies do not have yet. Fixed things come last in a sweep: they must hold better than bodies do.
void BodyContactSolver::colour(const BodyContactScene& scene) {
    const std::span units(scene.units, scene.unit_count);
    std::fill_n(used_colours_.data(), body_count_, uint64_t{0});
    colour_count_ = 0;
    uint32_t late = usual_colours;
    for (BodyContactPair& unit : units) {
        if (unit.b == BodyContactPair::nobody) continue;
        uint64_t &of_a = used_colours_[unit.a], &of_b = used_colours_[unit.b];
        const uint64_t used = of_a | of_b;
        unit.colour = used == ~uint64_t{0} ? late++ : static_cast<uint32_t>(std::countr_one(used));
        colour_count_ = std::max(colour_count_, unit.colour + 1);
        if (unit.colour >= usual_colours) continue;
        of_a |= uint64_t{1} << unit.colour;
        of_b |= uint64_t{1} << unit.colour;
    }
    pair_colours_ = colour_count_;
    uint32_t before = BodyContactPair::nobody, colour = 0;
    for (BodyContactPair& unit : units) {
        if (unit.b != BodyContactPair::nobody) continue;
        colour = unit.a == before ? colour + 1 : pair_colours_;
        before = unit.a;
        unit.colour = colour;
        colour_count_ = std::max(colour_count_, colour + 1);
    }
}

// Blocks hold units of one colour and the same kinds, grouped by similar numbers of contacts.
bool BodyContactSolver::lay_out(const BodyContactScene& scene) {
    BodyContactPair* const units = scene.units;
    const uint32_t unit_count = scene.unit_count;
    if (!grow(*allocator_, order_, unit_count) || !grow(*allocator_, spare_, unit_count)) return false;
    group_count_ = 0;
    uint32_t kind_count = 1;
    for (const BodyContactRange& range : std::span(scene.ranges, scene.range_count)) {
        const uint32_t first = range.begin / lanes, groups = (range.count + lanes - 1) / lanes;
        std::fill_n(kind_of_.data() + first, groups, range.kind);
        group_count_ = std::max(group_count_, first + groups);
        kind_count = std::max(kind_count, range.kind + 1);
    }
    order_pairs(scene);
    colour(scene);
    const auto of_a = [&](const BodyContactPair& u) { return kind_of(u.a); };
    const auto of_b = [&](const BodyContactPair& u) { return kind_b(u); };
    for (uint32_t i = 0; i < unit_count; ++i) order_[i] = units + i;
    // Sorts by the last criterion first: each pass is stable.
    const auto sort_by = [&](uint32_t values, auto&& value) {
        if (values == 1) return true;
        if (!grow(*allocator_, first_unit_, values + 1)) return false;
        std::fill_n(first_unit_.data(), values + 1, 0u);
        for (uint32_t i = 0; i < unit_count; ++i) ++first_unit_[value(*order_[i]) + 1];
        for (uint32_t v = 0; v < values; ++v) first_unit_[v + 1] += first_unit_[v];
        for (uint32_t i = 0; i < unit_count; ++i) spare_[first_unit_[value(*order_[i])]++] = order_[i];
        order_.swap(spare_);
        return true;
    };
    if (!sort_by(block_contacts, [](const BodyContactPair& u) { return block_contacts - u.count; }) ||
        !sort_by(kind_count, of_b) || !sort_by(kind_count, of_a) ||
        !sort_by(colour_count_, [](const BodyContactPair& u) { return u.colour; }))
        return false;
    if (!grow(*allocator_, first_unit_, unit_count + 1) || !grow(*allocator_, first_block_, colour_count_ + 1))
        return false;
    block_count_ = 0;
    uint32_t colours = 0;
    for (uint32_t i = 0; i < unit_count;) {
        const BodyContactPair& first = *order_[i];
        while (colours <= first.colour) first_block_[colours++] = block_count_;
        first_unit_[block_count_] = i;
        for (uint32_t n = 0; n < lanes && i < unit_count; ++n, ++i) {
            const BodyContactPair& u = *order_[i];
            if (u.colour != first.colour || of_a(u) != of_a(first) || of_b(u) != of_b(first)) break;
        }
        ++block_count_;
    }
    while (colours <= colour_count_) first_block_[colours++] = block_count_;
    first_unit_[block_count_] = unit_count;
    if (!grow(*allocator_, blocks_, block_count_)) return false;
    for (uint32_t b = 0; b < block_count_; ++b)
        for (uint32_t i = first_unit_[b]; i < first_unit_[b + 1]; ++i) {
            BodyContactPair& unit = units[order_[i] - units];
            unit.block = b;
            unit.lane = i - first_unit_[b];
        }
    return true;
}

void BodyContactSolver::fill(const SolverBodyKind* kinds, uint32_t index) {
    PairBlock& block = blocks_[index];
    const uint32_t count = first_unit_[index + 1] - first_unit_[index];
    const BodyContactPair* const* const units = order_.data() + first_unit_[index];
    block.kind_a = kind_of(units[0]->a);
    block.kind_b = kind_b(*units[0]);
    block.lanes = count;
    block.used = 0;
    const BodyContactPoint none{{}, {}, {0.0f, 1.0f, 0.0f}, no_contact, {}, {}, 0.0f, 0.0f, false};
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        const BodyContactPair* const unit = lane < count ? units[lane] : nullptr;
        const bool pair = unit && unit->b != BodyContactPair::nobody, swapped = unit && unit->swapped;
        const BodyContactPoint& first = unit ? unit->contact[0] : none;
        const PathFriction friction = unit ? unit->friction : PathFriction{};
        block.a[lane] = unit ? unit->a : body_count_;
        block.b[lane] = pair ? unit->b : body_count_;
        if (unit) block.used = std::max(block.used, unit->count);
        block.ratio[lane] = pair ? mass(kinds, unit->a) / mass(kinds, unit->b) : 0.0f;
        put_in(block.normal, 0, lane, swapped ? -first.normal : first.normal);
        put_in(block.surface, 0, lane, first.surface);
        put_in(block.lag, 0, lane, first.lag);
        put_in(block.start_drag, 0, lane, swapped ? -friction.drag : friction.drag);
        block.start_spin[lane] = friction.spin;
        block.friction.most[lane] = first.friction;
        block.restitution[lane] = first.restitution;
        block.solid[lane] = first.solid ? 1.0f : 0.0f;
    }
    for (uint32_t k = 0; k < block.used; ++k)
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const bool there = lane < count && k < units[lane]->count;
            const BodyContactPoint& c = there ? units[lane]->contact[k] : none;
            const bool swapped = there && units[lane]->swapped;
            PairBlock::Place& to = block.place[k];
            put_in(to.arm_a, 0, lane, swapped ? c.arm_b : c.arm_a);
            put_in(to.arm_b, 0, lane, swapped ? c.arm_a : c.arm_b);
            to.gap[lane] = c.gap;
            to.start[lane] = c.pressed;
        }
}

// Blocks of a colour in parallel, colours one after the other.
template <class Function>
void BodyContactSolver::each_block(const Workers& workers, uint32_t from, Function&& function) {
    for (uint32_t colour = from; colour < colour_count_; ++colour) {
        const uint32_t first = first_block_[colour], count = first_block_[colour + 1] - first;
        workers.run(count, block_grain, [&](uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i) function(blocks_[first + i]);
        });
    }
}

template <class Function> void BodyContactSolver::each_group(const Workers& workers, Function&& function) {
    workers.run(group_count_, group_grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t g = begin; g < end; ++g) function(kind_of_[g], g * lanes);
    });
}

// Nonsmooth nonlinear conjugate gradients (Silcowitz-Hansen, Niebe and Erleben 2010): the changes of the impulses in a sweep serve
// as the gradient; 16 sweeps then do as much as 60. Bodies follow the search direction after a sweep, impulses in the next one. Sums
// go over blocks in order: the same on every machine.
void BodyContactSolver::sweep(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers,
                              bool rolls) {
    std::copy_n(twists_.data(), body_count_, twists_before_.data());
    std::fill_n(directions_.data(), body_count_, SolverTwist{});
    const SolverSearch search{twists_before_.data(), directions_.data()};
    double former = 0.0;
    float part = 0.0f;
    for (uint32_t n = 0; n < body_contact_sweeps; ++n) {
        std::atomic<bool> changed{false};
        const auto note = [&](bool change) {
            if (change) changed.store(true, std::memory_order_relaxed);
        };
        each_block(workers, 0, [&](PairBlock& block) { note(target.sweep(in, block, part)); });
        const bool last = n + 1 == body_contact_sweeps; // respects all bounds
        double squares = 0.0;
        if (!last && changed) {
            for (uint32_t b = 0; b < block_count_; ++b) {
                double sum = 0.0;
                for (uint32_t lane = 0; lane < blocks_[b].lanes; ++lane)
                    sum += static_cast<double>(blocks_[b].changed[lane]);
                squares += sum;
            }
            const bool onward = former > 0.0 && squares <= former; // else it restarts
            part = onward ? static_cast<float>(squares / former) : 0.0f;
            former = squares;
            each_group(workers, [&](uint32_t, uint32_t begin) { target.follow(in, search, begin, part); });
        }
        if (rolls && (n % roll_every == roll_every - 1))
            each_group(workers, [&](uint32_t kind, uint32_t begin) {
                if (!target.roll(in, kind, begin)) return;
                note(true);
                std::copy_n(in.twists + begin, lanes, search.before + begin);
            });
        if (last || !changed) break;
    }
    for (uint32_t n = 0; n < held_sweeps; ++n)
        each_block(workers, pair_colours_, [&](PairBlock& block) { target.sweep(in, block, 0.0f); });
}

// Restitution and friction together can add energy (Kane 1984): reduces the bounce of such contacts.
void BodyContactSolver::restrain(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers) {
    for (uint32_t round = 0; round < bounce_rounds; ++round) {
        std::atomic<bool> some{false};
        each_block(workers, 0, [&](PairBlock& block) {
            if (target.restrain(in, block)) some.store(true, std::memory_order_relaxed);
        });
        if (!some) return;
        for (uint32_t n = 0; n < bounce_sweeps; ++n)
            each_block(workers, 0, [&](PairBlock& block) { target.sweep(in, block, 0.0f); });
    }
}

bool BodyContactSolver::solve(const BodyContactTarget& target, float h, float gravity, const BodyContactScene& scene,
                              const Workers& workers) {
    if (!lay_out(scene)) return false;
    SolverBody& nobody = bodies_[body_count_];
    nobody = SolverBody{};
    nobody.q[3] = nobody.q0[3] = nobody.scale = 1.0f;
    twists_[body_count_] = SolverTwist{};
    bool rolls = false;
    for (uint32_t r = 0; r < scene.range_count; ++r) rolls = rolls || scene.kinds[scene.ranges[r].kind].rolling != 0.0f;
    const BodyContactInput in{h, gravity, scene.kinds, bodies_.data(), twists_.data()};
    workers.run(block_count_, block_grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t b = begin; b < end; ++b) fill(scene.kinds, b);
    });
    each_group(workers, [&](uint32_t kind, uint32_t begin) { target.begin(in, kind, begin); });
    each_block(workers, 0, [&](PairBlock& block) { target.way(in, block); });
    sweep(target, in, workers, rolls);
    each_group(workers, [&](uint32_t kind, uint32_t begin) { target.move(in, kind, begin); });
    each_block(workers, 0, [&](PairBlock& block) { target.touch(in, block); });
    each_block(workers, 0, [&](PairBlock& block) { target.velocity(in, block); });
    sweep(target, in, workers, rolls);
    restrain(target, in, workers);
    each_group(workers, [&](uint32_t kind, uint32_t begin) { target.finish(in, kind, begin); });
    return true;
}
} // namespace lr
