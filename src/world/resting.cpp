#include "world/resting.h"

#include "field/touch_notes.h"
#include "kernel/limits.h"
#include "world/step_chunks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace lr {
namespace {

// From this age on what rounding adds is kept, as the kernel does for bodies that move.
constexpr float plain_age = 2.0f; // s
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double slack = 200.0; // s: what rounding may have added to an age, or taken from it

} // namespace

// A wind that a body has withstood says the same of every weaker one from about the same direction.
bool withstands(Vector held, Vector wind) {
    const float squared = dot(held, held), along = dot(held, wind);
    if (!(squared > 0.0f)) return dot(wind, wind) == 0.0f;
    if (along < 0.0f || along > 1.1f * squared) return false;
    const Vector across = wind - along / squared * held;
    return dot(across, across) <= 0.02f * squared;
}

Resting* Resting::create(Allocator& allocator, uint32_t capacity, double reach, uint32_t phase) {
    void* const memory = allocator.allocate(sizeof(Resting));
    if (!memory) return nullptr;
    auto* const made = new (memory) Resting();
    made->phase_ = phase % rule_steps;
    if (made->birth_.allocate(allocator, capacity) && made->boxes_.allocate(allocator, capacity) &&
        made->grid.create(allocator, capacity, reach)) {
        std::fill_n(made->birth_.data(), capacity, 0.0);
        for (uint32_t slot = 0; slot < capacity; ++slot) made->forget_box(slot);
        made->begin();
        return made;
    }
    destroy(allocator, made);
    return nullptr;
}

void Resting::destroy(Allocator& allocator, Resting* resting) {
    if (!resting) return;
    resting->~Resting();
    allocator.release(resting, sizeof(Resting));
}

bool Resting::reserve_contact(Allocator& allocator, uint32_t lanes) {
    if (contact.rest_time) return true;
    Buffer<float> rest_time, stay;
    Buffer<uint32_t> touching;
    Buffer<uint8_t> noted, cut_noted;
    if (!rest_time.allocate(allocator, lanes) || !stay.allocate(allocator, size_t{stay_rows} * lanes) ||
        !touching.allocate(allocator, size_t{most_touched} * lanes) || !noted.allocate(allocator, lanes) ||
        !cut_noted.allocate(allocator, cut_count(lanes)))
        return false;
    std::fill_n(rest_time.data(), rest_time.size(), 0.0f);
    std::fill_n(stay.data(), stay.size(), 0.0f);
    std::fill_n(touching.data(), touching.size(), 0u);
    std::fill_n(noted.data(), noted.size(), uint8_t{0});
    std::fill_n(cut_noted.data(), cut_noted.size(), uint8_t{0});
    rest_time_.swap(rest_time);
    stay_.swap(stay);
    touching_.swap(touching);
    noted_.swap(noted);
    cut_noted_.swap(cut_noted);
    contact.rest_time = rest_time_.data();
    for (size_t k = 0; k < stay_rows; ++k) contact.stay[k] = stay_.data() + k * lanes;
    for (size_t k = 0; k < most_touched; ++k) contact.touching[k] = touching_.data() + k * lanes;
    return true;
}

void Resting::begin() {
    clock_ = 0.0;
    earliest_ = never;
    steps_ = phase_;
    unjudged_ = false;
    tried_ = 0;
    std::fill_n(withstood_, 3, 0.0f);
}

void Resting::forget_box(uint32_t slot) {
    boxes_[slot].low.x = std::numeric_limits<float>::quiet_NaN();
}

void Resting::enter(uint32_t index, uint32_t slot, Vector position, float scale, double birth) {
    birth_[index] = birth;
    tried_ = 0;
    earliest_ = std::min(earliest_, birth);
    grid.insert(slot, position, scale);
}

void Resting::age_of(uint32_t index, float& age, float& age_rest) const {
    const double exact = std::clamp(clock_ - birth_[index], 0.0, static_cast<double>(most_age));
    age = static_cast<float>(exact);
    age_rest = age >= plain_age ? static_cast<float>(static_cast<double>(age) - exact) : 0.0f;
}

void Resting::swap(uint32_t a, uint32_t b) {
    std::swap(birth_[a], birth_[b]);
    if (!contact.rest_time) return;
    std::swap(rest_time_[a], rest_time_[b]);
    for (float* row : contact.stay) std::swap(row[a], row[b]);
    for (uint32_t* touching : contact.touching) std::swap(touching[a], touching[b]);
    std::swap(noted_[a], noted_[b]);
    for (uint32_t i : {a, b})
        if (noted_[i] != 0) cut_noted_[i / cut_bodies] = 1;
}

