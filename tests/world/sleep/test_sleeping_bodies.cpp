// A batch in two parts, against a model in a plain map; and data that moves with a body between them.
#include "support/lifecycle.h"
#include "support/quick.h"
#include "support/random.h"
#include "world/batch/lifecycle.h"
#include "world/world.h"

#include <algorithm>
#include <map>

using namespace test;

namespace {

struct Modelled {
    uint32_t noise_seed;
    bool rests;
    float x, stillness;
    double pushed;
    uint32_t touching, life;
};

struct Fixture {
    Asset asset = leaf();
    World world = make(world_desc());
    lr_batch handle;
    lr::Batch* batch;
    std::map<lr_body, Modelled> model;
    uint32_t next = 1;

    explicit Fixture(uint32_t capacity) : handle(add_batch(world, asset, capacity)), batch(world->find(handle)) {
        REQUIRE(batch->reserve_contact());
        REQUIRE(batch->reserve_forces());
        REQUIRE(batch->reserve_lifecycle());
    }
    void add() {
        lr::BodyState s{};
        s.noise_seed = next++;
        s.value[lr::field_x] = static_cast<float>(s.noise_seed);
        s.value[lr::field_qw] = s.value[lr::field_scale] = 1.0f;
        for (size_t f : {lr::field_vx, lr::field_wz, lr::field_gust_y}) s.value[f] = 1.0f;
        const lr_body id = batch->add(s);
        model[id] = {s.noise_seed, false, s.value[lr::field_x], 0.0f, 0.0, 0, 0};
    }
    // Notes of contact and forces on an awake body.
    void decorate(uint32_t index, Random& random) {
        Modelled& m = model.at(batch->ids()[index]);
        m.stillness = random.real(0.0, 1.0);
        m.touching = random.below(100);
        m.life = batch->columns().row<uint32_t>(lr::column_life)[index] = random.below(9);
        const lr::ContactCache contact = batch->contact_cache();
        REQUIRE(contact.stillness);
        contact.stillness[index] = m.stillness;
        contact.touching[2][index] = m.touching;
        batch->external.add(index, 0, lr::force_newton, {1.0, 0.0, 0.0});
        m.pushed += 1.0;
    }
    void check() const {
        REQUIRE(batch->count() == model.size());
        uint32_t awake = 0;
        bool good = true;
        for (const auto& [id, m] : model) {
            uint32_t at = 0;
            awake += m.rests ? 0u : 1u;
            if (!batch->find(id, at)) {
                good = false;
                continue;
            }
            const lr::BatchArrays& a = batch->arrays();
            const float speed = m.rests ? 0.0f : 1.0f;
            good = good && batch->ids()[at] == id && batch->asleep(at) == m.rests && a.noise_seed[at] == m.noise_seed;
            good = good && a.field[lr::field_x][at] == m.x && a.field[lr::field_vx][at] == speed &&
                   a.field[lr::field_wz][at] == speed && a.field[lr::field_gust_y][at] == speed;
            good = good && batch->contact_cache().stillness[at] == m.stillness &&
                   batch->contact_cache().touching[2][at] == m.touching;
            good = good && batch->columns().row<uint32_t>(lr::column_life)[at] == m.life;
            const float pushed = batch->columns().row<float>(lr::column_force)[at];
            good = good && wide(pushed) == (m.rests ? 0.0 : m.pushed);
        }
        CHECK(good);
        CHECK(batch->awake() == awake);
        // Free lanes stay finite and exert no forces.
        for (uint32_t i = batch->count(); i < batch->capacity(); ++i)
            good = good && batch->columns().row<float>(lr::column_force)[i] == 0.0f &&
                   batch->arrays().field[lr::field_qw][i] == 1.0f && batch->contact_cache().stillness[i] == 0.0f &&
                   batch->contact_cache().touching[2][i] == 0;
        CHECK(good);
    }
};

} // namespace

