#include "contact/crowd_solver.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace lr {
namespace {

constexpr auto lanes = static_cast<uint32_t>(contact_lanes);
constexpr uint32_t usual_colours = 64; // by bits; what finds none goes into blocks of its own
constexpr uint32_t crowd_sweeps = 20, roll_every = 4;
constexpr uint32_t bounce_rounds = 2, bounce_sweeps = 3;
constexpr uint32_t held_sweeps = 4; // more over what is not moved: no heap may press anything into a collider
// Blocks and groups of bodies for which another thread is called: some microseconds of work.
constexpr uint32_t block_grain = 4, group_grain = 16;

void put(LaneRow* rows, uint32_t lane, Vector v) {
    rows[0][lane] = v.x;
    rows[1][lane] = v.y;
    rows[2][lane] = v.z;
}

} // namespace

bool CrowdSolver::reserve_bodies(uint32_t count) {
    if (!grow(*allocator_, bodies_, size_t{count} + 1) || !grow(*allocator_, twists_, size_t{count} + 1) ||
        !grow(*allocator_, used_colours_, count) || !grow(*allocator_, kind_of_, count / lanes + 1))
        return false;
    body_count_ = count;
    return true;
}

// Impulses are counted in the lighter body's mass unit: of a pair whose sizes differ by a thousand the other way round would
// overflow.
void CrowdSolver::order_pairs(const CrowdKind* kinds, CrowdUnit* units, uint32_t unit_count) {
    const auto mass = [&](uint32_t body) {
        const float s = bodies_[body].scale;
        return kinds[kind_of_[body / lanes]].body->unit_mass * s * s * s;
    };
    for (uint32_t i = 0; i < unit_count; ++i) {
        CrowdUnit& unit = units[i];
        unit.swapped = unit.b != CrowdUnit::nobody && mass(unit.b) < mass(unit.a);
        if (unit.swapped) std::swap(unit.a, unit.b);
    }
}

// Each pair takes the lowest colour that neither of its bodies has yet. What is not moved comes last in each sweep: it must hold
// better than bodies hold each other.
void CrowdSolver::colour(CrowdUnit* units, uint32_t unit_count) {
    std::fill_n(used_colours_.data(), body_count_, uint64_t{0});
    colour_count_ = 0;
    uint32_t late = usual_colours;
    for (uint32_t i = 0; i < unit_count; ++i) {
        CrowdUnit& unit = units[i];
        if (unit.b == CrowdUnit::nobody) continue;
        uint64_t &of_a = used_colours_[unit.a], &of_b = used_colours_[unit.b];
        const uint64_t used = of_a | of_b;
        unit.colour = used == ~uint64_t{0} ? late++ : static_cast<uint32_t>(std::countr_one(used));
        colour_count_ = std::max(colour_count_, unit.colour + 1);
        if (unit.colour >= usual_colours) continue;
        of_a |= uint64_t{1} << unit.colour;
        of_b |= uint64_t{1} << unit.colour;
    }
    pair_colours_ = colour_count_;
    uint32_t before = CrowdUnit::nobody, colour = 0;
    for (uint32_t i = 0; i < unit_count; ++i) {
        CrowdUnit& unit = units[i];
        if (unit.b != CrowdUnit::nobody) continue;
        colour = unit.a == before ? colour + 1 : pair_colours_;
        before = unit.a;
        unit.colour = colour;
        colour_count_ = std::max(colour_count_, colour + 1);
    }
}

