#include "body_contact/body_contact_solver.h"

#include "base/disjoint_sets.h"
#include "base/pose.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

namespace lr {
namespace {

constexpr auto lanes = static_cast<uint32_t>(contact_lanes);
constexpr uint32_t path_sweeps = 7, velocity_sweeps = 18, roll_every = 4; // path_sweeps: in each short step
constexpr uint32_t bounce_rounds = 2, bounce_sweeps = 3;
constexpr uint32_t held_sweeps = 4; // extra sweeps over fixed things: a heap must not press a body into a collider
constexpr uint32_t lanes_grain = 4;

// Groups of units. Each tile has two: its pairs, then its contacts with fixed things, which must hold better and so come last. The groups
// of pairs across cuts follow, level after level. A task sweeps both groups of a tile, or the group across one cut.
constexpr uint32_t first_task(uint32_t levels, uint32_t level) {
    return (2u << levels) - (2u << levels >> level);
}
} // namespace

bool BodyContactSolver::reserve_bodies(uint32_t count) {
    if (!grow(*allocator_, bodies_, size_t{count} + 1) || !grow(*allocator_, twists_, size_t{count} + 1) ||
        !grow(*allocator_, twists_before_, count) || !grow(*allocator_, directions_, count) ||
        !grow(*allocator_, holding_, count) || !grow(*allocator_, steps_, count) || !grow(*allocator_, heaps_, count) ||
        !grow(*allocator_, kind_of_, count / lanes + 1))
        return false;
    body_count_ = count;
    return true;
}

float BodyContactSolver::mass(const SolverBodyKind* kinds, uint32_t body) const {
    const float s = bodies_[body].scale;
    return kinds[kind_of(body)].body->unit_mass * s * s * s;
}

uint32_t BodyContactSolver::group_of(const BodyContactScene& scene, const BodyContactPair& unit) const {
    const uint32_t a = scene.tile[unit.a];
    if (unit.b == BodyContactPair::nobody) return 2 * a + 1;
    const auto level = static_cast<uint32_t>(std::bit_width(a ^ scene.tile[unit.b]));
    return level == 0 ? 2 * a : (1u << tile_levels_) + first_task(tile_levels_, level) + (a >> level);
}

// By group, kinds and number of contacts.
bool BodyContactSolver::sort_units(const BodyContactScene& scene) {
    BodyContactPair* const units = scene.units;
    const uint32_t unit_count = scene.unit_count;
    if (!grow(*allocator_, order_, unit_count) || !grow(*allocator_, spare_, unit_count)) return false;
    uint32_t kind_count = 1;
    for (const BodyContactRange& range : std::span(scene.ranges, scene.range_count))
        kind_count = std::max(kind_count, range.kind + 1);
    for (uint32_t i = 0; i < unit_count; ++i) {
        BodyContactPair& unit = units[i];
        // Impulses are in the mass unit of a, the lighter body: in the heavier one's they would overflow if sizes differ by a thousand.
        unit.swapped = unit.b != BodyContactPair::nobody && mass(scene.kinds, unit.b) < mass(scene.kinds, unit.a);
        if (unit.swapped) std::swap(unit.a, unit.b);
        unit.group = group_of(scene, unit);
        order_[i] = &unit;
    }
    // Sorts by the last criterion first: each pass is stable.
    const auto sort_by = [&](uint32_t values, auto&& value) {
        if (!grow(*allocator_, first_unit_, values + 1)) return false;
        if (values == 1) return true;
        std::fill_n(first_unit_.data(), values + 1, 0u);
        for (uint32_t i = 0; i < unit_count; ++i) ++first_unit_[value(*order_[i]) + 1];
        for (uint32_t v = 0; v < values; ++v) first_unit_[v + 1] += first_unit_[v];
        for (uint32_t i = 0; i < unit_count; ++i) spare_[first_unit_[value(*order_[i])]++] = order_[i];
        order_.swap(spare_);
        return true;
    };
    return sort_by(block_contacts, [](const BodyContactPair& u) { return block_contacts - u.count; }) &&
           sort_by(kind_count, [&](const BodyContactPair& u) { return kind_b(u); }) &&
           sort_by(kind_count, [&](const BodyContactPair& u) { return kind_of(u.a); }) &&
           sort_by(group_count_, [](const BodyContactPair& u) { return u.group; });
}

// Each unit goes into the first block of its group and kinds that holds neither of its bodies. After the last sort first_unit_ holds the
// end of each group.
void BodyContactSolver::fill_blocks(const BodyContactScene& scene) {
    constexpr uint32_t window_blocks = 64;
    std::fill_n(holding_.data(), body_count_, Holding{});
    uint32_t window = 0, used[window_blocks], opened = 0, at = 0;
    uint64_t full = 0;
    block_count_ = 0;
    const auto open_window = [&] {
        ++window;
        block_count_ += opened;
        opened = 0;
        full = 0;
    };
    const auto held_by = [&](uint32_t body) -> uint64_t& {
        Holding& holding = holding_[body];
        if (holding.window != window) holding = {window, 0};
        return holding.blocks;
    };
    uint64_t none = 0;
    for (uint32_t group = 0; group < group_count_; ++group) {
        open_window();
        first_block_[group] = block_count_;
        for (const uint32_t past = first_unit_[group], first = at; at < past; ++at) {
            BodyContactPair& unit = scene.units[order_[at] - scene.units];
            const bool pair = unit.b != BodyContactPair::nobody;
            if (at != first &&
                (kind_of(unit.a) != kind_of(order_[at - 1]->a) || kind_b(unit) != kind_b(*order_[at - 1])))
                open_window();
            if ((held_by(unit.a) | (pair ? held_by(unit.b) : none) | full) == ~uint64_t{0}) open_window();
            uint64_t &of_a = held_by(unit.a), &of_b = pair ? held_by(unit.b) : none;
            const auto block = static_cast<uint32_t>(std::countr_one(of_a | of_b | full));
            if (block == opened) used[opened++] = 0;
            const uint64_t bit = uint64_t{1} << block;
            of_a |= bit;
            if (pair) of_b |= bit;
            unit.block = block_count_ + block;
            unit.lane = used[block]++;
            if (used[block] == lanes) full |= bit;
        }
    }
    open_window();
    first_block_[group_count_] = block_count_;
}

// The bodies of each tile, as runs of neighbours.
bool BodyContactSolver::list_tiles(const BodyContactScene& scene) {
    const uint32_t tiles = 1u << tile_levels_;
    if (!grow(*allocator_, first_run_, size_t{tiles} + 2)) return false;
    std::fill_n(first_run_.data(), tiles + 2, 0u);
    uint32_t count = 0;
    const auto each_run = [&](const auto& function) {
        for (uint32_t begin = 0, end; begin < body_count_; begin = end) {
            for (end = begin + 1; end < body_count_ && scene.tile[end] == scene.tile[begin];) ++end;
            function(scene.tile[begin], Run{begin, end});
        }
    };
    each_run([&](uint32_t tile, Run) { ++count, ++first_run_[tile + 2]; });
    if (!grow(*allocator_, runs_, count)) return false;
    for (uint32_t tile = 0; tile < tiles; ++tile) first_run_[tile + 2] += first_run_[tile + 1];
    each_run([&](uint32_t tile, Run run) { runs_[first_run_[tile + 1]++] = run; });
    return true;
}

bool BodyContactSolver::lay_out(const BodyContactScene& scene) {
    tile_levels_ = scene.tile_levels;
    const uint32_t tiles = 1u << tile_levels_;
    task_count_ = first_task(tile_levels_, tile_levels_ + 1);
    group_count_ = tiles + task_count_;
    lanes_count_ = 0;
    for (const BodyContactRange& range : std::span(scene.ranges, scene.range_count)) {
        const uint32_t first = range.begin / lanes, count = (range.count + lanes - 1) / lanes;
        std::fill_n(kind_of_.data() + first, count, range.kind);
        lanes_count_ = std::max(lanes_count_, first + count);
    }
    if (!grow(*allocator_, first_block_, size_t{group_count_} + 1) || !grow(*allocator_, swept_, task_count_) ||
        !list_tiles(scene) || !sort_units(scene))
        return false;
    fill_blocks(scene);
    if (!grow(*allocator_, blocks_, block_count_) || !grow(*allocator_, unit_of_, size_t{lanes} * block_count_))
        return false;
    std::fill_n(unit_of_.data(), size_t{lanes} * block_count_, nullptr);
    for (const BodyContactPair& unit : std::span(scene.units, scene.unit_count))
        unit_of_[size_t{lanes} * unit.block + unit.lane] = &unit;
    return true;
}

void BodyContactSolver::fill(const SolverBodyKind* kinds, uint32_t index) {
    PairBlock& block = blocks_[index];
    const BodyContactPair* const* const units = unit_of_.data() + size_t{lanes} * index;
    uint32_t count = 0;
    while (count < lanes && units[count]) ++count;
    block.kind_a = kind_of(units[0]->a);
    block.kind_b = kind_b(*units[0]);
    block.lanes = count;
    block.used = 0;
    const BodyContactFrame nowhere{{0.0f, 1.0f, 0.0f}, {}, {}, 0.0f, 0.0f, false};
    const BodyContactPoint none{{}, {}, no_contact};
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        const BodyContactPair* const unit = lane < count ? units[lane] : nullptr;
        const bool pair = unit && unit->b != BodyContactPair::nobody, swapped = unit && unit->swapped;
        const BodyContactFrame& frame = unit ? *unit->frame : nowhere;
        block.a[lane] = unit ? unit->a : body_count_;
        block.b[lane] = pair ? unit->b : body_count_;
        if (unit) block.used = std::max(block.used, unit->count);
        block.ratio[lane] = pair ? mass(kinds, unit->a) / mass(kinds, unit->b) : 0.0f;
        put_in(block.normal, 0, lane, swapped ? -frame.normal : frame.normal);
        put_in(block.surface, 0, lane, frame.surface);
        put_in(block.lag, 0, lane, frame.lag);
        put_in(block.start_drag, 0, lane, swapped ? -frame.guess.drag : frame.guess.drag);
        block.start_spin[lane] = frame.guess.spin;
        block.friction.most[lane] = frame.friction;
        block.restitution[lane] = frame.restitution;
        block.solid[lane] = frame.solid ? 1.0f : 0.0f;
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

std::span<PairBlock> BodyContactSolver::blocks_of(uint32_t task) {
    const uint32_t tiles = 1u << tile_levels_;
    const uint32_t first = task < tiles ? 2 * task : tiles + task, past = task < tiles ? first + 2 : first + 1;
    return {blocks_.data() + first_block_[first], blocks_.data() + first_block_[past]};
}

// Calls function(task) for the tasks of each level, which share no body, in parallel; levels one after the other.
template <class Function> void BodyContactSolver::each_task(const Workers& workers, const Function& function) {
    for (uint32_t level = 0; level <= tile_levels_; ++level) {
        const uint32_t first = first_task(tile_levels_, level), past = first_task(tile_levels_, level + 1);
        workers.run(past - first, 1, [&](uint32_t at, uint32_t) { function(first + at); });
    }
}

template <class Function> void BodyContactSolver::each_block(const Workers& workers, const Function& function) {
    each_task(workers, [&](uint32_t task) {
        for (PairBlock& block : blocks_of(task)) function(block);
    });
}

template <class Function> void BodyContactSolver::each_lanes(const Workers& workers, const Function& function) {
    workers.run(lanes_count_, lanes_grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) function(kind_of_[i], i * lanes);
    });
}

