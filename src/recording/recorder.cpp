#include "recording/recorder.h"

#include "asset/asset.h"
#include "asset/asset_file.h"
#include "world/world.h"

#include <algorithm>

namespace lr::recording {

Recorder* Recorder::create(Allocator& allocator, const lr_recording_desc& desc) {
    auto* const recorder = allocator.make<Recorder>(allocator, desc);
    if (!recorder) return nullptr;
    if (recorder->frame_.allocate(allocator, most_frame) && recorder->seen_.allocate(allocator, most_seen)) {
        std::fill_n(recorder->seen_.data(), most_seen, uint64_t{0});
        return recorder;
    }
    destroy(recorder);
    return nullptr;
}

void Recorder::destroy(Recorder* recorder) {
    if (recorder) recorder->allocator_->end(recorder);
}

void Recorder::open(Kind kind) {
    kind_ = kind;
    used_ = 0;
}

void Recorder::put(const void* bytes, uint64_t size) {
    const auto* from = static_cast<const unsigned char*>(bytes);
    constexpr uint32_t room = most_frame - sizeof(FrameHeader);
    while (size != 0 && !failed_) {
        if (used_ == room) flush(frame_continues);
        const auto part = static_cast<uint32_t>(std::min<uint64_t>(size, room - used_));
        std::memcpy(frame_.data() + sizeof(FrameHeader) + used_, from, part);
        used_ += part;
        from += part;
        size -= part;
    }
}

void Recorder::flush(uint16_t flags) {
    if (failed_) return;
    FrameHeader header{used_, static_cast<uint16_t>(kind_), flags, 0};
    header.checksum = frame_checksum(header, frames_++, frame_.data() + sizeof header);
    std::memcpy(frame_.data(), &header, sizeof header);
    failed_ = desc_.write(desc_.user, frame_.data(), sizeof header + used_) != 0;
    used_ = 0;
}

bool Recorder::seen(uint64_t hash) {
    uint64_t& place = seen_[hash % most_seen];
    if (place == hash) return true;
    place = hash;
    return false;
}

uint64_t Recorder::blob(const void* bytes, uint64_t size) {
    const uint64_t hash = blob_hash(bytes, size);
    if (seen(hash)) return hash;
    open(Kind::blob);
    value(hash);
    put(bytes, size);
    close();
    return hash;
}

bool Recorder::asset(const lr_asset& asset, uint32_t& id) {
    for (id = 0; id < asset_count_; ++id)
        if (assets_[id].content_hash == asset.content_hash &&
            std::equal(asset.extents.begin(), asset.extents.end(), assets_[id].extents))
            return true;
    if (asset_count_ == assets_.size() && !enlarge(*allocator_, assets_, 8 + 2 * assets_.size(), asset_count_))
        return false;
    AssetRecord record{id, asset.format_version, asset.content_hash, {}};
    std::copy(asset.extents.begin(), asset.extents.end(), record.extents);
    const lr_status status = unless_out_of_memory([&] {
        const std::vector<uint8_t> bytes = write_asset(asset.data);
        open(Kind::asset);
        value(record);
        put(bytes.data(), bytes.size());
        close();
        return LR_OK;
    });
    if (status != LR_OK) return false;
    assets_[asset_count_++] = record;
    return true;
}

void Recorder::result(Op op, lr_status status, uint64_t output, const lr_world& world) {
    ResultRecord record{op, 0, status, output, 0};
    if (op == op_of("lr_world_step") && status == LR_OK && desc_.hash_interval != 0 &&
        ++steps_ >= desc_.hash_interval) {
        steps_ = 0;
        record.hashed = 1;
        record.hash = world.hash();
    }
    inside_ = false;
    whole(Kind::result, record);
}

void Recorder::listen(lr_world& world) {
    if ((desc_.flags & LR_RECORD_CALLBACKS) == 0) return;
    const auto listen_to = [this](auto& field, auto asked, auto& caller) {
        if (field.callback() == asked) return;
        caller = {field.callback(), field.callback_user()};
        if (caller.function) field.replace_callback(asked, this);
    };
    listen_to(world.wind, &wind_asked, wind_);
    listen_to(world.surface, &surface_asked, surface_);
}

void Recorder::end(lr_world& world) {
    if (world.wind.callback() == &wind_asked) world.wind.replace_callback(wind_.function, wind_.user);
    if (world.surface.callback() == &surface_asked) world.surface.replace_callback(surface_.function, surface_.user);
}

void Recorder::wind_asked(void* self, const lr_wind_query* query) {
    auto& recorder = *static_cast<Recorder*>(self);
    recorder.wind_.function(recorder.wind_.user, query);
    if (!recorder.inside_) return; // called by lr_world_sample_wind, which is not recorded
    const float* values[wind_values];
    std::copy_n(query->velocity, 3, values);
    std::copy_n(query->rate, 3, values + 3);
    std::copy_n(query->gradient, 9, values + 6);
    const void* const keys[] = {query->position[0], query->position[1], query->position[2]};
    recorder.answer(Kind::wind, query->count, query->batch.id, query->time, keys, wind_key_rows, values, wind_values);
}

void Recorder::surface_asked(void* self, const lr_water_query* query) {
    auto& recorder = *static_cast<Recorder*>(self);
    uint32_t given[field_block];
    for (uint32_t i = 0; i < query->count; ++i) given[i] = given_surface(*query, i);
    recorder.surface_.function(recorder.surface_.user, query);
    const float* values[surface_values] = {query->height};
    std::copy_n(query->normal, 3, values + 1);
    std::copy_n(query->velocity, 3, values + 4);
    std::copy_n(query->rate, 3, values + 7);
    const void* const keys[] = {query->position[0], query->position[1], query->position[2], given};
    recorder.answer(Kind::surface, query->count, query->batch.id, query->time, keys, surface_key_rows, values,
                    surface_values);
}

void Recorder::begin(const lr_world& world) {
    FileHeader header{{}, format_version, lr_version()};
    std::copy(std::begin(magic), std::end(magic), header.magic);
    failed_ = desc_.write(desc_.user, &header, sizeof header) != 0;
    WorldRecord record{};
    record.seed = world.seed;
    record.step_count = world.step_count;
    std::copy(world.gravity, world.gravity + 3, record.gravity);
    record.fluid_density = world.fluid_density;
    record.fluid_viscosity = world.fluid_viscosity;
    record.simd = world.target->simd;
    record.workers = world.step_workers.helpers();
    record.flags = desc_.flags;
    record.hash_interval = desc_.hash_interval;
    whole(Kind::world, record);
}

// Called by all workers, in any order: the player looks up an answer by its query.
void Recorder::answer(Kind kind, uint32_t count, uint32_t batch, double time, const void* const* keys,
                      uint32_t key_rows, const float* const* values, uint32_t value_count) {
    AnswerRecord record{count, batch, time, 0, 0};
    const uint64_t bytes = sizeof(float) * uint64_t{count};
    for (uint32_t v = 0; v < value_count; ++v) {
        uint32_t any = 0, word = 0; // the bits, because a negative zero must be recorded
        for (uint32_t i = 0; i < count; ++i) {
            std::memcpy(&word, values[v] + i, sizeof word);
            any |= word;
        }
        if (any != 0) record.given |= 1u << v;
    }
    while (writing_.exchange(1, std::memory_order_acquire) != 0) writing_.wait(1);
    open(kind);
    value(record);
    for (uint32_t k = 0; k < key_rows; ++k) put(keys[k], bytes);
    for (uint32_t v = 0; v < value_count; ++v)
        if ((record.given & 1u << v) != 0) put(values[v], bytes);
    close();
    writing_.store(0, std::memory_order_release);
    writing_.notify_one();
}
} // namespace lr::recording
