#include "world/batch.h"

#include "kernel/aerodynamics.h"
#include "kernel/faults.h"
#include "kernel/limits.h"
#include "world/lifecycle.h"
#include "world/step_chunks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

namespace lr {
namespace {

constexpr uint32_t mark_bit = 1u << 31; // above every generation

uint32_t padded(uint32_t count) {
    constexpr auto block = static_cast<uint32_t>(lane_block);
    return (count + block - 1) / block * block;
}

// The hull of an ellipsoid is a little smaller than that is.
double reach_of(const AssetData& a) {
    const auto norm = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); };
    const auto& b = a.center_of_buoyancy;
    double reach = 0.5 * a.length_d + norm(b[0], b[1], b[2]);
    const std::vector<float>& v = a.hull.vertices;
    for (size_t i = 0; i + 3 <= v.size(); i += 3)
        reach = std::max(reach,
                         norm(static_cast<double>(v[i]), static_cast<double>(v[i + 1]), static_cast<double>(v[i + 2])));
    return reach;
}

} // namespace

Batch* Batch::create(Allocator& allocator, const lr_asset& asset, uint32_t capacity, const BatchSettings& settings,
                     uint32_t index, uint32_t first_generation, lr_status& status) {
    status = LR_ERROR_OUT_OF_MEMORY;
    void* const memory = allocator.allocate(sizeof(Batch));
    if (!memory) return nullptr;
    // Shapes are made with the C++ library's memory, which throws where it ends.
    std::unique_ptr<Batch, void (*)(Batch*)> made(new (memory) Batch(allocator, asset.data.length_d), &Batch::destroy);
    Batch* const batch = made.get();
    batch->settings_ = settings;
    batch->index_ = index;
    batch->first_generation_ = first_generation;
    batch->asset_ = &asset;
    batch->reach_ = reach_of(asset.data);
    retain(asset);
    batch->shape = make_body_shape(asset.data, asset.extents);
    batch->meeting = make_meeting_shape(batch->shape);
    batch->step = StepInput{};
    batch->step.loads = settings.loads;
    batch->step.clock = settings.clock;
    batch->step.integrator = settings.integrator;
    batch->step.faults = &batch->faults.noted;
    if (!make_body_constants(asset.data, asset.diagonal, settings.fluid_density, batch->step.body)) {
        status = LR_ERROR_INTERNAL;
    } else {
        if (!batch->set_aerodynamics(asset.data.aerodynamics, settings.gains))
            status = LR_ERROR_INTERNAL;
        else if (batch->allocate(capacity) && batch->set_asset_table())
            status = LR_OK;
    }
    return status == LR_OK ? made.release() : nullptr;
}

void Batch::destroy(Batch* batch) {
    if (!batch) return;
    Allocator& allocator = *batch->allocator_;
    batch->~Batch();
    allocator.release(batch, sizeof(Batch));
}

Batch::~Batch() {
    Lifecycle::destroy(*allocator_, lifecycle_);
    Resting::destroy(*allocator_, resting_);
    drop_events();
    release(asset_);
}

bool Batch::allocate(uint32_t capacity) {
    const size_t lanes = padded(capacity);
    if (!fields_.allocate(*allocator_, fields() * lanes) || !keys_.allocate(*allocator_, lanes) ||
        !ids_.allocate(*allocator_, capacity) || !dense_.allocate(*allocator_, capacity) ||
        !generations_.allocate(*allocator_, capacity))
        return false;
    capacity_ = capacity;
    for (size_t f = 0; f < fields(); ++f) arrays_.field[f] = fields_.data() + f * lanes;
    arrays_.key = keys_.data();
    clear_lanes(0, static_cast<uint32_t>(lanes));
    for (uint32_t i = 0; i < capacity; ++i) {
        ids_[i] = 0;
        dense_[i] = free_bit | (i + 1);
        generations_[i] = first_generation_;
    }
    free_first_ = 0;
    free_last_ = capacity - 1;
    return true;
}

// Lanes without a body are stepped along with the others: they must stay finite.
void Batch::clear_lane(uint32_t index) {
    clear_lanes(index, index + 1);
}

