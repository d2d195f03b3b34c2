// Continuous collision: stops bodies that would pass through something within a substep. docs/maintainers/contact.md, section 3.
#include "collision/collider_contact_group.h"

#include "collision/convex_separation.h"
#include "collision/ray_cast.h"
#include "collision/triangle_contact.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace lr {
namespace {

// Limits per body and substep; after the last stop the body stays there.
constexpr uint32_t most_stops = 12, most_met = 32;
constexpr float same_side = 0.9999f; // cosine: parts of one surface
constexpr float shallow = 0.1f;      // share of the reach: contacts undo shallower overlap

// Least n . x of any point of a body.
float lowest(const BodyShape& s, float scale, const Pose& pose, Vector n) {
    const Vector d = rotate(inverse(pose.rotation), n);
    float least = 0.0f;
    if (s.count == 0) {
        const Vector stretched{s.semi_axes.x * d.x, s.semi_axes.y * d.y, s.semi_axes.z * d.z};
        least = dot(d, s.center) - length(stretched);
    } else {
        least = dot(d, s.point(farthest_point(s.x, s.y, s.z, s.count, -d))) - s.radius;
    }
    return dot(n, pose.position) + scale * least;
}

// Triangles that the swept test skips: those already met, and those behind planes that the body stays in front of.
struct PassedTriangles {
    const Candidate* met;
    uint32_t met_count, slot, side_count;
    float little;               // m
    FlatSide sides[most_stops]; // that it stays in front of, in the mesh's frame