void Resting::move(uint32_t from, uint32_t to) {
    if (from == to) return;
    birth_[to] = birth_[from];
    if (!contact.rest_time) return;
    rest_time_[to] = rest_time_[from];
    for (float* row : contact.stay) row[to] = row[from];
    for (uint32_t* touching : contact.touching) touching[to] = touching[from];
    noted_[to] = noted_[from];
    if (noted_[to] != 0) cut_noted_[to / cut_bodies] = 1;
}

void Resting::clear(uint32_t index) {
    birth_[index] = 0.0;
    forget(index);
}

void Resting::forget_rest(uint32_t index) {
    if (!contact.rest_time) return;
    rest_time_[index] = 0.0f;
    for (float* row : contact.stay) row[index] = 0.0f;
}

void Resting::forget(uint32_t index) {
    if (!contact.rest_time) return;
    forget_rest(index);
    for (uint32_t* touching : contact.touching) touching[index] = 0;
    noted_[index] = 0;
}

void Resting::forget_touched_bodies(uint32_t count) {
    for (uint32_t i = 0; i < count && contact.rest_time; ++i) {
        size_t kept = 0;
        for (size_t k = 0; k < most_touched; ++k) {
            const uint32_t touched = contact.touching[k][i];
            if (touched != touching_body) contact.touching[kept++][i] = touched;
        }
        for (; kept < most_touched; ++kept) contact.touching[kept][i] = 0;
    }
}

bool Resting::pass(double seconds, uint32_t steps) {
    clock_ += seconds;
    steps_ += steps;
    if (steps_ < rule_steps) return false;
    steps_ %= rule_steps;
    return true;
}

bool Resting::withstood(const float (&wind)[3]) {
    const Vector held{withstood_[0], withstood_[1], withstood_[2]}, now{wind[0], wind[1], wind[2]};
    if (!withstands(held, now)) {
        tried_ = 0;
        std::copy(wind, wind + 3, withstood_);
    }
    if (tried_ == rule_steps) return true;
    ++tried_;
    return false;
}

// The eldest decides, rounded as its age will be: whether this says yes too often must not matter.
bool Resting::in_question(float max_age) const {
    return unjudged_ || (max_age > 0.0f && static_cast<float>(clock_ - earliest_) >= max_age);
}

void Resting::answered(uint32_t begin, uint32_t end, float max_age) {
    unjudged_ = false;
    earliest_ = never;
    for (uint32_t i = begin; i < end; ++i) {
        const bool stays = max_age <= 0.0f || static_cast<float>(clock_ - birth_[i]) < max_age;
        if (stays) earliest_ = std::min(earliest_, birth_[i]);
    }
}

void Resting::note(uint32_t index) {
    const auto set = [](uint8_t& one) { __atomic_store_n(&one, uint8_t{1}, __ATOMIC_RELAXED); };
    set(noted_[index]);
    set(cut_noted_[index / cut_bodies]);
}

bool Resting::any_contact(uint32_t count) const {
    if (!contact.rest_time) return false;
    const auto any = [count](const auto* row) {
        return std::any_of(row, row + count, [](auto noted) { return noted != 0; });
    };
    return any(contact.rest_time) || any(contact.stay[0]) ||
           std::any_of(contact.touching, contact.touching + most_touched, any);
}

bool Resting::take_cut(uint32_t cut) {
    return std::exchange(cut_noted_[cut], uint8_t{0}) != 0;
}

bool Resting::take_note(uint32_t index) {
    return std::exchange(noted_[index], uint8_t{0}) != 0;
}

bool Resting::consistent(const Record& r, uint32_t count) {
    return r.awake < count && r.steps < rule_steps && r.unjudged <= 1 && r.tried <= rule_steps && r.reserved == 0 &&
           in_range(r.clock, 0.0, most_time) && !wrong_wind(r.wind);
}

bool Resting::consistent(const Record& r, double birth) {
    return in_range(birth, -(static_cast<double>(most_age) + slack), r.clock + slack);
}

void Resting::restore_turns(const Record& r) {
    tried_ = r.tried;
    std::copy(r.wind, r.wind + 3, withstood_);
}

void Resting::restore(const Record& r, uint32_t lanes) {
    clock_ = r.clock;
    steps_ = r.steps;
    unjudged_ = r.unjudged != 0;
    earliest_ = never;
    grid.clear();
    if (!contact.rest_time) return;
    std::fill_n(contact.rest_time, lanes, 0.0f);
    for (float* row : contact.stay) std::fill_n(row, lanes, 0.0f);
    for (uint32_t* touching : contact.touching) std::fill_n(touching, lanes, 0u);
    std::fill_n(noted_.data(), noted_.size(), uint8_t{0});
    std::fill_n(cut_noted_.data(), cut_noted_.size(), uint8_t{0});
}

} // namespace lr
