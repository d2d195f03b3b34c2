#include "world/batch.h"

#include "kernel/aerodynamics.h"
#include "world/lifecycle.h"

#include <algorithm>
#include <new>

namespace lr {
namespace {

constexpr uint32_t mark_bit = 1u << 31; // above every generation

uint32_t padded(uint32_t count) {
    constexpr auto block = static_cast<uint32_t>(lane_block);
    return (count + block - 1) / block * block;
}

} // namespace

Batch* Batch::create(Allocator& allocator, const lr_asset& asset, uint32_t capacity, const BatchSettings& settings,
                     uint32_t index, uint32_t first_generation, lr_status& status) {
    status = LR_ERROR_OUT_OF_MEMORY;
    void* const memory = allocator.allocate(sizeof(Batch));
    if (!memory) return nullptr;
    Batch* const batch = new (memory) Batch(allocator, asset.data.length_d);
    batch->settings_ = settings;
    batch->index_ = index;
    batch->first_generation_ = first_generation;
    batch->asset_ = &asset;
    retain(asset);
    batch->shape = make_body_shape(asset.data);
    batch->step = StepInput{};
    batch->step.loads = settings.loads;
    batch->step.integrator = settings.integrator;
    if (!make_body_constants(asset.data, asset.diagonal, settings.fluid_density, batch->step.body)) {
        status = LR_ERROR_INTERNAL;
    } else {
        if (settings.force_full) batch->step.body.diagonal = false;
        if (!batch->set_aerodynamics(asset.data.aerodynamics, settings.gains))
            status = LR_ERROR_INTERNAL;
        else if (batch->allocate(capacity) && batch->set_asset_table())
            status = LR_OK;
    }
    if (status == LR_OK) return batch;
    destroy(batch);
    return nullptr;
}

void Batch::destroy(Batch* batch) {
    if (!batch) return;
    Allocator& allocator = *batch->allocator_;
    batch->~Batch();
    allocator.release(batch, sizeof(Batch));
}

Batch::~Batch() {
    Lifecycle::destroy(*allocator_, lifecycle_);
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
    for (uint32_t i = 0; i < lanes; ++i) clear_lane(i);
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
    for (size_t f = 0; f < fields(); ++f) arrays_.field[f][index] = 0.0f;
    arrays_.field[field_qw][index] = 1.0f;
    arrays_.field[field_scale][index] = 1.0f;
    arrays_.key[index] = 0;
}

lr_body Batch::add(const BodyState& state) {
    const uint32_t slot = free_first_;
    free_first_ = dense_[slot] & ~free_bit;
    const uint32_t index = count_++;
    const uint32_t generation = generations_[slot];
    last_generation_ = std::max(last_generation_, generation);
    dense_[slot] = index;
    ids_[index] = pack(BodyHandle{slot, generation, index_});
    write(index, state);
    arrays_.key[index] = state.key;
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
    if (index != last) {
        for (size_t f = 0; f < fields(); ++f) arrays_.field[f][index] = arrays_.field[f][last];
        arrays_.key[index] = arrays_.key[last];
        ids_[index] = ids_[last];
        dense_[unpack(ids_[index]).slot] = index;
    }
    external.move(last, index);
    if (lifecycle_) lifecycle_->move(last, index);
    clear_lane(last);
    ids_[last] = 0;
    --count_;
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
    return s;
}

void Batch::write(uint32_t index, const BodyState& state) {
    for (size_t f = 0; f < fields(); ++f) arrays_.field[f][index] = state.value[f];
}

uint32_t Batch::padded_count() const {
    return padded(count_);
}

bool Batch::make_loads(const AerodynamicData& loads, const Gains& gains, BodyConstants& out) const {
    out = step.body;
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
