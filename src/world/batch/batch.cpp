#include "world/batch/batch.h"

#include "kernel/body_constants.h"
#include "kernel/divergence.h"
#include "kernel/limits.h"
#include "world/batch/lifecycle.h"
#include "world/schedule/step_chunks.h"
#include "world/sleep/shelter.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

namespace lr {
namespace {

constexpr uint32_t mark_bit = 1u << 31; // above every generation

// Covers both shapes, drawn and of contact: an ellipsoid's hull is slightly smaller than the ellipsoid, and a box of given extents has no hull.
double reach_of(const lr_asset& asset) {
    const AssetData& a = asset.data;
    const auto norm = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); };
    const auto& b = a.center_of_buoyancy;
    double reach = std::max(wide(asset.shape.reach), 0.5 * a.length_d + norm(b[0], b[1], b[2]));
    const std::vector<float>& v = a.hull.vertices;
    for (size_t i = 0; i + 3 <= v.size(); i += 3)
        reach = std::max(reach, norm(wide(v[i]), wide(v[i + 1]), wide(v[i + 2])));
    return reach;
}
} // namespace

Batch* Batch::create(Allocator& allocator, const lr_asset& asset, uint32_t capacity, const BatchSettings& settings,
                     uint32_t index, uint32_t first_generation, lr_status& status) {
    status = LR_ERROR_OUT_OF_MEMORY;
    Batch* const batch = allocator.make<Batch>(allocator, asset.data.length_d);
    if (!batch) return nullptr;
    batch->settings_ = settings;
    batch->index_ = index;
    batch->first_generation_ = first_generation;
    batch->asset_ = &asset;
    batch->reach_ = reach_of(asset);
    retain(asset);
    batch->set_contact(initial_contact);
    const lr_batch_desc& desc = settings.desc;
    batch->step.loads = desc.load_model == LR_LOADS_NONE       ? Loads::none
                        : desc.load_model == LR_LOADS_LANGEVIN ? Loads::langevin
                                                               : Loads::aerodynamic;
    batch->step.clock = desc.clock == LR_CLOCK_AGE ? Clock::age : Clock::speed;
    batch->step.integrator = desc.integrator == LR_INTEGRATOR_RK4 ? Integrator::rk4 : Integrator::splitting;
    batch->step.variation = desc.variation;
    batch->step.faults = &batch->faults.noted;
    const bool usable = make_body_constants(asset.data, asset.diagonal, settings.fluid_density, batch->step.body) &&
                        batch->set_aerodynamics(asset.data.aerodynamics, settings.gains);
    if (!usable)
        status = LR_ERROR_INTERNAL;
    else if (batch->allocate(capacity) && batch->set_table(batch->asset_table(), nullptr, nullptr))
        status = LR_OK;
    if (status == LR_OK) return batch;
    destroy(batch);
    return nullptr;
}

void Batch::destroy(Batch* batch) {
    if (batch) batch->allocator_->end(batch);
}

Batch::Batch(Allocator& allocator, double length) : pace(length), allocator_(&allocator) {}

Batch::~Batch() {
    release(asset_);
}

bool Batch::allocate(uint32_t capacity) {
    const size_t lanes = whole_blocks(capacity);
    if (!columns_.reserve(*allocator_, part_body, lanes) ||
        (step.loads == Loads::aerodynamic && !columns_.reserve(*allocator_, part_gust, lanes)) ||
        !dense_.allocate(*allocator_, capacity) || !generations_.allocate(*allocator_, capacity))
        return false;
    capacity_ = capacity;
    for (size_t f = 0; f < field_count; ++f)
        arrays_.field[f] = columns_.row<float>(f < field_gust_x ? f : column_gust + (f - field_gust_x));
    arrays_.noise_seed = columns_.row<uint32_t>(column_noise_seed);
    for (uint32_t i = 0; i < capacity; ++i) {
        dense_[i] = free_bit | (i + 1);
        generations_[i] = first_generation_;
    }
    free_first_ = 0;
    free_last_ = capacity - 1;
    return true;
}