    static bool skips(const void* passed, const Triangle& t, uint32_t index) {
        const auto& p = *static_cast<const PassedTriangles*>(passed);
        const auto is_it = [&](const Candidate& m) { return m.slot == p.slot && m.part.first == index; };
        if (std::any_of(p.met, p.met + p.met_count, is_it)) return true;
        return std::any_of(p.sides, p.sides + p.side_count, [&](const FlatSide& side) {
            return std::all_of(t.corners, t.corners + 3,
                               [&](Vector corner) { return dot(side.normal, corner) <= side.offset + p.little; });
        });
    }
};

// A thing that stops a body, with the contacts there.
struct Stop {
    Candidate candidate;
    Rotation turn; // from the collider's axes to the body's
    uint32_t count;
    Contact contacts[most_contacts];
};

// A body's nearest point to a thing; `part` is the triangle of a mesh. If they overlap, the gap is 0, and the normal that of the body shrunk about its
// centre of mass, which the swept test keeps in front.
Contact nearest_contact(const BodyShape& s, float scale, const Pose& at, const Geometry& g, ColliderPart part) {
    Contact least{{}, {0.0f, 1.0f, 0.0f}, std::numeric_limits<float>::infinity()};
    const PlacedBody cores[] = {
        {s, scale, at, core_sizes[0]}, {s, scale, at, core_sizes[1]}, {s, scale, at, core_sizes[2]}};
    const PlacedBody& body = cores[0];
    const auto take = [&](const PlacedCollider& other) {
        for (size_t k = 0; k < std::size(core_sizes); ++k) {
            const Nearest nearest = nearest_points(cores[k], other, std::numeric_limits<double>::infinity());
            if (nearest.overlap) continue;
            const float gap =
                static_cast<float>(nearest.lower - other.radius) - body.radius - (1.0f - core_sizes[k]) * body.reach;
            const Vector n = to_float(nearest.normal),
                         point = to_float(body.support(-nearest.normal)) - body.radius * n;
            if (gap < least.gap) least = {rotate(inverse(at.rotation), point), n, gap};
            return;
        }
    };
    if (g.mesh) {
        take(PlacedCollider(mesh_triangle(*g.mesh, part.first).corners, at.position));
    } else if (g.heightfield) {
        const Cells cells = cells_between(*g.heightfield, grown({at.position, at.position}, body.reach + body.radius));
        for (uint32_t k = cells.first[1]; k < cells.last[1]; ++k)
            for (uint32_t i = cells.first[0]; i < cells.last[0]; ++i)
                for (const bool second : {false, true})
                    take(PlacedCollider(field_triangle(*g.heightfield, i, k, second).corners, at.position));
    } else {
        take(PlacedCollider(g, at.position));
    }
    // Of a centre of mass on a triangle nothing is known.
    least.gap = least.gap < 1e30f ? std::max(least.gap, 0.0f) : 0.0f;
    return least;
}

// A plane that separates two convex things at the moment of touch. As long as the whole body stays on its side, it may slide along it and cannot pass
// through. `met` is in the collider's frame. began, face: for meshes, as in ContactPoints.
void find_side(const BodyShape& s, float scale, const Pose& met, const Geometry& g, ColliderPart part, float margin,
               const Pose& began, Vector face, Stop& stop, FlatSide& side) {
    const float near = 0.2f * s.reach * scale;
    Contact* end = stop.contacts;
    if (g.kind == ColliderKind::mesh) {
        ContactPoints contacts(s, scale, met, near, &began);
        contacts.face = face;
        add_mesh(contacts, *g.mesh, part, true); // as if it had no neighbours: only this triangle was met
        end += contacts.keep(stop.contacts);
    } else {
        end += find_contacts(s, scale, met, g, near, stop.contacts);
    }
    stop.count = 0;
    // It met the edge of a triangle whose neighbours hold it, or the search gave up before they touched.
    if (end == stop.contacts) *end++ = nearest_contact(s, scale, met, g, part);
    const Contact nearest =
        *std::min_element(stop.contacts, end, [](const Contact& a, const Contact& b) { return a.gap < b.gap; });
    side = {nearest.normal, dot(nearest.normal, to_outer(met, nearest.arm)) - nearest.gap};
    for (const Contact* c = stop.contacts; c != end; ++c)
        if (c->gap <= nearest.gap + margin)
            stop.contacts[stop.count++] = {c->arm, c->normal, c->gap - std::max(nearest.gap, 0.0f)};
}

// Moves a body to its side of all planes. False if they leave no room, up to `little` (m).
bool keep_sides(const BodyShape& s, float scale, const FlatSide* sides, uint32_t count, float little, Pose& pose) {
    float room[most_stops];
    for (uint32_t k = 0; k < count; ++k)
        room[k] = sides[k].offset - lowest(s, scale, {{0.0f, 0.0f, 0.0f}, pose.rotation}, sides[k].normal);
    for (uint32_t round = 0; round < 2 * count; ++round)
        for (uint32_t k = 0; k < count; ++k) {
            const float below = room[k] - dot(sides[k].normal, pose.position);
            if (below > 0.0f) pose.position = pose.position + below * sides[k].normal;
        }
    for (uint32_t k = 0; k < count; ++k)
        if (room[k] - dot(sides[k].normal, pose.position) > little) return false;
    return true;
}

// The displacement that takes a centre of mass `clear` out of a solid again, through the side over which it came. In the solid's frame.
Vector way_out(const Geometry& solid, Vector from, Vector to, float clear) {
    const auto side = flat_side(solid, from, to, 0.0f);
    const float out = side ? dot(side->normal, to) - side->offset : 1.0f;
    return out > 0.0f ? Vector{} : (clear - out) * side->normal;
}
} // namespace

// The side of a box or a hull that acts as a plane for a body that ends the substep at `at`. fast: its path is so long that it is swept all the same,
// as over mesh floors. At rest the path is the fall in a substep, which the margin includes.
std::optional<FlatSide> ContactGroup::side_below(uint32_t i, const Collider& c, const Pose& at,
                                                 const ContactSubstep& substep, bool& fast) const {
    const Geometry& solid = c.geometry;
    if (!has_flat_sides(solid.kind)) return {};
    const float reach = arrays_.field[field_scale][i] * step_->shape->reach;
    const Vector first = relative(pose_at(c, substep.begin), pose_in(substep.before, i)).position;
    const Vector last = relative(pose_at(c, substep.end), at).position;
    fast = !(length(last - first) < reach + margin_of(i, substep.h));
    const auto side = flat_side(solid, first, last, reach);
    if (!side) return {};
    float least = -side->offset;
    for (uint32_t k = 0; solid.hull && k < solid.hull->vertex_count; ++k)
        least = std::min(least, dot(side->normal, solid.hull->corner(k)));
    // Beyond the middle of a thin solid the next substep would take the far side.
    return dot(side->normal, last) > 0.5f * (side->offset + least) ? side : std::nullopt;
}

