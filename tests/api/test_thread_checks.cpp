// LR_CHECK_THREADS: every function that takes a world refuses calls during another call on it.
#include "support/counting_memory.h"
#include "support/determinism_scenes.h"
#include "support/threads.h"
#include "support/wind.h"

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

using namespace test;

namespace {

// Arguments are null and 0: a refused call does not read them, any other call returns another status.
template <class Result, class... Rest> lr_status call(Result (*function)(lr_world*, Rest...), lr_world* w) {
    return function(w, Rest{}...);
}
template <class Result, class... Rest> lr_status call(Result (*function)(const lr_world*, Rest...), lr_world* w) {
    return function(w, Rest{}...);
}
lr_status call(void (*function)(lr_world*), lr_world* w) {
    function(w);
    return LR_OK;
}
lr_status call(uint64_t (*function)(const lr_world*), lr_world* w) {
    return function(w) == 0 ? LR_OK : LR_ERROR_INTERNAL;
}

struct Function {
    const char* name;
    lr_status (*run)(lr_world*);
    bool has_status;
};
#define WORLD_FUNCTION(name)                                                                                           \
    {#name, [](lr_world* w) { return call(&(name), w); },                                                              \
     !std::is_same_v<decltype(&(name)), decltype(&lr_world_destroy)> &&                                                \
         !std::is_same_v<decltype(&(name)), decltype(&lr_world_snapshot_size)> &&                                      \
         !std::string_view(#name).ends_with("_is_valid")},
// All declarations of the header, in its order: tests/CMakeLists.txt.
const Function functions[] = {
#include "world_functions.inc"
};

struct Messages {
    std::vector<std::string> all;
    static void log(void* user, int32_t, const char* message) {
        static_cast<Messages*>(user)->all.emplace_back(message);
    }
};

// Calls all functions and lists those that did not refuse.
std::string accepted(lr_world* w, lr_status expected) {
    std::string names;
    for (const Function& f : functions)
        if (f.run(w) != (f.has_status ? expected : LR_OK)) names += std::string(f.name) + " ";
    return names;
}

lr_world_desc checked(Messages& messages) {
    lr_world_desc d = world_desc();
    d.checks = LR_CHECK_THREADS;
    d.log = &Messages::log;
    d.log_user = &messages;
    return d;
}

struct Intruder {
    lr_world* world = nullptr;
    bool armed = false;
    std::string accepted_names = "nobody called";
    lr_status expected = LR_ERROR_REENTRANT;
    void intrude() {
        if (!armed) return;
        armed = false;
        accepted_names = accepted(world, expected);
    }
};

} // namespace

TEST_CASE("the table has every function with a world") {
    CHECK(std::size(functions) >= 56);
    for (const char* name : {"lr_world_step", "lr_body_get_state", "lr_collider_move", "lr_world_destroy"}) {
        bool there = false;
        for (const Function& f : functions) there = there || std::string(f.name) == name;
        CHECK_MESSAGE(there, name);
    }
}

TEST_CASE("a call from inside a callback is refused, whatever callback and function, and the step goes on") {
    const Asset asset = leaf();
    const auto play = [&](int which, std::string& names, std::vector<std::string>* told) {
        Messages messages;
        Intruder intruder;
        lr_world_desc d = checked(messages);
        struct Memory {
            CountingAllocator counting;
            Intruder* intruder;
        } memory{{}, &intruder};
        struct Jobs {
            Intruder* intruder;
            bool in_finish;
        } jobs{&intruder, which == 5};
        if (which == 2 || which == 3) {
            d.allocator.user = &memory;
            d.allocator.allocate = [](void* user, uint64_t size, uint64_t alignment) {
                auto& m = *static_cast<Memory*>(user);
                m.intruder->intrude();
                const lr_allocator a = m.counting.callbacks();
                return a.allocate(a.user, size, alignment);
            };
            d.allocator.release = [](void* user, void* block, uint64_t size, uint64_t alignment) {
                auto& m = *static_cast<Memory*>(user);
                m.intruder->intrude();
                const lr_allocator a = m.counting.callbacks();
                a.release(a.user, block, size, alignment);
            };
        }
        if (which == 4 || which == 5) {
            d.worker_count = 2;
            d.jobs.user = &jobs;
            d.jobs.enqueue = [](void* user, lr_task_fn run, void* task, uint32_t count) -> void* {
                if (!static_cast<Jobs*>(user)->in_finish) static_cast<Jobs*>(user)->intruder->intrude();
                run(task, 0, count);
                return nullptr;
            };
            d.jobs.finish = [](void* user, void*) {
                if (static_cast<Jobs*>(user)->in_finish) static_cast<Jobs*>(user)->intruder->intrude();
            };
        }
        const World world = make(d);
        intruder.world = world.get();
        const lr_batch batch = add_batch(world, asset, 6000);
        const std::vector<lr_body_desc> bodies(6000, body_desc());
        REQUIRE(lr_body_create(world.get(), batch, bodies.data(), 6000, nullptr) == LR_OK);
        const lr_water_desc water = initialised(lr_water_desc_init);
        REQUIRE(lr_world_set_water(world.get(), &water) == LR_OK);
        REQUIRE(lr_world_set_wind_callback(
                    world.get(),
                    [](void* user, const lr_wind_query*) {
                        if (user) static_cast<Intruder*>(user)->intrude();
                    },
                    which == 0 ? &intruder : nullptr) == LR_OK);
        REQUIRE(lr_world_set_water_callback(
                    world.get(),
                    [](void* user, const lr_water_query*) {
                        if (user) static_cast<Intruder*>(user)->intrude();
                    },
                    which == 1 ? &intruder : nullptr) == LR_OK);
        const bool in_memory = which == 2 || which == 3;
        intruder.armed = !in_memory && which < 6;
        steps(world, 2, 0.01f, 2);
        if (in_memory) { // creates or destroys a batch while callbacks call functions
            intruder.armed = which == 2;
            lr_batch_desc bd = batch_desc();
            bd.asset = asset.get();
            bd.capacity = 4;
            lr_batch other{};
            CHECK(lr_batch_create(world.get(), &bd, &other) == LR_OK);
            intruder.armed = which == 3;
            CHECK(lr_batch_destroy(world.get(), other) == LR_OK);
        } else {
            lr_batch other = add_batch(world, asset, 4);
            CHECK(lr_batch_destroy(world.get(), other) == LR_OK);
        }
        names = which == 6 ? "" : intruder.accepted_names;
        if (told) *told = messages.all;
        CHECK(info_of(world).body_count == 6000);
        return hash_of(world);
    };
    std::string names;
    const uint64_t expected = play(6, names, nullptr);
    for (int which = 0; which < 6; ++which) {
        CAPTURE(which);
        std::vector<std::string> told;
        CHECK(play(which, names, &told) == expected);
        CHECK(names == "");
        REQUIRE(told.size() == std::size(functions));
        const std::string in = which == 2 ? "lr_batch_create" : which == 3 ? "lr_batch_destroy" : "lr_world_step";
        for (size_t i = 0; i < told.size(); ++i) {
            CHECK(told[i].find(std::string(functions[i].name) + ": ") == 0);
            CHECK(told[i].find("callback of " + in) != std::string::npos);
        }
    }
}

TEST_CASE("a log that calls the library is refused once for each message, without end") {
    struct Log {
        lr_world* world = nullptr;
        int calls = 0;
        std::string names;
        static void log(void* user, int32_t, const char*) {
            auto& self = *static_cast<Log*>(user);
            ++self.calls;
            self.names += accepted(self.world, LR_ERROR_REENTRANT);
        }
    } log;
    lr_world_desc d = world_desc();
    d.checks = LR_CHECK_THREADS;
    d.log = &Log::log;
    d.log_user = &log;
    const World world = make(d);
    log.world = world.get();
    CHECK(lr_batch_destroy(world.get(), {77}) == LR_ERROR_STALE_BATCH);
    CHECK(log.names == "");
    // Messages: that of the failed call, one for each function called inside it, none for calls inside those.
    CHECK(log.calls == 1 + static_cast<int>(std::size(functions)));
    CHECK(lr_batch_destroy(world.get(), {77}) == LR_ERROR_STALE_BATCH);
    CHECK(log.calls == 2 * (1 + static_cast<int>(std::size(functions))));
}

TEST_CASE("every function leaves the world's guard, also if it fails") {
    Messages messages;
    const World world = make(checked(messages));
    for (const Function& f : functions) {
        if (std::string(f.name) == "lr_world_destroy") continue;
        f.run(world.get());
        CAPTURE(f.name);
        CHECK(info_of(world).body_count == 0);
    }
    for (const std::string& m : messages.all) CHECK(m.find("inside the same world") == std::string::npos);
}

TEST_CASE("every scene goes as without the check, and nobody is told anything" * doctest::test_suite("exact")) {
    for (PlayedScene& scene : played_scenes()) {
        CAPTURE(scene.name);
        scene.frames = 8;
        Messages messages;
        const uint64_t expected = outcome(scene, {.workers = 2});
        const uint64_t with = outcome(scene, {.workers = 2, .checks = LR_CHECK_THREADS});
        CHECK(with == expected);
    }
}

TEST_CASE("unknown checks are refused") {
    for (uint32_t bits : {2u, 3u, 0x80000000u}) {
        lr_world_desc d = world_desc();
        d.checks = bits;
        lr_world* world = nullptr;
        CHECK(lr_world_create(&d, &world) == LR_ERROR_INVALID_ARGUMENT);
        CHECK(world == nullptr);
    }
    lr_world_desc d = world_desc();
    d.reserved = 1;
    lr_world* world = nullptr;
    CHECK(lr_world_create(&d, &world) == LR_ERROR_INVALID_ARGUMENT);
}

#if LR_TEST_THREADS
TEST_CASE("another thread is refused, and told, while a step goes on: also with its destruction") {
    struct Meeting {
        std::atomic<bool> inside{false}, go_on{false};
        static void wind(void* user, const lr_wind_query* q) {
            auto& self = *static_cast<Meeting*>(user);
            for (uint32_t i = 0; i < q->count; ++i) q->velocity[0][i] = 1.0f;
            self.inside = true;
            while (!self.go_on) std::this_thread::yield();
        }
    };
    const Asset asset = leaf();
    const auto play = [&](bool met) {
        Meeting meeting;
        Messages messages;
        const World world = make(checked(messages));
        const lr_batch batch = add_batch(world, asset, 16);
        const lr_body body = add_body(world, batch, body_desc());
        REQUIRE(lr_world_set_wind_callback(world.get(), &Meeting::wind, &meeting) == LR_OK);
        meeting.go_on = !met;
        lr_status stepped = LR_ERROR_INTERNAL;
        std::thread stepper([&] { stepped = lr_world_step(world.get(), 0.01f, 2); });
        if (met) {
            while (!meeting.inside) std::this_thread::yield();
            const std::string names = accepted(world.get(), LR_ERROR_CONCURRENT_USE);
            CHECK(names == "");
            CHECK(lr_world_step(world.get(), 0.01f, 1) == LR_ERROR_CONCURRENT_USE);
            lr_batch made{9};
            const lr_batch_desc bd = batch_desc();
            CHECK(lr_batch_create(world.get(), &bd, &made) == LR_ERROR_CONCURRENT_USE);
            CHECK(made.id == 0);
            CHECK(messages.all.size() == std::size(functions) + 2);
            for (const std::string& m : messages.all)
                CHECK(m.find("lr_world_step is inside the same world") != std::string::npos);
            meeting.go_on = true;
        }
        stepper.join();
        CHECK(stepped == LR_OK);
        CHECK(state_of(world, body).linear_velocity[0] > 0.0f); // intact, and usable by this thread again
        return hash_of(world);
    };
    CHECK(play(true) == play(false));
}

TEST_CASE("a callback that calls the library from a worker is refused") {
    struct Calls {
        lr_world* world = nullptr;
        std::atomic<uint32_t> refused{0}, other{0};
        static void wind(void* user, const lr_wind_query*) {
            auto& self = *static_cast<Calls*>(user);
            uint64_t hash = 0;
            const lr_status status = lr_world_hash(self.world, &hash);
            ++(status == LR_ERROR_CONCURRENT_USE || status == LR_ERROR_REENTRANT ? self.refused : self.other);
        }
    } calls;
    lr_world_desc d = world_desc();
    d.checks = LR_CHECK_THREADS;
    d.worker_count = 3;
    const World world = make(d);
    calls.world = world.get();
    const Asset asset = leaf();
    const lr_batch batch = add_batch(world, asset, 8000);
    const std::vector<lr_body_desc> bodies(8000, body_desc());
    REQUIRE(lr_body_create(world.get(), batch, bodies.data(), 8000, nullptr) == LR_OK);
    REQUIRE(lr_world_set_wind_callback(world.get(), &Calls::wind, &calls) == LR_OK);
    steps(world, 3, 0.01f, 4);
    CHECK(calls.other == 0);
    CHECK(calls.refused >= 3 * 4 * 8000 / 256);
}

TEST_CASE("a world that goes from thread to thread is nobody's misuse") {
    Messages messages;
    const World world = make(checked(messages));
    const Asset asset = leaf();
    const lr_batch batch = add_batch(world, asset, 64);
    for (int i = 0; i < 50; ++i) {
        std::thread([&] {
            const lr_body_desc d = body_desc();
            CHECK(lr_body_create(world.get(), batch, &d, 1, nullptr) == LR_OK);
        }).join();
        std::thread([&] { CHECK(lr_world_step(world.get(), 0.01f, 1) == LR_OK); }).join();
    }
    CHECK(messages.all.empty());
    CHECK(info_of(world).body_count == 50);
}
#endif