// Nonsmooth nonlinear conjugate gradients (Silcowitz-Hansen, Niebe and Erleben 2010): the changes of the impulses in a sweep serve
// as the gradient; 16 sweeps then do as much as 60. Bodies take the step along the search direction before the next sweep, impulses
// during it. Sums run over tasks in order, so they are the same on every machine.
void BodyContactSolver::sweep(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers,
                              bool rolls, uint32_t most) {
    std::copy_n(twists_.data(), body_count_, twists_before_.data());
    std::fill_n(directions_.data(), body_count_, SolverTwist{});
    const SolverSearch search{twists_before_.data(), directions_.data()};
    const uint32_t tiles = 1u << tile_levels_;
    const auto follow = [&](uint32_t tile, float part) {
        for (uint32_t i = first_run_[tile]; i < first_run_[tile + 1]; ++i)
            target.follow(in, search, runs_[i].begin, runs_[i].end, part);
    };
    double former = 0.0;
    float part = 0.0f;
    bool follows = false;
    for (uint32_t n = 0; n < most; ++n) {
        each_task(workers, [&](uint32_t task) {
            if (follows && task < tiles) follow(task, part);
            Swept swept{0.0, false};
            for (PairBlock& block : blocks_of(task)) {
                if (!target.sweep(in, block, part)) continue;
                swept.changed = true;
                for (uint32_t lane = 0; lane < block.lanes; ++lane)
                    swept.squares += static_cast<double>(block.changed[lane]);
            }
            swept_[task] = swept;
        });
        std::atomic<bool> changed{false};
        double squares = 0.0;
        for (const Swept& swept : std::span(swept_.data(), task_count_)) {
            if (swept.changed) changed = true;
            squares += swept.squares;
        }
        const bool last = n + 1 == most; // no step follows it, so that all bounds hold
        follows = !last && changed;
        if (follows) {
            const bool onward = former > 0.0 && squares <= former; // else it restarts
            part = onward ? static_cast<float>(squares / former) : 0.0f;
            former = squares;
        }
        if (rolls && (n % roll_every == roll_every - 1)) {
            if (follows) workers.run(tiles, 1, [&](uint32_t tile, uint32_t) { follow(tile, part); });
            follows = false;
            each_lanes(workers, [&](uint32_t kind, uint32_t begin) {
                if (!target.roll(in, kind, begin)) return;
                changed.store(true, std::memory_order_relaxed);
                std::copy_n(in.twists + begin, lanes, search.before + begin);
            });
        }
        if (last || !changed) break;
    }
}