// The free motion takes a resting body below its support by g h^2: a thin one by more than its thickness. There it would pass below a thing that
// stands on the same ground, or be pushed out through its lower side, which the ground does not allow. So bodies meet other things where their
// supports leave them. Returns the displacement (m) that takes it out of its supports at one end of the substep, and in `slow` that for those over
// which it is not swept; zero if it has nothing else to meet.
Vector ContactGroup::lift(uint32_t i, const Pose& at, float part, const ContactSubstep& substep, Vector& slow) const {
    Vector out{};
    slow = {};
    const MeshFloor& floor = floor_[i];
    const Near& near = near_[i];
    const auto is_floor = [&](const Candidate& c) { return floor.count > 0 && c.slot == floor.slot; };
    if (!near.meets_others()) return out;
    bool others = near.overflowed, floor_met = false;
    for (uint64_t left = near.others; left != 0; left &= left - 1)
        others = others || !is_floor(near.candidate[std::countr_zero(left)]);
    if (!others) return out;
    others = near.overflowed;
    const float scale = arrays_.field[field_scale][i];
    for (uint64_t left = near.grounds | near.others; left != 0; left &= left - 1) {
        const auto k = static_cast<uint32_t>(std::countr_zero(left));
        const Collider& c = step_->colliders->at(near.candidate[k].slot);
        const Pose pose = pose_at(c, part), here = relative(pose, at);
        const Vector x = here.position;
        bool fast = false;
        FlatSide side{{0.0f, 1.0f, 0.0f}, 0.0f};
        if (is_floor(near.candidate[k])) {
            if (std::exchange(floor_met, true)) continue;
            ContactPoints points(*step_->shape, scale, here, 0.0f);
            add_floor(points, *c.geometry.mesh, floor);
            if (points.count() == 0) continue;
            side = {floor.up, lowest(*step_->shape, scale, here, floor.up) - points.least_gap(0)};
        } else if (const HeightfieldGeometry* const f = c.geometry.heightfield) {
            if (!f->covers(x.x, x.z)) continue;
            const auto below = height_at(*f, x.x, x.z);
            side = {below.normal, dot(below.normal, {x.x, below.height, x.z})};
        } else if (c.geometry.kind != ColliderKind::plane) {
            const auto found = side_below(i, c, pose_of(i), substep, fast);
            others = others || !found;
            if (!found) continue;
            side = *found;
        }
        const Vector up = rotate(pose.rotation, side.normal);
        const float in = side.offset - lowest(*step_->shape, scale, here, side.normal) - dot(up, out);
        if (!(in > 0.0f)) continue;
        out = out + in * up;
        if (!fast) slow = slow + in * up;
    }
    // Deeper overlap is from before.
    const float most =
        length(pose_of(i).position - pose_in(substep.before, i).position) + shallow * scale * step_->shape->reach;
    if (!others || !(length(out) < most)) out = slow = {};
    return out;
}

// Where the supports leave a body as the substep begins. Under a wall that leans over the ground the way up leads through the wall.
Pose ContactGroup::lifted_start(uint32_t i, const ContactSubstep& substep) const {
    const Pose began = pose_in(substep.before, i);
    Vector slow;
    const Vector up = lift(i, began, substep.begin, substep, slow);
    if (dot(up, up) == 0.0f) return began;
    ContactSubstep before = substep;
    before.end = before.begin;
    const Vector back =
        way_back(*step_, arrays_.field[field_scale][i], arrays_.floor ? arrays_.floor[i] : 0,
                 floor_[i].count > 0 ? &floor_[i] : nullptr, began.position, began.position + up, before);
    return {began.position + up + back, began.rotation};
}