lr_body Batch::add(const BodyState& state) {
    const uint32_t slot = free_first_;
    free_first_ = dense_[slot] & ~free_bit;
    if (awake_ < count_) {
        move(awake_, count_);
        columns_.clear(awake_, awake_ + 1);
        ++revision_;
    }
    ++count_;
    const uint32_t index = awake_++;
    const uint32_t generation = generations_[slot];
    last_generation_ = std::max(last_generation_, generation);
    dense_[slot] = index;
    const lr_body id = pack(BodyHandle{slot, generation, index_});
    columns_.row<lr_body>(column_ids)[index] = id;
    write(index, state);
    arrays_.noise_seed[index] = state.noise_seed;
    set_user(index, state.user);
    if (events_) events_->clear(slot);
    return id;
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
    if (asleep(index)) {
        sleeping_->leave(slot);
    } else {
        hole = --awake_;
        move(hole, index);
    }
    move(last, hole);
    columns_.clear(last, last + 1);
    --count_;
}

void Batch::move(uint32_t from, uint32_t to) {
    if (from == to) return;
    columns_.copy(from, to);
    moved(to);
}

void Batch::swap(uint32_t a, uint32_t b) {
    if (a == b) return;
    columns_.swap(a, b);
    moved(a);
    moved(b);
}

void Batch::moved(uint32_t index) {
    dense_[unpack(ids()[index]).slot] = index;
    const uint32_t* const noted = columns_.row<uint32_t>(column_noted);
    if (noted && noted[index] != 0) cut_noted_[index / cut_bodies] = 1;
}

uint32_t Batch::fall_asleep(uint32_t index) {
    if (held(index)) arrays_.field[field_age_remainder][index] = 0.0f; // so that it is no longer held when it wakes
    if (awake_ == count_) sleeping_->begin();
    const uint32_t to = --awake_;
    swap(index, to);
    columns_.clear(to, to + 1, column_gust, wake_fields);
    columns_.row<double>(column_birth)[to] =
        sleeping_->birth_of(arrays_.field[field_age][to], arrays_.field[field_age_remainder][to]);
    columns_.clear(to, to + 1, field_vx, 6);
    columns_.clear(to, to + 1, column_force, force_components);
    columns_.clear(to, to + 1, column_lee, 1);
    lie_down(to);
    return to;
}

// Needs its birth. After a snapshot was restored, a body in the same pose still has its box.
void Batch::lie_down(uint32_t index) {
    const uint32_t slot = unpack(ids()[index]).slot;
    const float scale = arrays_.field[field_scale][index];
    if (!sleeping_->has_box(slot)) sleeping_->set_box(slot, bounds(pair_hull_, scale, pose_of(arrays_, index)));
    sleeping_->enter(index, slot, vector_in(arrays_.field, field_x, index), scale);
}

uint32_t Batch::wake(uint32_t index) {
    const uint32_t slot = unpack(ids()[index]).slot;
    const Box box = sleeping_->box(slot);
    sleeping_->leave(slot);
    if (world_) uncover(*world_, *this, index, box);
    sleeping_->age_of(index, arrays_.field[field_age][index], arrays_.field[field_age_remainder][index]);
    oldest_ = std::max(oldest_, wide(arrays_.field[field_age][index]));
    columns_.clear(index, index + 1, column_birth, 1);
    columns_.clear(index, index + 1, column_gust, wake_fields); // they held the wind withstood
    columns_.clear(index, index + 1, column_stillness, 1);
    columns_.clear(index, index + 1, column_stay, stay_rows);
    if (events_) events_->note(slot, noted_waking);
    swap(index, awake_);
    ++revision_;
    return awake_++;
}

// Sleeping bodies have no wake, so the columns of its gust hold the wind, and the first of its lag the shelter.
void Batch::store_wind(uint32_t index, Vector wind, bool sheltered) {
    put_in(arrays_.field, field_gust_x, index, wind);
    arrays_.field[field_lag_x][index] = sheltered ? 1.0f : 0.0f;
    if (sheltered) sleeping_->note_sheltered();
}

void Batch::forget_shelter(uint32_t index) {
    if (!arrays_.field[field_lag_x] || arrays_.field[field_lag_x][index] == 0.0f) return;
    store_wind(index, {0.0f, 0.0f, 0.0f}, false);
    sleeping_->try_wind_again();
}

void Batch::doubt(uint32_t index) {
    float unknown = lee_unknown;
    __atomic_store(columns_.row<float>(column_lee) + index, &unknown, __ATOMIC_RELAXED);
    sleeping_->try_wind_again();
}

void Batch::wake_all() {
    while (awake_ < count_) wake(awake_);
}