void Batch::clear_lanes(uint32_t begin, uint32_t end) {
    if (begin >= end) return;
    for (size_t f = 0; f < fields(); ++f)
        std::fill(arrays_.field[f] + begin, arrays_.field[f] + end, f == field_qw || f == field_scale ? 1.0f : 0.0f);
    std::fill(arrays_.key + begin, arrays_.key + end, 0u);
}

lr_body Batch::add(const BodyState& state) {
    const uint32_t slot = free_first_;
    free_first_ = dense_[slot] & ~free_bit;
    if (awake_ < count_) {
        move(awake_, count_);
        ++revision_;
    }
    ++count_;
    const uint32_t index = awake_++;
    const uint32_t generation = generations_[slot];
    last_generation_ = std::max(last_generation_, generation);
    dense_[slot] = index;
    ids_[index] = pack(BodyHandle{slot, generation, index_});
    write(index, state);
    arrays_.key[index] = state.key;
    if (resting_) resting_->clear(index);
    if (events_) events_->clear(slot);
    return ids_[index];
}

void Batch::remove(lr_body body) {
    const uint32_t slot = unpack(body).slot;
    const uint32_t index = dense_[slot], last = count_ - 1;
    if (count_ == capacity_)
        free_first_ = slot;
    else
        dense_[free_last_] = free_bit | slot;
    free_last_ = slot;
    generations_[slot] = next_generation(generations_[slot]);
    dense_[slot] = free_bit;
    if (events_) events_->clear(slot);
    if (awake_ < count_) ++revision_;
    uint32_t hole = index;
    if (rests(index)) {
        resting_->leave(slot);
    } else {
        hole = --awake_;
        move(hole, index);
    }
    move(last, hole);
    clear_lane(last);
    if (resting_) resting_->clear(last);
    ids_[last] = 0;
    --count_;
}

// The body at `from` takes a place that none has, or ends when both are the same.
void Batch::move(uint32_t from, uint32_t to) {
    external.move(from, to);
    if (lifecycle_) lifecycle_->move(from, to);
    if (resting_) resting_->move(from, to);
    if (from == to) return;
    for (size_t f = 0; f < fields(); ++f) arrays_.field[f][to] = arrays_.field[f][from];
    arrays_.key[to] = arrays_.key[from];
    ids_[to] = ids_[from];
    dense_[unpack(ids_[to]).slot] = to;
}

void Batch::swap(uint32_t a, uint32_t b) {
    if (a == b) return;
    for (size_t f = 0; f < fields(); ++f) std::swap(arrays_.field[f][a], arrays_.field[f][b]);
    std::swap(arrays_.key[a], arrays_.key[b]);
    std::swap(ids_[a], ids_[b]);
    dense_[unpack(ids_[a]).slot] = a;
    dense_[unpack(ids_[b]).slot] = b;
    external.swap(a, b);
    if (lifecycle_) lifecycle_->swap(a, b);
    if (resting_) resting_->swap(a, b);
}

bool Batch::held(uint32_t index) const {
    return !rests(index) && is_held(arrays_.field[field_age_rest][index]);
}

void Batch::judge(uint32_t index) {
    hold_if_insane(arrays_, index, &faults.noted, [&](size_t f) { return arrays_.field[f][index]; });
}

uint32_t Batch::rest(uint32_t index) {
    if (held(index)) arrays_.field[field_age_rest][index] = 0.0f; // a body at rest as any other
    if (awake_ == count_) resting_->begin();
    const uint32_t to = --awake_;
    swap(index, to);
    for (size_t f = field_gust_x; f < fields(); ++f) arrays_.field[f][to] = 0.0f;
    lie_down(to, resting_->birth_of(arrays_.field[field_age][to], arrays_.field[field_age_rest][to]));
    return to;
}

void Batch::lie_down(uint32_t index, double birth) {
    for (size_t f : {field_vx, field_vy, field_vz, field_wx, field_wy, field_wz}) arrays_.field[f][index] = 0.0f;
    external.clear(index);
    const uint32_t slot = unpack(ids_[index]).slot;
    resting_->set_box(slot, resting_box(index));
    resting_->enter(index, slot, vector_in(arrays_.field, field_x, index), arrays_.field[field_scale][index], birth);
}

Box Batch::resting_box(uint32_t index) const {
    return bounds(meeting, arrays_.field[field_scale][index], pose_of(arrays_, index));
}