// Blocks hold units of one colour and of the same kinds, those with about as many contacts together.
bool CrowdSolver::lay_out(const CrowdKind* kinds, const CrowdRange* ranges, uint32_t range_count, CrowdUnit* units,
                          uint32_t unit_count) {
    if (!grow(*allocator_, order_, unit_count) || !grow(*allocator_, spare_, unit_count)) return false;
    group_count_ = 0;
    uint32_t kind_count = 1;
    for (uint32_t r = 0; r < range_count; ++r) {
        const uint32_t groups = (ranges[r].count + lanes - 1) / lanes;
        for (uint32_t g = 0; g < groups; ++g) kind_of_[ranges[r].begin / lanes + g] = ranges[r].kind;
        group_count_ = std::max(group_count_, ranges[r].begin / lanes + groups);
        kind_count = std::max(kind_count, ranges[r].kind + 1);
    }
    order_pairs(kinds, units, unit_count);
    colour(units, unit_count);
    const auto kind_a = [&](const CrowdUnit& u) { return kind_of_[u.a / lanes]; };
    const auto kind_b = [&](const CrowdUnit& u) {
        return u.b == CrowdUnit::nobody ? kind_a(u) : kind_of_[u.b / lanes];
    };
    for (uint32_t i = 0; i < unit_count; ++i) order_[i] = units + i;
    // By the last criterion first: each pass keeps the order of the one before.
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
    if (!sort_by(block_contacts, [](const CrowdUnit& u) { return block_contacts - u.count; }) ||
        !sort_by(kind_count, kind_b) || !sort_by(kind_count, kind_a) ||
        !sort_by(colour_count_, [](const CrowdUnit& u) { return u.colour; }))
        return false;
    if (!grow(*allocator_, first_unit_, unit_count + 1) || !grow(*allocator_, first_block_, colour_count_ + 1))
        return false;
    block_count_ = 0;
    uint32_t colours = 0;
    for (uint32_t i = 0; i < unit_count;) {
        const CrowdUnit& first = *order_[i];
        while (colours <= first.colour) first_block_[colours++] = block_count_;
        first_unit_[block_count_] = i;
        for (uint32_t n = 0; n < lanes && i < unit_count; ++n, ++i) {
            const CrowdUnit& u = *order_[i];
            if (u.colour != first.colour || kind_a(u) != kind_a(first) || kind_b(u) != kind_b(first)) break;
        }
        ++block_count_;
    }
    while (colours <= colour_count_) first_block_[colours++] = block_count_;
    first_unit_[block_count_] = unit_count;
    if (!grow(*allocator_, blocks_, block_count_)) return false;
    unit_count_ = unit_count;
    for (uint32_t b = 0; b < block_count_; ++b)
        for (uint32_t i = first_unit_[b]; i < first_unit_[b + 1]; ++i) {
            CrowdUnit& unit = units[order_[i] - units];
            unit.block = b;
            unit.lane = i - first_unit_[b];
        }
    return true;
}

void CrowdSolver::fill(const CrowdKind* kinds, const CrowdUnit* const* units, PairBlock& block) const {
    const auto index = static_cast<size_t>(&block - blocks_.data());
    const uint32_t count = first_unit_[index + 1] - first_unit_[index];
    const CrowdUnit& first = *units[0];
    block.kind_a = kind_of_[first.a / lanes];
    block.kind_b = first.b == CrowdUnit::nobody ? block.kind_a : kind_of_[first.b / lanes];
    block.lanes = count;
    block.used = 0;
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        const CrowdUnit* const unit = lane < count ? units[lane] : nullptr;
        const bool pair = unit && unit->b != CrowdUnit::nobody;
        block.a[lane] = unit ? unit->a : body_count_;
        block.b[lane] = pair ? unit->b : body_count_;
        if (unit) block.used = std::max(block.used, unit->count);
        const auto mass = [&](uint32_t kind, uint32_t body) {
            const float s = bodies_[body].scale;
            return kinds[kind].body->unit_mass * s * s * s;
        };
        block.ratio[lane] = pair ? mass(block.kind_a, block.a[lane]) / mass(block.kind_b, block.b[lane]) : 0.0f;
    }
    for (uint32_t k = 0; k < block.used; ++k) {
        PairContacts& to = block.contact[k];
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const bool there = lane < count && k < units[lane]->count;
            const CrowdContact none{{}, {}, {0.0f, 1.0f, 0.0f}, no_contact, {}, {}, 0.0f, 0.0f, false};
            const CrowdContact& c = there ? units[lane]->contact[k] : none;
            const bool swapped = there && units[lane]->swapped;
            put(to.arm_a, lane, swapped ? c.arm_b : c.arm_a);
            put(to.arm_b, lane, swapped ? c.arm_a : c.arm_b);
            put(to.normal, lane, swapped ? -c.normal : c.normal);
            put(to.surface, lane, c.surface);
            put(to.lag, lane, c.lag);
            to.gap[lane] = c.gap;
            to.friction[lane] = c.friction;
            to.restitution[lane] = c.restitution;
            to.solid[lane] = c.solid ? 1.0f : 0.0f;
        }
    }
}