// share: of the body's reach, round: of its greatest coordinate, by which boxes are enlarged.
void Batch::wake_near(const Box& box, double share, double round) {
    if (awake_ == count_) return;
    const auto greatest = [](Double3 a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); };
    const Double3 low = to_double(box.low), high = to_double(box.high);
    const auto touches = [&](uint32_t index) {
        const Double3 x = to_double(vector_in(arrays_.field, field_x, index));
        const double reach = reach_ * wide(arrays_.field[field_scale][index]) * (1.0 + share) + round * greatest(x);
        return x.x + reach >= low.x && x.x - reach <= high.x && x.y + reach >= low.y && x.y - reach <= high.y &&
               x.z + reach >= low.z && x.z - reach <= high.z;
    };
    const double far = std::max(greatest(low), greatest(high));
    const Box around = grown(box, static_cast<float>(1.01 * round * far));
    // Wakes in the order of indices, since the grid's order depends on the order of falling asleep, which no snapshot has.
    uint32_t found[1024];
    size_t n = 0;
    const auto note = [&](uint32_t slot) {
        if (n > std::size(found) || !touches(dense_[slot])) return;
        if (n < std::size(found)) found[n] = dense_[slot];
        ++n;
    };
    // A pass over all bodies takes as long as a visit to a twentieth as many cells.
    if (sleeping_->grid.visit(around, (count_ - awake_) / 24, note) && n <= std::size(found)) {
        std::sort(found, found + n);
        std::for_each(found, std::unique(found, found + n), [&](uint32_t i) { wake(i); });
        return;
    }
    // A waking body swaps places with a body before it, already visited. The margin is far above the rounding of the quick test.
    const auto reach = static_cast<float>(1.0001 * reach_ * (1.0 + share));
    const Box near = grown(box, static_cast<float>(1e-5 * far));
    for (uint32_t i = awake_;
         (i = next_in(near, arrays_.field + field_x, arrays_.field[field_scale], reach, i, count_)) < count_; ++i)
        if (touches(i)) wake(i);
}

// From spheres around the bodies; if the batch is behind, around all places that they may have reached since.
Box Batch::box() const {
    const auto reach = static_cast<float>(1.0001 * reach_), behind = static_cast<float>(1.0001 * pace.behind());
    float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    for (uint32_t i = 0; i < count_; ++i) {
        float r = reach * arrays_.field[field_scale][i];
        if (behind > 0.0f) r += behind * length(vector_in(arrays_.field, field_vx, i));
        for (size_t k = 0; k < 3; ++k) {
            const float x = arrays_.field[field_x + k][i];
            low[k] = std::min(low[k], x - r);
            high[k] = std::max(high[k], x + r);
        }
    }
    // Covers the rounding of positions, here and in renderers.
    for (size_t k = 0; k < 3 && count_ != 0; ++k) {
        low[k] = std::max(low[k] - 1e-6f * std::abs(low[k]), -FLT_MAX);
        high[k] = std::min(high[k] + 1e-6f * std::abs(high[k]), FLT_MAX);
    }
    return {vector_of(low), vector_of(high)};
}

void Batch::set_contact(const lr_batch_contact& contact) {
    // Boxes are kept for the pose of sleep, so they must be made anew with another thickness.
    const uint32_t boxes = sleeping_ && contact.min_thickness != contact_.min_thickness ? capacity_ : 0;
    for (uint32_t slot = 0; slot < boxes; ++slot) sleeping_->forget_box(slot);
    contact_ = contact;
    pair_hull_ = thickened(asset_->pair_hull, contact.min_thickness);
}

bool Batch::reserve_sleep() {
    // The contact shape may extend slightly beyond the reach, and be thickened later.
    const double most = std::max(reach(), (1.0 + 0.5 * most_thickened) * wide(asset_->pair_hull.shape.reach));
    return columns_.reserve(*allocator_, part_sleep, whole_blocks(capacity_)) &&
           sleeping_.reserve(*allocator_, capacity_, most, index_, columns_.row<double>(column_birth));
}

bool Batch::reserve_contact() {
    const uint32_t lanes = whole_blocks(capacity_);
    if (columns_.has(part_contact)) return true;
    if (!reserve_sleep() || !cut_noted_.allocate(*allocator_, cut_count(lanes))) return false;
    std::fill_n(cut_noted_.data(), cut_noted_.size(), uint8_t{0});
    if (!columns_.reserve(*allocator_, part_contact, lanes)) return false;
    arrays_.floor = columns_.row<uint32_t>(column_floor);
    return true;
}

bool Batch::any_contact() const {
    bool any = false;
    for (size_t i = 0; i < column_count; ++i)
        any = any || (body_columns[i].part == part_contact && body_columns[i].saved && columns_.any(i, count_));
    return any;
}