TEST_CASE(
    "whatever bodies are added, removed, put to rest and woken, both parts stay dense and keep what belongs to each") {
    const int operations = quick() ? 10000 : 100000;
    Random random(4);
    for (uint32_t capacity : {1u, 33u, 300u}) {
        Fixture f(capacity);
        lr::Batch& batch = *f.batch;
        uint64_t revision = batch.revision();
        std::vector<std::pair<uint32_t, lr_body>> tail; // sleeping bodies by index, at that revision
        int rests = 0, wakes = 0, removals = 0;
        for (int i = 0; i < operations / 3; ++i) {
            const uint32_t what = random.below(12);
            if (batch.count() == 0 || (what < 3 && batch.count() < capacity)) {
                f.add();
            } else {
                const uint32_t index = random.below(batch.count());
                const lr_body id = batch.ids()[index];
                Modelled& m = f.model.at(id);
                if (what < 6) {
                    if (m.rests) continue;
                    const uint32_t now = batch.fall_asleep(index);
                    CHECK(batch.ids()[now] == id);
                    m.rests = true, m.pushed = 0.0, ++rests;
                } else if (what < 8) {
                    if (!m.rests) continue;
                    const uint32_t now = batch.wake(index);
                    CHECK(batch.ids()[now] == id);
                    m.rests = false, m.stillness = 0.0f, m.pushed = 0.0, ++wakes;
                    for (size_t field : {lr::field_vx, lr::field_wz, lr::field_gust_y})
                        batch.arrays().field[field][now] = 1.0f;
                } else if (what < 10) {
                    batch.remove(id);
                    f.model.erase(id);
                    ++removals;
                } else if (!m.rests) {
                    f.decorate(index, random);
                }
            }
            // If the revision is the same, sleeping bodies have not moved.
            if (batch.revision() == revision)
                for (const auto& [at, body] : tail)
                    if (batch.ids()[at] != body || !batch.asleep(at)) FAIL("the tail has changed");
            revision = batch.revision();
            tail.clear();
            for (uint32_t at = batch.awake(); at < batch.count(); ++at) tail.emplace_back(at, batch.ids()[at]);
            if (i % 16 == 0) f.check();
        }
        f.check();
        CHECK((rests > operations / 60 && wakes > operations / 60 && removals > operations / 60));
        const uint32_t resting = batch.count() - batch.awake();
        CHECK((capacity == 1 || resting > 0));
        batch.wake_all();
        CHECK(batch.awake() == batch.count());
    }
}

TEST_CASE("bodies noted in a step come to rest after it, and only those, also where others end") {
    Random random(9);
    for (int round = 0; round < 40; ++round) {
        const uint32_t count = 1 + random.below(1500);
        Fixture f(count);
        for (uint32_t i = 0; i < count; ++i) f.add();
        const uint32_t asleep = round % 3 == 0 ? 0 : random.below(count);
        for (uint32_t i = 0; i < asleep; ++i) {
            f.model.at(f.batch->ids()[0]).rests = true;
            f.batch->fall_asleep(0);
        }
        // So few at times that most cuts have none; at the end, from where bodies move to freed places.
        const uint32_t one_of = round % 2 ? 3 : 40, first = round % 4 ? 0 : f.batch->awake() * 3 / 4;
        std::vector<lr_body> noted, ended;
        for (uint32_t i = 0; i < f.batch->awake(); ++i) {
            const lr_body id = f.batch->ids()[i];
            if (i >= first && random.below(one_of) == 0) f.batch->note_sleep(i), noted.push_back(id);
            if (random.below(5) == 0) ended.push_back(id);
        }
        // Rules end bodies from the last to the first.
        for (size_t i = ended.size(); i-- > 0;) {
            f.batch->remove(ended[i]);
            f.model.erase(ended[i]);
        }
        for (lr_body id : noted)
            if (const auto at = f.model.find(id); at != f.model.end()) at->second.rests = true;
        // A body that takes the place of a noted and ended body is not noted.
        while (f.batch->count() < count) f.add();
        f.batch->settle_noted();
        f.check();
        f.batch->settle_noted(); // then no body is noted
        f.check();
    }
}

TEST_CASE("noted bodies rest from the end of the step on that they were noted in") {
    Fixture f(600);
    for (int i = 0; i < 600; ++i) f.add();
    for (uint32_t i = 0; i < 600; i += 2) f.batch->note_sleep(i);
    steps(f.world, 1, 0.01f, 2);
    CHECK(f.batch->awake() == 300);
    for (uint32_t i = 300; i < 600; ++i) {
        const lr_body_state s = state_of(f.world, f.batch->ids()[i]);
        CHECK(s.sleep_state == LR_SLEEP_ASLEEP);
        CHECK(s.noise_seed % 2 == 1); // the first has noise seed 1
        CHECK(s.position[1] < 0.0f);  // it has moved in that step
        CHECK(s.age == doctest::Approx(0.01));
        CHECK(s.linear_velocity[1] == 0.0f);
    }
}

TEST_CASE("notes of contact are part of the hash if they are not 0, and of snapshots") {
    Fixture f(40);
    for (int i = 0; i < 40; ++i) f.add();
    const uint64_t plain = hash_of(f.world);
    const std::vector<unsigned char> before = snapshot_of(f.world);
    f.batch->contact_cache().touching[3][7] = 5;
    const uint64_t touching = hash_of(f.world);
    f.batch->contact_cache().stillness[7] = 0.25f;
    const uint64_t noted = hash_of(f.world);
    CHECK((touching != plain && noted != touching && noted != plain));
    for (uint32_t i = 0; i < 20; ++i) f.batch->fall_asleep(i);
    const uint64_t resting = hash_of(f.world);
    CHECK(resting != noted);
    const std::vector<unsigned char> snapshot = snapshot_of(f.world);
    CHECK(snapshot.size() > before.size());
    Fixture other(40);
    REQUIRE(lr_world_snapshot_restore(other.world.get(), snapshot.data(), snapshot.size()) == LR_OK);
    CHECK(hash_of(other.world) == resting);
    CHECK(snapshot_of(other.world) == snapshot);
    REQUIRE(lr_world_snapshot_restore(other.world.get(), before.data(), before.size()) == LR_OK);
    CHECK(hash_of(other.world) == plain);
    CHECK(other.batch->awake() == 40);
}