void ContactGroup::stop_before_passing_through(const ContactSubstep& substep) {
    const float begin = substep.begin, end = substep.end;
    for (uint32_t i = 0; i < count_; ++i) {
        const float scale = arrays_.field[field_scale][i];
        const Pose from = lifted_start(i, substep);
        Pose to = pose_of(i);
        to.position = to.position + lift_[i];
        const float little = 1e-3f * scale * step_->shape->reach;
        const float margin = margin_of(i, substep.h), rounding = scale * rounding_of(*step_->shape);
        const auto free_way = [&](const Pose& target, const Candidate& candidate) {
            const Collider& c = step_->colliders->at(candidate.slot);
            // Solid below: the path could jump only over parts thinner than itself.
            if (const HeightfieldGeometry* const f = c.geometry.heightfield; f && !c.moves)
                if (length(target.position - from.position) < 0.5f * std::min(f->spacing[0], f->spacing[1]))
                    return 1.0f;
            const Pose first = relative(pose_at(c, begin), from), last = relative(pose_at(c, end), target);
            bool fast = false;
            if (side_below(i, c, target, substep, fast) && !fast) return 1.0f;
            return free_fraction(*step_->shape, scale, first, last, c.geometry);
        };
        std::optional<Vector> face;
        const auto side_of = [&](const Candidate& candidate, const Pose& met, Stop& stop, FlatSide& side) {
            const Collider& c = step_->colliders->at(candidate.slot);
            if (!face) face = face_below(i, substep);
            stop.turn = inverse(met.rotation);
            find_side(*step_->shape, scale, met, c.geometry, candidate.part, margin,
                      relative(pose_at(c, begin), pose_in(substep.before, i)),
                      rotate(inverse(pose_at(c, end).rotation), *face), stop, side);
        };
        // A stopped body slides along the thing to the next one, then along both to a third.
        bool slid = false;
        uint32_t count = 0, met_count = 0;
        Pose target = to;
        FlatSide sides[most_stops]; // x is relative to the body's position before the substep
        Stop stops[most_stops];
        Candidate met_before[most_met];
        for (bool slides = true; slides;) {
            float free = 1.0f;
            Candidate candidate{};
            const Box way{low_of(from.position, target.position), high_of(from.position, target.position)};
            const auto meet = [&](const Candidate& c, float here) {
                if (here > free || (here == free && (free == 1.0f || comes_before(candidate, c)))) return;
                free = here;
                candidate = c;
            };
            any_order(i, grown(way, step_->shape->reach * scale), [&](const Candidate& c) {
                const Collider& other = step_->colliders->at(c.slot);
                if (floor_[i].count > 0 && c.slot == floor_[i].slot) return; // a floor is solid below
                if (const MeshGeometry* const mesh = other.geometry.mesh) {
                    const Pose ends = pose_at(other, end);
                    PassedTriangles passed{met_before, met_count, c.slot, count, little, {}};
                    for (uint32_t k = 0; k < count; ++k)
                        passed.sides[k] = {rotate(inverse(ends.rotation), sides[k].normal),
                                           sides[k].offset + dot(sides[k].normal, from.position - ends.position)};
                    const MetTriangle one =
                        first_triangle(*step_->shape, scale, relative(pose_at(other, begin), from),
                                       relative(ends, target), *mesh, c.part, PassedTriangles::skips, &passed);
                    return meet({c.slot, {one.index, 1}}, one.free);
                }
                const auto same = [&](const Candidate& m) { return m.slot == c.slot; };
                if (!std::any_of(met_before, met_before + met_count, same)) meet(c, free_way(target, c));
            });
            if (!(free < 1.0f)) break;
            met_before[met_count++] = candidate;
            const Collider& c = step_->colliders->at(candidate.slot);
            const Pose ends = pose_at(c, end);
            Pose met = mix(from, target, free);
            if (c.moves) { // it takes the body along, or it would go through a body that stops there
                const Pose there = relative(pose_at(c, begin + free * (end - begin)), met);
                met = {to_outer(ends, there.position), ends.rotation * there.rotation};
            }
            // On its way it can dip below a plane of which it ends in front, and meet the foot of a wall from below.
            if (count > 0) {
                met.position = met.position - from.position;
                keep_sides(*step_->shape, scale, sides, count, little, met);
                met.position = from.position + met.position;
            }
            Pose aside{to.position - from.position, to.rotation};
            Stop& stop = stops[count];
            FlatSide& side = sides[count];
            stop.candidate = candidate;
            side_of(candidate, relative(ends, met), stop, side);
            side.normal = rotate(ends.rotation, side.normal);
            side.offset += dot(side.normal, ends.position - from.position);
            FlatSide* const like = std::find_if(sides, sides + count, [&](const FlatSide& other) {
                return dot(other.normal, side.normal) > same_side;
            });
            if (like != sides + count)
                like->offset = std::max(like->offset, side.offset);
            else
                ++count;
            slides = count < most_stops && met_count < most_met &&
                     keep_sides(*step_->shape, scale, sides, count, little, aside);
            slid = slides;
            target = slides ? Pose{from.position + aside.position, to.rotation} : met;
        }
        if (count == 0) continue;
        // A body that rests stays pressed in, as over flat sides: only then do all points that bear it count, and it does not rock.
        const Vector out = target.position - pose_of(i).position;
        const bool rests = slid && length(out) < margin;
        const bool stone = step_->shape->thickness > 0.5f * step_->shape->reach;
        lift_[i] = rests ? out : Vector{};
        if (!rests) {
            const Rotation& q = target.rotation;
            put_in(arrays_.field, field_x, i, target.position);
            put_in(arrays_.field, field_qx, i, {q.x, q.y, q.z});
            arrays_.field[field_qw][i] = q.w;
        }
        // The body may have left a thing again, which still takes its speed.
        for (uint32_t n = 0; n < count; ++n) {
            const uint32_t slot = stops[n].candidate.slot;
            // Contacts of a pose that a rocking stone had earlier push it further. Thin bodies over edges of stairs need them.
            if (rests && stone) {
                FlatSide side;
                side_of(stops[n].candidate, relative(pose_at(step_->colliders->at(slot), end), target), stops[n], side);
            }
            // A rounding stays along the normal while the body turns on from the pose of the stop, as in the solver.
            const Rotation now = inverse(relative(pose_at(step_->colliders->at(slot), end), pose_of(i)).rotation);
            for (Contact* c = stops[n].contacts; c != stops[n].contacts + stops[n].count; ++c)
                c->arm = c->arm + rounding * (rotate(stops[n].turn, c->normal) - rotate(now, c->normal));
            add(i, slot, stops[n].contacts, stops[n].count, substep, lift_[i]);
        }
    }
}