void Batch::forget_touched_bodies() {
    const ContactCache book = contact_cache();
    for (uint32_t i = 0; i < count_ && book.stillness; ++i) {
        size_t kept = 0;
        for (const uint32_t* touching : book.touching)
            if (touching[i] != touching_body) book.touching[kept++][i] = touching[i];
        for (; kept < most_touches; ++kept) book.touching[kept][i] = 0;
        book.lee[i] = 0.0f;
    }
}

void Batch::make_ages_exact() {
    for (uint32_t i = awake_; i < count_; ++i)
        sleeping_->age_of(i, arrays_.field[field_age][i], arrays_.field[field_age_remainder][i]);
}

ContactCache Batch::contact_cache() {
    ContactCache book;
    book.stillness = columns_.row<float>(column_stillness);
    book.lee = columns_.row<float>(column_lee);
    for (size_t k = 0; k < stay_rows; ++k) book.stay[k] = columns_.row<float>(column_stay + k);
    for (size_t k = 0; k < most_touches; ++k) book.touching[k] = columns_.row<uint32_t>(column_touching + k);
    book.falls_asleep = [](void* batch, uint32_t index) { static_cast<Batch*>(batch)->note_sleep(index); };
    book.batch = this;
    if (events_) book.notes = events_->notes(ids());
    return book;
}

void Batch::note_sleep(uint32_t index) {
    __atomic_store_n(&columns_.row<uint32_t>(column_noted)[index], 1u, __ATOMIC_RELAXED);
    __atomic_store_n(&cut_noted_[index / cut_bodies], uint8_t{1}, __ATOMIC_RELAXED);
}

// Backwards, so that no marked body moves to an index already visited.
void Batch::settle_noted() {
    if (!columns_.has(part_contact)) return;
    for (uint32_t cut = cut_count(padded_awake()); cut-- > 0;) {
        if (!take_cut(cut)) continue;
        const uint32_t begin = cut * cut_bodies;
        for (uint32_t i = std::min(begin + cut_bodies, awake_); i-- > begin;)
            if (take_note(i)) {
                if (events_) events_->note(unpack(ids()[i]).slot, noted_landing);
                fall_asleep(i);
            }
    }
}

// Forwards, since a waking body swaps places with one already visited.
void Batch::wake_noted() {
    if (!columns_.has(part_contact)) return;
    const uint32_t shared = awake_ / cut_bodies; // its awake bodies may be marked for sleep
    for (uint32_t cut = shared, end = cut_count(count_); cut < end; ++cut) {
        if (cut == shared ? cut_noted_[cut] == 0 : !take_cut(cut)) continue;
        const uint32_t begin = cut * cut_bodies;
        for (uint32_t i = std::max(begin, awake_); i < std::min(begin + cut_bodies, count_); ++i)
            if (take_note(i)) wake(i);
    }
}

bool Batch::find(lr_body body, uint32_t& index) const {
    const BodyHandle h = unpack(body);
    if (h.slot >= capacity_ || h.batch != index_) return false;
    const uint32_t at = dense_[h.slot];
    if (at >= count_ || ids()[at] != body) return false;
    index = at;
    return true;
}

bool Batch::mark(uint32_t index) {
    uint32_t& generation = generations_[unpack(ids()[index]).slot];
    if (generation & mark_bit) return false;
    generation |= mark_bit;
    return true;
}

void Batch::unmark(uint32_t index) {
    generations_[unpack(ids()[index]).slot] &= ~mark_bit;
}

BodyState Batch::read(uint32_t index) const {
    BodyState s{};
    for (size_t f = 0; f < field_count && arrays_.field[f]; ++f) s.value[f] = arrays_.field[f][index];
    s.noise_seed = arrays_.noise_seed[index];
    s.user = user(index);
    if (asleep(index)) sleeping_->age_of(index, s.value[field_age], s.value[field_age_remainder]);
    return s;
}

void Batch::grow_older(double seconds) {
    oldest_ += seconds;
    if (oldest_ <= wide(most_age)) return;
    oldest_ = 0.0;
    for (uint32_t i = 0; i < awake_; ++i) {
        float& age = arrays_.field[field_age][i];
        oldest_ = std::max(oldest_, wide(age));
        if (age <= most_age) continue;
        age = most_age;
        if (!is_held(arrays_.field[field_age_remainder][i])) arrays_.field[field_age_remainder][i] = 0.0f;
    }
}

void Batch::write(uint32_t index, const BodyState& state) {
    oldest_ = std::max(oldest_, wide(state.value[field_age]));
    for (size_t f = 0; f < field_count && arrays_.field[f]; ++f) arrays_.field[f][index] = state.value[f];
    if (arrays_.floor) arrays_.floor[index] = 0; // it may be on any side now
}