void BodyContactSolver::hold(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers) {
    workers.run(1u << tile_levels_, 1, [&](uint32_t tile, uint32_t) {
        for (uint32_t n = 0; n < held_sweeps; ++n)
            for (uint32_t b = first_block_[2 * tile + 1]; b < first_block_[2 * tile + 2]; ++b)
                target.sweep(in, blocks_[b], 0.0f);
    });
}

// The velocity projection starts from the path's impulses p times a factor f, the one that leaves the least energy: p . J (v + f M^-1 J^T p) = 0.
// All bodies of a heap, which touch each other if only through others, share one factor. A heap is full of large impulses that hold each
// other. With a factor for each pair they no longer do, and the start has up to a hundred times the energy of the heap.
void BodyContactSolver::start_velocities(const BodyContactScene& scene, float h) {
    constexpr double most = 2.0 * short_steps; // half of it for bodies at rest
    for (uint32_t i = 0; i < body_count_; ++i) heaps_[i] = {i, 0.0, 0.0};
    const auto parent = [&](uint32_t body) -> uint32_t& { return heaps_[body].parent; };
    const std::span<const BodyContactPair> units(scene.units, scene.unit_count);
    for (const BodyContactPair& unit : units)
        if (unit.b != BodyContactPair::nobody) join_sets(parent, unit.a, unit.b);
    for (uint32_t i = 0; i < body_count_; ++i)
        heaps_[i].parent = heaps_[heaps_[i].parent].parent; // now every parent is the first body of its heap
    const auto sums_of = [&](const BodyContactPair& unit) -> Heap& { return heaps_[heaps_[unit.a].parent]; };
    for (const BodyContactPair& unit : units) {
        const PairBlock& block = blocks_[unit.block];
        const auto unit_mass = static_cast<double>(mass(scene.kinds, unit.a));
        Heap& sums = sums_of(unit);
        sums.stopping += unit_mass * static_cast<double>(block.start[unit.lane]);
        sums.moving += unit_mass * static_cast<double>(block.moving[unit.lane]);
    }
    const double limit = most / static_cast<double>(h);
    for (const BodyContactPair& unit : units) {
        const Heap& sums = sums_of(unit);
        const double best = sums.stopping / sums.moving;
        blocks_[unit.block].start[unit.lane] =
            best > 0.0 ? static_cast<float>(std::min(best, limit)) : 0.0f; // also of NaN
    }
}