uint32_t Batch::wake(uint32_t index) {
    resting_->leave(unpack(ids_[index]).slot);
    resting_->age_of(index, arrays_.field[field_age][index], arrays_.field[field_age_rest][index]);
    oldest_ = std::max(oldest_, static_cast<double>(arrays_.field[field_age][index]));
    resting_->forget_rest(index);
    for (size_t f = field_gust_x; f < fields(); ++f) arrays_.field[f][index] = 0.0f; // see LiftOff
    if (events_) events_->note_woke(unpack(ids_[index]).slot);
    swap(index, awake_);
    ++revision_;
    return awake_++;
}

void Batch::wake_all() {
    while (awake_ < count_) wake(awake_);
}

bool Batch::reaches_into(uint32_t index, const Box& box) const {
    const double reach = reach_ * wide(arrays_.field[field_scale][index]);
    const Double3 x = to_double(vector_in(arrays_.field, field_x, index)), low = to_double(box.low),
                  high = to_double(box.high);
    return x.x + reach >= low.x && x.x - reach <= high.x && x.y + reach >= low.y && x.y - reach <= high.y &&
           x.z + reach >= low.z && x.z - reach <= high.z;
}

bool Batch::reserve_rest() {
    // What others can touch may stand out of it by a little.
    const double most = std::max(reach(), static_cast<double>(meeting.shape.reach));
    if (!resting_) resting_ = Resting::create(*allocator_, capacity_, most, index_);
    return resting_ != nullptr;
}

// As lie_down() for each of them, but that boxes of those that lay like this are there already.
void Batch::restore_rest(const unsigned char* from, uint32_t before) {
    Resting::Record record{};
    if (from) std::memcpy(&record, from, sizeof record);
    awake_ = from ? record.awake : count_;
    ++revision_;
    if (!resting_) return;
    resting_->restore(record, padded(before));
    for (size_t f : {field_vx, field_vy, field_vz, field_wx, field_wy, field_wz})
        std::fill(arrays_.field[f] + awake_, arrays_.field[f] + count_, 0.0f);
    external.clear(awake_, count_);
    for (uint32_t i = awake_; from && i < count_; ++i) {
        double birth = 0.0;
        std::memcpy(&birth, from + sizeof record + 8 * uint64_t{i}, sizeof birth);
        const uint32_t slot = unpack(ids_[i]).slot;
        if (!resting_->has_box(slot)) resting_->set_box(slot, resting_box(i));
        resting_->enter(i, slot, vector_in(arrays_.field, field_x, i), arrays_.field[field_scale][i], birth);
    }
    resting_->restore_turns(record);
}

bool Batch::reserve_contact() {
    return reserve_rest() && resting_->reserve_contact(*allocator_, padded(capacity_));
}

void Batch::forget_touched_bodies() {
    if (resting_) resting_->forget_touched_bodies(count_);
}

void Batch::make_ages_exact() {
    for (uint32_t i = awake_; i < count_; ++i)
        resting_->age_of(i, arrays_.field[field_age][i], arrays_.field[field_age_rest][i]);
}

ContactBook Batch::contact_book() {
    const ContactArrays arrays = contact_arrays();
    ContactBook book;
    book.rest_time = arrays.rest_time;
    std::copy(arrays.stay, arrays.stay + stay_rows, book.stay);
    std::copy(arrays.touching, arrays.touching + most_touched, book.touching);
    book.comes_to_rest = [](void* batch, uint32_t index) { static_cast<Batch*>(batch)->note_rest(index); };
    book.batch = this;
    if (events_) book.notes = events_->notes(ids_.data());
    return book;
}

// From the last to the first: one that is noted too never moves to a place that has been passed.
void Batch::settle_noted() {
    if (!resting_ || !resting_->contact.rest_time) return;
    for (uint32_t cut = cut_count(padded_awake()); cut-- > 0;) {
        if (!resting_->take_cut(cut)) continue;
        const uint32_t begin = cut * cut_bodies;
        for (uint32_t i = std::min(begin + cut_bodies, awake_); i-- > begin;)
            if (resting_->take_note(i)) {
                if (events_) events_->note_landed(unpack(ids_[i]).slot);
                rest(i);
            }
    }
}