// Blocks of a colour side by side, colours one after the other.
template <class Function> void CrowdSolver::each_block(const Workers& workers, uint32_t from, Function&& function) {
    for (uint32_t colour = from; colour < colour_count_; ++colour) {
        const uint32_t first = first_block_[colour], count = first_block_[colour + 1] - first;
        workers.run(count, block_grain, [&](uint32_t begin, uint32_t end) {
            for (uint32_t i = begin; i < end; ++i) function(blocks_[first + i]);
        });
    }
}

template <class Function> void CrowdSolver::each_group(const Workers& workers, Function&& function) {
    workers.run(group_count_, group_grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t g = begin; g < end; ++g) function(kind_of_[g], g * lanes);
    });
}

// Nonsmooth nonlinear conjugate gradients (Silcowitz-Hansen, Niebe and Erleben 2010): a sweep's changes of the impulses are a
// gradient, and 16 sweeps do what 60 do without. Sums go over blocks in order: the same on every machine.
void CrowdSolver::sweep(const CrowdTarget& target, const CrowdInput& in, const Workers& workers, bool rolls) {
    double former = 0.0;
    for (uint32_t n = 0; n < crowd_sweeps; ++n) {
        std::atomic<bool> changed{false};
        const auto note = [&](bool change) {
            if (change) changed.store(true, std::memory_order_relaxed);
        };
        each_block(workers, 0, [&](PairBlock& block) { note(target.sweep(in, block)); });
        if (rolls && (n % roll_every == roll_every - 1))
            each_group(workers, [&](uint32_t kind, uint32_t begin) { note(target.roll(in, kind, begin)); });
        if (!changed) break;
        if (n + 1 == crowd_sweeps) break; // the last keeps to all bounds
        double squares = 0.0;
        for (uint32_t b = 0; b < block_count_; ++b) {
            double sum = 0.0;
            for (uint32_t lane = 0; lane < blocks_[b].lanes; ++lane)
                sum += static_cast<double>(blocks_[b].changed[lane]);
            squares += sum;
        }
        const bool onward = former > 0.0 && squares <= former; // else it begins anew
        const float part = onward ? static_cast<float>(squares / former) : 0.0f;
        former = squares;
        each_block(workers, 0, [&](PairBlock& block) { target.follow(in, block, part); });
    }
    for (uint32_t n = 0; n < held_sweeps; ++n)
        each_block(workers, pair_colours_, [&](PairBlock& block) { target.sweep(in, block); });
}

// Restitution and friction together can give energy (Kane 1984): those that would bounce less.
void CrowdSolver::restrain(const CrowdTarget& target, const CrowdInput& in, const Workers& workers) {
    for (uint32_t round = 0; round < bounce_rounds; ++round) {
        std::atomic<bool> some{false};
        each_block(workers, 0, [&](PairBlock& block) {
            if (target.restrain(in, block)) some.store(true, std::memory_order_relaxed);
        });
        if (!some) return;
        for (uint32_t n = 0; n < bounce_sweeps; ++n)
            each_block(workers, 0, [&](PairBlock& block) { target.sweep(in, block); });
    }
}

bool CrowdSolver::solve(const CrowdTarget& target, float h, float gravity, const CrowdKind* kinds,
                        const CrowdRange* ranges, uint32_t range_count, CrowdUnit* units, uint32_t unit_count,
                        const Workers& workers) {
    if (!lay_out(kinds, ranges, range_count, units, unit_count)) return false;
    CrowdBody& nobody = bodies_[body_count_];
    nobody = CrowdBody{};
    nobody.q[3] = nobody.q0[3] = nobody.scale = 1.0f;
    twists_[body_count_] = CrowdTwist{};
    bool rolls = false;
    for (uint32_t r = 0; r < range_count; ++r) rolls = rolls || kinds[ranges[r].kind].rolling != 0.0f;
    const CrowdInput in{h, gravity, kinds, bodies_.data(), twists_.data()};
    workers.run(block_count_, block_grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t b = begin; b < end; ++b) fill(kinds, order_.data() + first_unit_[b], blocks_[b]);
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
