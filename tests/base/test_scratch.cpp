// Scratch memory of a step: what is nested deepest has room.
#include "base/scratch.h"

#include "world/step/step_in_wind.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

using namespace lr;

namespace {

template <class... T> constexpr size_t together = (InScratch<T>::size + ...);
using Copies = BodyCopies<field_block>;
// The trial of sleeping bodies, the step in which it ends, and the contacts or the water in that.
using Felt = std::array<FeltFlow, field_block>;
constexpr size_t trial = together<Copies, Felt, Copies>;
constexpr size_t solved = together<SolverMemory, ContactSlots>, floors = together<FloorLanes> + floor_scratch;
constexpr size_t contacts = together<Copies, ContactGroup> + std::max(solved, floors);
constexpr size_t water = together<NearBodies, std::array<SurfaceBlock, 3>>;
static_assert(trial + together<ContactPass, StepApart> + std::max(contacts, water) <= Scratch::bytes);
static_assert(trial + together<NearContacts, StepApart> + contacts <= Scratch::bytes);
} // namespace

TEST_CASE("temporaries lie in the scratch of their thread, one after the other") {
    Allocator allocator;
    ScratchPool pool;
    REQUIRE(pool.reserve(allocator, 2));
    const ScratchLease lease(pool, 1);
    const InScratch<std::array<char, 100>> first;
    const void* place = nullptr;
    {
        const InScratch<int> second(3);
        place = &*second;
        CHECK(*second == 3);
        CHECK(reinterpret_cast<uintptr_t>(place) % block_alignment == 0);
        CHECK(reinterpret_cast<uintptr_t>(place) - reinterpret_cast<uintptr_t>(first->data()) == 128);
    }
    const InScratch<int> third(4);
    CHECK(&*third == place);
    // A second thread of the same index gets the other; a world that is stepped within a callback leaves the outer one's alone.
    const Scratch* const outer = Scratch::here();
    {
        const ScratchLease again(pool, 1);
        CHECK(Scratch::here() != outer);
        const InScratch<int> own(5);
        CHECK(&*own != place);
    }
    CHECK(Scratch::here() == outer);
}