// From the first to the last: one that moves into the place of another has been looked at.
void Batch::wake_noted() {
    if (!resting_ || !resting_->contact.rest_time) return;
    const uint32_t shared = awake_ / cut_bodies; // with bodies that move, which may be noted for rest
    for (uint32_t cut = shared, end = cut_count(count_); cut < end; ++cut) {
        if (cut == shared ? !resting_->cut_noted(cut) : !resting_->take_cut(cut)) continue;
        const uint32_t begin = cut * cut_bodies;
        for (uint32_t i = std::max(begin, awake_); i < std::min(begin + cut_bodies, count_); ++i)
            if (resting_->take_note(i)) wake(i);
    }
}

bool Batch::find(lr_body body, uint32_t& index) const {
    const BodyHandle h = unpack(body);
    if (h.slot >= capacity_ || h.batch != index_) return false;
    const uint32_t at = dense_[h.slot];
    if (at >= count_ || ids_[at] != body) return false;
    index = at;
    return true;
}

bool Batch::mark(uint32_t index) {
    uint32_t& generation = generations_[unpack(ids_[index]).slot];
    if (generation & mark_bit) return false;
    generation |= mark_bit;
    return true;
}

void Batch::unmark(uint32_t index) {
    generations_[unpack(ids_[index]).slot] &= ~mark_bit;
}

BodyState Batch::read(uint32_t index) const {
    BodyState s{};
    for (size_t f = 0; f < fields(); ++f) s.value[f] = arrays_.field[f][index];
    s.key = arrays_.key[index];
    if (rests(index)) resting_->age_of(index, s.value[field_age], s.value[field_age_rest]);
    return s;
}

void Batch::grow_older(double seconds) {
    oldest_ += seconds;
    if (oldest_ <= static_cast<double>(most_age)) return;
    oldest_ = 0.0;
    for (uint32_t i = 0; i < awake_; ++i) {
        float& age = arrays_.field[field_age][i];
        oldest_ = std::max(oldest_, static_cast<double>(age));
        if (age <= most_age) continue;
        age = most_age;
        if (!is_held(arrays_.field[field_age_rest][i])) arrays_.field[field_age_rest][i] = 0.0f;
    }
}

void Batch::write(uint32_t index, const BodyState& state) {
    oldest_ = std::max(oldest_, static_cast<double>(state.value[field_age]));
    for (size_t f = 0; f < fields(); ++f) arrays_.field[f][index] = state.value[f];
}

uint32_t Batch::padded_count() const {
    return padded(count_);
}

uint32_t Batch::padded_awake() const {
    return padded(awake_);
}