// Restitution and friction together can add energy (Kane 1984): reduces the bounce of such contacts.
void BodyContactSolver::restrain(const BodyContactTarget& target, const BodyContactInput& in, const Workers& workers) {
    for (uint32_t round = 0; round < bounce_rounds; ++round) {
        std::atomic<bool> some{false};
        each_block(workers, [&](PairBlock& block) {
            if (target.restrain(in, block)) some.store(true, std::memory_order_relaxed);
        });
        if (!some) return;
        for (uint32_t n = 0; n < bounce_sweeps; ++n)
            each_block(workers, [&](PairBlock& block) { target.sweep(in, block, 0.0f); });
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
    const BodyContactInput in{h, gravity, scene.kinds, bodies_.data(), twists_.data(), steps_.data()};
    each_block(workers,
               [&](const PairBlock& block) { fill(scene.kinds, static_cast<uint32_t>(&block - blocks_.data())); });
    each_lanes(workers, [&](uint32_t kind, uint32_t begin) { target.begin(in, kind, begin); });
    each_block(workers, [&](PairBlock& block) { target.way(in, block); });
    for (uint32_t n = 1; n <= short_steps; ++n) {
        each_lanes(workers, [&](uint32_t kind, uint32_t begin) { target.short_step(in, kind, begin, n == 1); });
        sweep(target, in, workers, rolls, path_sweeps);
        if (n == short_steps) hold(target, in, workers);
        each_block(workers, [&](PairBlock& block) { target.end_short_step(in, block, n); });
    }
    each_lanes(workers, [&](uint32_t kind, uint32_t begin) { target.move(in, kind, begin); });
    each_block(workers, [&](PairBlock& block) { target.touch(in, block); });
    start_velocities(scene, h);
    each_block(workers, [&](PairBlock& block) { target.velocity(in, block); });
    sweep(target, in, workers, rolls, velocity_sweeps);
    hold(target, in, workers);
    restrain(target, in, workers);
    each_lanes(workers, [&](uint32_t kind, uint32_t begin) { target.finish(in, kind, begin); });
    return true;
}
} // namespace lr