// The solver can leave a small body deep in rough ground, and bodies over sides of boxes and hulls are not swept. A centre beyond the surface is put
// back, since the next substep would count it as on the other side.
void ContactGroup::leave_floors(const ContactSubstep& substep) {
    for (uint32_t i = 0; i < count_; ++i) {
        const MeshFloor& floor = floor_[i];
        const float scale = arrays_.field[field_scale][i];
        float deepest = 0.0f;
        uint32_t last = sleeping_body;               // stands for no solid so far
        for (uint32_t k = 0; k <= filled_[i]; ++k) { // the solids that it touches, then its floor
            const bool touched = k < filled_[i];
            const uint32_t slot = touched ? slots_.slot[k].collider[i] : floor.slot;
            if (touched) deepest = std::max(deepest, -slots_.slot[k].gap[i]);
            if (touched
                    ? slot == last || slot == sleeping_body || !has_flat_sides(step_->colliders->at(slot).geometry.kind)
                    : floor.count == 0 || !(deepest > shallow * scale * step_->shape->reach))
                continue;
            last = slot;
            const Collider& c = step_->colliders->at(slot);
            const Pose pose = pose_at(c, substep.end), at = pose_of(i);
            const Vector to = relative(pose, at).position;
            if (touched && distance_from(c.geometry, to) > 0.0f) continue;
            const Vector from = relative(pose_at(c, substep.begin), pose_in(substep.before, i)).position;
            const float clear = margin_of(i, 0.0f); // small: another thing may press the body from the other side
            const Vector out = touched ? way_out(c.geometry, from, to, clear)
                                       : way_out(*step_->shape, scale, to, *c.geometry.mesh, floor);
            put_in(arrays_.field, field_x, i, at.position + rotate(pose.rotation, out));
        }
    }
}

