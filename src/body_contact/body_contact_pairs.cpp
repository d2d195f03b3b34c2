// Finds the bodies that touch each other in a substep.
#include "body_contact/body_contact_step.h"

#include "body_contact/kept_manifold.h"
#include "collision/pair_contacts.h"
#include "kernel/divergence.h"
#include "world/world.h"

#include <algorithm>

namespace lr {
namespace {

constexpr uint32_t grain = 128; // bodies: some ten microseconds
// False when out of memory.
template <class... T> bool grow_all(Allocator& allocator, size_t count, Buffer<T>&... buffers) {
    return (grow(allocator, buffers, count) && ...);
}
} // namespace

float BodyContactStep::margin_of(const BodyContactBatch& member, uint32_t index) const {
    const BatchArrays& a = member.item.batch->arrays();
    return contact_margin(member.run.step.shape->reach * a.field[field_scale][index], pose_of(a, index).position,
                          member.run.step.gravity, static_cast<float>(time_.h));
}

void BodyContactStep::set_box(const BodyContactBatch& member, uint32_t index) {
    const Batch& batch = *member.item.batch;
    const uint32_t body = member.first + index;
    const float scale = batch.arrays().field[field_scale][index], margin = margin_of(member, index);
    const Pose began_at = began(body), now = pose_of(batch.arrays(), index);
    buffers_->moved[body] = {pair_body(batch.pair_hull(), scale, began_at, now), margin,
                             static_cast<uint32_t>(&member - buffers_->members.data()),
                             pair_key(member.slot, batch.arrays().noise_seed[index])};
    const Box way = around(bounds(batch.pair_hull(), scale, began_at), bounds(batch.pair_hull(), scale, now));
    buffers_->grid.boxes()[body] = {grown(way, margin), 0, 0};
    const PairBody& moved = buffers_->moved[body].body;
    buffers_->placed[body] = placed_box(moved, margin + kept_way(moved, moved));
}

// Whether `one` has found a pair of its own. A pair that both find belongs to the first by batch and noise seed, or by position if noise
// seeds are equal.
bool BodyContactStep::finds(uint32_t one, uint32_t other, bool mutual) const {
    if (one == other) return false;
    const BodyContactBatch* const members = buffers_->members.data();
    const auto member = [&](uint32_t body) { return member_count_ == 1 ? 0 : buffers_->moved[body].member; };
    const BodyContactBatch &a = members[member(one)], &b = members[member(other)];
    if (&a == &b ? !a.own : !world_->pairs.has(a.slot, b.slot)) return false;
    if (!mutual) return true;
    if (&a != &b) return a.slot < b.slot;
    const BatchArrays& arrays = a.item.batch->arrays();
    const uint32_t i = one - a.first, j = other - b.first;
    if (arrays.noise_seed[i] != arrays.noise_seed[j]) return arrays.noise_seed[i] < arrays.noise_seed[j];
    for (size_t f = field_x; f <= field_z; ++f)
        if (arrays.field[f][i] != arrays.field[f][j]) return arrays.field[f][i] < arrays.field[f][j];
    return i < j;
}

// Replaces the last entry of a full list if it comes earlier by batch and noise seed.
void BodyContactStep::keep_first(uint32_t* seen, uint32_t body) const {
    const auto order = [&](uint32_t of) {
        const BodyContactBatch& member = member_of(of);
        return uint64_t{member.slot} << 32 | member.item.batch->arrays().noise_seed[of - member.first];
    };
    uint32_t* last = seen;
    for (uint32_t k = 1; k < BodyContactBuffers::most_seen; ++k)
        if (order(seen[k]) > order(*last)) last = seen + k;
    if (order(body) < order(*last)) *last = body;
}

// Finds the contacts of the pairs that bodies [begin, end), in grid order, have found. They are searched as the substep begins: bodies
// that pass through each other are recognised by the side on which they began. Pairs that stay open are dropped.
void BodyContactStep::meet(uint32_t begin, uint32_t end) {
    BodyContactBuffers& c = *buffers_;
    PairBatch batch(world_->target->search_pairs);
    const auto within = [&](const BodyContactBuffers::Moved& one, const BodyContactBuffers::Moved& other) {
        return near_enough(one.body, other.body, std::min(one.margin, other.margin));
    };
    const auto found = [&](uint32_t at, const WayContact* contacts, uint32_t count, const Manifold& manifold) {
        BodyContactBuffers::Pair& pair = c.pairs[at];
        const BodyContactBuffers::Moved &one = c.moved[pair.a], &other = c.moved[pair.b];
        pair.count = count;
        enter_manifold(at, manifold, within(one, other) + kept_way(one.body, other.body));
        enter_contacts(at, contacts);
    };
    const auto kept = [&](uint32_t at) {
        BodyContactBuffers::Pair& pair = c.pairs[at];
        const CachedPair* const cached = c.cached[at];
        if (!cached) return false;
        const BodyContactBuffers::Moved &one = c.moved[pair.a], &other = c.moved[pair.b];
        const bool in_order = one.key < other.key;
        const PairBody &a = in_order ? one.body : other.body, &b = in_order ? other.body : one.body;
        Manifold manifold;
        if (!kept_manifold(*cached, a, b, within(one, other), manifold)) return false;
        if (!in_order) manifold = other_way_round(manifold);
        WayContact contacts[most_pair_contacts];
        pair.count = keep_way_contacts(one.body, other.body, std::min(one.margin, other.margin), manifold, contacts);
        c.found[at] = *cached;
        enter_contacts(at, contacts);
        return true;
    };
    const auto each_seen = [&c](uint32_t body, const auto& function) {
        const uint32_t first = c.first_pair[body], count = c.first_pair[body + 1] - first;
        const uint32_t* const seen = c.seen.data() + size_t{BodyContactBuffers::most_seen} * body;
        for (uint32_t k = 0; k < count; ++k) function(first + k, seen[k]);
    };
    // Neighbours in space, and cached pairs, are far apart in memory: fetched two bodies and one body ahead.
    const auto fetch = [&](uint32_t body) {
        __builtin_prefetch(c.moved.data() + body);
        each_seen(body, [&](uint32_t, uint32_t other) {
            __builtin_prefetch(c.moved.data() + other);
            __builtin_prefetch(&c.moved[other].margin);
        });
    };
    const auto list = [&](uint32_t body) {
        each_seen(body, [&](uint32_t at, uint32_t other) {
            const uint64_t key_a = c.moved[body].key, key_b = c.moved[other].key;
            c.pairs[at] = {body, other, 0};
            c.cached[at] = world_->pair_cache.find(std::min(key_a, key_b), std::max(key_a, key_b));
        });
    };
    if (begin < end) list(c.grid.placed(begin));
    for (uint32_t i = begin; i < end; ++i) {
        const uint32_t body = c.grid.placed(i), first = c.first_pair[body], past = c.first_pair[body + 1];
        const BodyContactBuffers::Moved& one = c.moved[body];
        if (i + 2 < end) fetch(c.grid.placed(i + 2));
        if (i + 1 < end) list(c.grid.placed(i + 1));
        for (uint32_t at = first; at < past; ++at) {
            const BodyContactBuffers::Moved& other = c.moved[c.pairs[at].b];
            if (kept(at)) continue;
            batch.find(one.body, other.body, std::min(one.margin, other.margin), kept_way(one.body, other.body), at,
                       found);
        }
    }
    batch.finish(found);
}

bool BodyContactStep::find_pairs(uint32_t substep) {
    BodyContactBuffers& c = *buffers_;
    Allocator& allocator = world_->allocator;
    if (!c.grid.reserve(allocator, body_count_) || !grow_all(allocator, body_count_, c.moved, c.placed, c.hidden) ||
        !grow(allocator, c.first_pair, size_t{body_count_} + 1) ||
        !grow(allocator, c.seen, size_t{BodyContactBuffers::most_seen} * body_count_))
        return false;
    workers_.run(body_count_, grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t body = begin; body < end; ++body) {
            const BodyContactBatch& member = member_of(body);
            const uint32_t index = body - member.first;
            if (index < member.count && !is_held(member.item.batch->arrays().field[field_age_remainder][index])) {
                set_box(member, index);
                ask_for_shelter(member, index, substep);
            } else {
                // Padding and held bodies touch nothing.
                c.grid.boxes()[body] = {{{1.0f, 1.0f, 1.0f}, {-1.0f, -1.0f, -1.0f}}, 0, 0};
                c.hidden[body] = BodyContactBuffers::unasked;
            }
        }
    });
    c.grid.build(body_count_);
    std::fill_n(c.first_pair.data(), body_count_, 0u);
    workers_.run(c.grid.placed(), grain, [&](uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t body = c.grid.placed(i);
            // In a heap upright boxes of dozens of bodies overlap. Only those that can touch are counted.
            uint32_t count = 0, met_count = 0, met[BodyContactBuffers::most_seen];
            uint32_t* const seen = c.seen.data() + size_t{BodyContactBuffers::most_seen} * body;
            const auto take_near = [&] {
                for (uint32_t k = 0; k < met_count; ++k) hide_each_other(body, met[k]);
                met_count = world_->target->near_boxes(c.placed.data(), body, met, met_count);
                for (uint32_t k = 0; k < met_count; ++k)
                    if (count < BodyContactBuffers::most_seen)
                        seen[count++] = met[k];
                    else
                        keep_first(seen, met[k]);
                met_count = 0;
            };
            c.grid.visit(c.grid.box(body), [&](uint32_t other, bool mutual) {
                if (!finds(body, other, mutual)) return;
                met[met_count] = other;
                if (++met_count == BodyContactBuffers::most_seen) take_near();
            });
            take_near();
            c.first_pair[body] = count;
        }
    });
    uint32_t sum = 0;
    for (uint32_t body = 0; body < body_count_; ++body) {
        const uint32_t count = c.first_pair[body];
        c.first_pair[body] = sum;
        sum += count;
    }
    c.first_pair[body_count_] = sum;
    if (!grow_all(allocator, sum, c.pairs, c.cached, c.pair_contacts) || !begin_pairs(sum)) return false;
    workers_.run(c.grid.placed(), grain, [&](uint32_t begin, uint32_t end) { meet(begin, end); });
    return true;
}