// Loads off the body's axes or centre of buoyancy need the full path. Those of a diagonal asset are its own.
bool Batch::is_diagonal_with(const AerodynamicData& loads) const {
    constexpr std::array<double, 9> body_axes{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    const AerodynamicData& own = asset_->data.aerodynamics;
    return asset_->diagonal && ((loads.axes == own.axes && loads.center == own.center) ||
                                (loads.axes == body_axes && loads.center == std::array<double, 3>{}));
}

bool Batch::make_loads(const AerodynamicData& loads, const Gains& gains, BodyConstants& out) const {
    out = step.body;
    out.diagonal = is_diagonal_with(loads);
    if (!make_aerodynamics(asset_->data, loads, gains, asset_->diagonal, settings_.fluid_density, settings_.viscosity,
                           out))
        return false;
    if (stationary_.u0 > 0.0) set_gust_turbulence(stationary_, gains, out);
    return true;
}

bool Batch::can_use(const AerodynamicData& loads, const Gains& gains) const {
    BodyConstants ignored;
    return make_loads(loads, gains, ignored);
}

bool Batch::set_aerodynamics(const AerodynamicData& loads, const Gains& gains) {
    BodyConstants body;
    if (!make_loads(loads, gains, body)) return false;
    aerodynamics_ = loads;
    settings_.gains = gains;
    step.body = body;
    water_made_ = false;
    return true;
}

const WaterBody* Batch::water_body(const lr_surface_desc& surface, bool& failed) {
    if (!water_made_ || water_density_ != surface.density || water_viscosity_ != surface.viscosity) {
        water_density_ = surface.density;
        water_viscosity_ = surface.viscosity;
        water_usable_ = make_water_body(asset_->data, aerodynamics_, settings_.gains, stationary_, asset_->diagonal,
                                        settings_.fluid_density,
                                        std::max(static_cast<double>(surface.density), settings_.fluid_density),
                                        static_cast<double>(surface.viscosity), step.body, water_);
        water_made_ = true;
        failed = failed || !water_usable_;
    }
    return water_usable_ ? &water_ : nullptr;
}

bool Batch::reserve_forces() {
    return external.reserve(*allocator_, padded(capacity_));
}

bool Batch::reserve_lifecycle() {
    if (!lifecycle_) lifecycle_ = Lifecycle::create(*allocator_, capacity_, padded(capacity_));
    return lifecycle_ != nullptr;
}

bool Batch::reserve_events() {
    if (!events_) events_ = ContactEvents::create(*allocator_, capacity_);
    return events_ != nullptr;
}

void Batch::drop_events() {
    ContactEvents::destroy(*allocator_, events_);
    events_ = nullptr;
}

bool Batch::set_table(const TableView& t) {
    if (!fill_table(t)) return false;
    stationary_ = {static_cast<double>(t.chi[t.stationary]), static_cast<double>(t.epsilon[t.stationary]), t.u0, t.l,
                   t.c0};
    return set_aerodynamics(aerodynamics_, settings_.gains);
}

bool Batch::fill_table(const TableView& t) {
    if (t.count == 0 || !t.chi || !t.epsilon) return false;
    Buffer<float> table;
    if (!table.allocate(*allocator_, size_t{2} * t.count)) return false;
    const auto chi = [&](uint32_t i) { return static_cast<double>(t.chi[i]); };
    const auto epsilon = [&](uint32_t i) { return static_cast<double>(t.epsilon[i]); };
    for (uint32_t i = 0; i < t.count; ++i) {
        table[i] = static_cast<float>(langevin_alpha(chi(i), t.c0, settings_.gains));
        table[t.count + i] = static_cast<float>(langevin_beta_squared(epsilon(i), t.c0, settings_.gains));
    }
    table_.swap(table);
    step.table = {table_.data(), table_.data() + t.count, static_cast<float>(1.0 / t.dt),
                  static_cast<float>(t.count - 1), settings_.loop};
    set_speed_turbulence({chi(t.stationary), epsilon(t.stationary), t.u0, t.l, t.c0}, settings_.gains, step.body);
    return true;
}

TurbulenceSample Batch::strongest_turbulence(const TurbulenceSample& stationary, double& least_rate,
                                             double& most_rate) const {
    const auto rounded = [](double v) { return static_cast<double>(static_cast<float>(v)); };
    if (stationary.u0 > 0.0) {
        least_rate = rounded(1.0 / most_interval);
        most_rate = rounded(1.0 / least_interval);
        return {most_chi, most_epsilon, stationary.u0, stationary.l, stationary.c0};
    }
    const AssetData& a = asset_->data;
    const TurbulenceData& t = a.turbulence;
    least_rate = most_rate = rounded(1.0 / (t.dt * a.length_l / a.u0));
    const double chi = *std::max_element(t.chi.begin(), t.chi.end()),
                 epsilon = *std::max_element(t.epsilon.begin(), t.epsilon.end());
    return {rounded(chi * (a.u0 / a.length_l)), rounded(epsilon * (a.u0 * a.u0 * a.u0 / a.length_l)), a.u0, a.length_l,
            t.c0};
}

bool Batch::set_asset_table() {
    const AssetData& a = asset_->data;
    const TurbulenceData& t = a.turbulence;
    const auto count = static_cast<uint32_t>(t.chi.size());
    Buffer<float> samples;
    if (!samples.allocate(*allocator_, size_t{2} * count)) return false;
    const double rate = a.u0 / a.length_l, power = a.u0 * a.u0 * a.u0 / a.length_l;
    for (uint32_t i = 0; i < count; ++i) {
        samples[i] = static_cast<float>(t.chi[i] * rate);
        samples[count + i] = static_cast<float>(t.epsilon[i] * power);
    }
    if (!fill_table({samples.data(), samples.data() + count, count, t.stationary, t.dt * a.length_l / a.u0, a.u0,
                     a.length_l, t.c0}))
        return false;
    stationary_ = {};
    return set_aerodynamics(aerodynamics_, settings_.gains);
}

} // namespace lr
