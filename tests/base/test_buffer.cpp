#include "base/allocator.h"
#include "support/counting_memory.h"

#include <doctest/doctest.h>

using namespace lr;

TEST_CASE("buffers take, swap and give back, and a refusal leaves them empty") {
    test::CountingAllocator memory;
    Allocator allocator(memory.callbacks());
    {
        Buffer<uint64_t> a, b;
        CHECK(a.allocate(allocator, 0));
        CHECK(a.data() == nullptr);
        REQUIRE(a.allocate(allocator, 10));
        CHECK(reinterpret_cast<uintptr_t>(a.data()) % 64 == 0);
        REQUIRE(b.allocate(allocator, 3));
        uint64_t* const of_a = a.data();
        a.swap(b);
        CHECK((b.data() == of_a && b.size() == 10 && a.size() == 3));
        CHECK(allocator.bytes() == 13 * 8);
        memory.fail_at = memory.calls;
        CHECK_FALSE(a.allocate(allocator, 5));
        CHECK((a.data() == nullptr && a.size() == 0));
        CHECK(allocator.bytes() == 10 * 8);
    }
    CHECK(allocator.bytes() == 0);
    CHECK(memory.live() == 0);
    CHECK_FALSE(memory.mismatch);
}