// The diagonal path needs loads along the body's axes at its centre of buoyancy; a diagonal asset's own are.
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

bool Batch::set_aerodynamics(const AerodynamicData& loads, const Gains& gains) {
    BodyConstants body;
    if (!make_loads(loads, gains, body)) return false;
    aerodynamics_ = loads;
    settings_.gains = gains;
    step.body = body;
    if (step.loads == Loads::aerodynamic)
        make_sheet(asset_->data, loads, asset_->diagonal, settings_.fluid_density, body, step.sheet);
    water_made_ = false;
    return true;
}

const WaterBody* Batch::water_body(const lr_water_desc& surface, bool& failed) {
    if (!water_made_ || water_density_ != surface.density || water_viscosity_ != surface.viscosity) {
        water_density_ = surface.density;
        water_viscosity_ = surface.viscosity;
        water_usable_ =
            make_water_body(asset_->data, aerodynamics_, settings_.gains, stationary_, asset_->diagonal,
                            settings_.fluid_density, std::max(wide(surface.density), settings_.fluid_density),
                            wide(surface.viscosity), step.loads, step.body, water_);
        water_made_ = true;
        failed = failed || !water_usable_;
    }
    return water_usable_ ? &water_ : nullptr;
}

void Batch::set_user(uint32_t index, uint64_t user) {
    if (columns_.has(part_user)) columns_.row<uint64_t>(column_user)[index] = user;
}

bool Batch::reserve_forces() {
    const size_t lanes = whole_blocks(capacity_);
    if (!columns_.reserve(*allocator_, part_forces, lanes)) return false;
    external.use(columns_.row<float>(column_force), lanes);
    return true;
}

bool Batch::reserve_lifecycle() {
    const uint32_t lanes = whole_blocks(capacity_);
    return columns_.reserve(*allocator_, part_life, lanes) && lifecycle_.reserve(*allocator_, lanes);
}

bool Batch::copy_table(const TableHead& head, const void* chi, const void* epsilon, Buffer<float>& out) const {
    if (!out.allocate(*allocator_, size_t{4} * head.count)) return false;
    if (chi) {
        std::memcpy(out.data(), chi, sizeof(float) * head.count);
        std::memcpy(out.data() + head.count, epsilon, sizeof(float) * head.count);
        return true;
    }
    const AssetData& a = asset_->data;
    const double rate = a.u0 / a.length_l, power = a.u0 * a.u0 * a.u0 / a.length_l;
    for (size_t i = 0; i < head.count; ++i) {
        out[i] = static_cast<float>(a.turbulence.chi[i] * rate);
        out[head.count + i] = static_cast<float>(a.turbulence.epsilon[i] * power);
    }
    return true;
}

TableHead Batch::asset_table() const {
    const AssetData& a = asset_->data;
    const TurbulenceData& t = a.turbulence;
    return {static_cast<uint32_t>(t.chi.size()), t.stationary, t.dt * a.length_l / a.u0, a.u0, a.length_l, t.c0};
}

bool Batch::use_table(Buffer<float>& table, const TableHead& head, bool of_asset) {
    const uint32_t n = head.count;
    float *const chi = table.data(), *const epsilon = chi + n, *const alpha = epsilon + n, *const beta = alpha + n;
    for (uint32_t i = 0; i < n; ++i) {
        alpha[i] = static_cast<float>(langevin_alpha(wide(chi[i]), head.c0, settings_.gains));
        beta[i] = static_cast<float>(langevin_beta_squared(wide(epsilon[i]), head.c0, settings_.gains));
    }
    step.table = {alpha, beta, static_cast<float>(1.0 / head.dt), static_cast<float>(n - 1),
                  settings_.desc.table_end == LR_TABLE_LOOP};
    const TurbulenceSample stationary = head.sample(chi[head.stationary], epsilon[head.stationary]);
    set_speed_turbulence(stationary, settings_.gains, step.body);
    stationary_ = of_asset ? TurbulenceSample{} : stationary;
    asset_table_ = of_asset;
    table_head_ = head;
    table_.swap(table);
    return set_aerodynamics(aerodynamics_, settings_.gains);
}

bool Batch::set_table(const TableHead& head, const float* chi, const float* epsilon) {
    Buffer<float> table;
    return copy_table(head, chi, epsilon, table) && use_table(table, head, !chi);
}
} // namespace lr