// Bodies that touch others get places, which are indices in the solver's arrays: kind by kind, each starting at a whole group of lanes,
// and within a kind in the order of tiles and noise seeds.
bool BodyContactStep::number_touching() {
    constexpr auto lanes = static_cast<uint32_t>(contact_lanes);
    BodyContactBuffers& c = *buffers_;
    Allocator& allocator = world_->allocator;
    if (!grow(allocator, c.place, body_count_) || !grow(allocator, c.tiled, body_count_)) return false;
    std::fill_n(c.place.data(), body_count_, none);
    const uint32_t pair_count = c.first_pair[body_count_];
    for (uint32_t i = 0; i < pair_count; ++i)
        if (c.pairs[i].count != 0) c.place[c.pairs[i].a] = c.place[c.pairs[i].b] = 0;
    uint32_t places = 0, count = 0;
    for (uint32_t kind = 0; kind < 2 * member_count_; ++kind) {
        BodyContactBatch& member = c.members[kind / 2];
        places = (places + lanes - 1) / lanes * lanes;
        member.first_place[kind % 2] = places;
        const BatchArrays& arrays = member.item.batch->arrays();
        for (uint32_t i = 0; i < member.count; ++i) {
            if (c.place[member.first + i] != 0 || wet(member, member.first + i) != (kind % 2 != 0)) continue;
            const Vector x = pose_of(arrays, i).position;
            c.tiled[count++] = {{x.x, x.y, x.z}, kind, arrays.noise_seed[i], member.first + i, 0};
            ++places;
        }
    }
    const uint32_t padded = (places + lanes - 1) / lanes * lanes;
    if (padded == 0) return true;
    if (!grow_all(allocator, padded, c.body_at, c.tile, c.first_held, c.held_count, c.first_unit, c.deepest) ||
        !grow_all(allocator, size_t{contact_slots} * padded, c.held, c.held_frames, c.held_contacts) ||
        !c.solver.reserve_bodies(padded)) {
        std::fill_n(c.place.data(), body_count_, none);
        return false;
    }
    std::fill_n(c.body_at.data(), padded, none);
    std::fill_n(c.tile.data(), padded, 0u);
    tile_levels_ = tile_levels(count);
    cut_into_tiles(c.tiled.data(), count, tile_levels_);
    for (uint32_t i = 0, place = 0; i < count; ++i, ++place) {
        const TiledBody& one = c.tiled[i];
        if (i == 0 || one.member != c.tiled[i - 1].member)
            place = c.members[one.member / 2].first_place[one.member % 2];
        c.place[one.body] = place;
        c.body_at[place] = one.body;
        c.tile[place] = one.tile;
    }
    place_count_ = padded;
    held_used_ = 0;
    return true;
}
} // namespace lr