// Contacts can press a body into another thing after its swept test. Its own floor has the last word, as what presses may leave no room.
void ContactGroup::stay_in_front(const ContactSubstep& substep) {
    for (uint32_t i = 0; i < count_; ++i) {
        const float deep = shallow * arrays_.field[field_scale][i] * step_->shape->reach;
        const auto presses = [&](const ContactSlots::Slot& slot) {
            const uint32_t c = slot.collider[i];
            return slot.gap[i] < -deep || c == sleeping_body || !is_ground(step_->colliders->at(c).geometry.kind);
        };
        if (!std::any_of(slots_.slot, slots_.slot + filled_[i], presses)) continue;
        near_[i].others = near_[i].finite; // contacts can have moved it far
        Vector slow;
        const Pose to = pose_of(i);
        const Vector at = to.position + lift(i, to, substep.end, substep, slow),
                     from = lifted_start(i, substep).position;
        // Weight holds a body in front of an even floor. Contacts leave a centre beyond the tip of a stone, and beyond a wall that is its floor.
        const MeshFloor* even = floor_[i].count > 0 && floor_[i].even ? &floor_[i] : nullptr;
        if (even) {
            const Vector up = rotate(pose_at(step_->colliders->at(even->slot), substep.end).rotation, even->up);
            if (!(-2.0f * dot(up, step_->weight) > step_->gravity)) even = nullptr;
        }
        const bool alone = even && near_[i].only(even->slot, {low_of(from, at), high_of(from, at)});
        const Vector back = alone ? Vector{}
                                  : way_back(*step_, arrays_.field[field_scale][i],
                                             arrays_.floor ? arrays_.floor[i] : 0, even, from, at, substep);
        // Of a deep overlap whose correction would turn the body far, the solver undoes a part.
        if (!(dot(back, back) > 0.0f || length(at - to.position) > deep)) continue;
        Vector out{}; // of its own floor, into which other things can press it
        if (const MeshFloor& floor = floor_[i]; floor.count > 0) {
            const Collider& c = step_->colliders->at(floor.slot);
            const Pose pose = pose_at(c, substep.end);
            out = rotate(pose.rotation, way_out(*step_->shape, arrays_.field[field_scale][i], to_inner(pose, at + back),
                                                *c.geometry.mesh, floor));
        }
        put_in(arrays_.field, field_x, i, at + back + out);
    }
}

Vector way_back(const ContactStep& step, float scale, uint32_t floor, const MeshFloor* even, Vector from, Vector to,
                const ContactSubstep& substep) {
    struct Passed {
        float part = 1.0f; // fraction of the path
        Candidate candidate{};
        Vector out; // world frame
    };
    // Out of one thing the centre can get into another. Between a moving and a still one, as under a foot, the still one holds it. But the ground
    // yields: it has no other side, and out of a crate that stands on it a body finds no way.
    constexpr uint32_t most_rounds = 6, rounds_of_all = 3;
    // Small, so that a body pressed between two things does not jump between them, and less than the gap at which a thin body rests.
    const float clear = scale * std::min(0.005f * step.shape->reach, 0.125f * step.shape->thickness) +
                        contact_margin(0.0f, to, 0.0f, 0.0f);
    Vector at = to;
    bool moves = false;
    for (uint32_t round = 0;; ++round) {
        if (round == most_rounds) return (moves ? at : from) - to; // no room: it stays where it was in front of all
        if (const float way = length(at - from); !(way > 0.0f && way < 1e10f)) break; // diverged bodies are held later
        Passed first;
        bool any = false;
        step.colliders->visit(
            {low_of(from, at), high_of(from, at)}, step.settings->layers, [&](const Candidate& candidate) {
                const Collider& c = step.colliders->at(candidate.slot);
                const Geometry& g = c.geometry;
                if ((c.moves && round >= rounds_of_all) || (moves && is_ground(g.kind))) return;
                if (even && candidate.slot == even->slot) return;
                const Pose begin = pose_at(c, substep.begin), end = pose_at(c, substep.end);
                const Vector a = to_inner(begin, from), b = to_inner(end, at);
                const float far = length(b - a);
                const float above = is_ground(g.kind) ? height_over(g, a) : distance_from(g, a);
                if (!(far > 0.0f) || (!g.mesh && above <= 0.0f)) return; // it began inside
                const Ray ray{to_double(a), 1.0 / static_cast<double>(far) * to_double(b - a)};
                RayHit hit{};
                if (!(g.mesh ? ray_hits_part(*g.mesh, candidate.part, ray, static_cast<double>(far), hit)
                             : ray_hits_collider(g, nullptr, ray, static_cast<double>(far), hit)))
                    return;
                const Vector normal = rotate(end.rotation, to_float(hit.normal));
                const float over =
                    static_cast<float>(dot(hit.normal, (hit.distance - static_cast<double>(far)) * ray.direction));
                if (g.mesh && dot(normal, floor_side(floor, candidate.slot)) < 0.0f)
                    return; // it leaves the mesh that it was pressed into
                const float part = static_cast<float>(hit.distance) / far;
                if (any && (part > first.part || (part == first.part && comes_before(first.candidate, candidate))))
                    return;
                first = {part, candidate, (clear + over) * normal};
                any = true;
            });
        if (!any) break;
        at = at + first.out;
        moves = moves || step.colliders->at(first.candidate.slot).moves;
    }
    return at - to;
}
} // namespace lr
