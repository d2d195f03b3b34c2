// Writes a recording: records cut into frames, each handed to the host when it is whole.
#pragma once

#include "base/allocator.h"
#include "recording/recording_format.h"

#include <atomic>
#include <utility>

struct lr_asset;
struct lr_world;

namespace lr::recording {

class Recorder {
public:
    // Null when out of memory. The desc has been checked.
    static Recorder* create(Allocator& allocator, const lr_recording_desc& desc);
    static void destroy(Recorder* recorder);

    // The world's record: others follow that make what was there.
    void begin(const lr_world& world);
    // The world's callbacks are its own again.
    void end(lr_world& world);

    // A record: opened, filled, closed. Nothing happens any more once the host has refused.
    void open(Kind kind);
    void put(const void* bytes, uint64_t size);
    template <class T> void value(const T& v) { put(&v, sizeof v); }
    void close();
    template <class... T> void whole(Kind kind, const T&... values) {
        open(kind);
        (value(values), ...);
        close();
    }
    bool failed() const { return failed_; }

    // The number of an asset, whose record is written where it is new. False when out of memory.
    bool asset(const lr_asset& asset, uint32_t& id);
    // Whether it is among those remembered, as it is from now on.
    bool seen(uint64_t hash);
    // Bytes that calls name by the hash returned. Written once, or now and then again: few are remembered.
    uint64_t blob(const void* bytes, uint64_t size);
    static uint64_t blob_hash(const void* bytes, uint64_t size) {
        Hash hash(size);
        hash.add(bytes, size);
        return hash.value();
    }

    // A call whose arguments are written by `record` once it has accepted them.
    template <class Record> void wait_for(const Record& record) {
        waiting_ = &record;
        record_ = [](const void* self) { return (*static_cast<const Record*>(self))(); };
    }
    void wait_for_nothing() { record_ = nullptr; }
    // False when out of memory.
    bool accepted() {
        const auto record = std::exchange(record_, nullptr);
        return !record || record(waiting_);
    }
    void enter() { inside_ = true; } // a call, which has been written
    void result(Op op, lr_status status, uint64_t output, const lr_world& world);
    // After lr_world_set_wind_callback and its like: answers go through here.
    void listen(lr_world& world);

private:
    friend class lr::Allocator;
    Recorder(Allocator& allocator, const lr_recording_desc& desc) : allocator_(&allocator), desc_(desc) {}
    ~Recorder() = default;
    void flush(uint16_t flags);
    static void wind_asked(void* self, const lr_wind_query* query);
    static void surface_asked(void* self, const lr_water_query* query);
    void answer(Kind kind, uint32_t count, uint32_t batch, double time, const float* const* positions,
                const float* const* values, uint32_t value_count);

    Allocator* allocator_;
    lr_recording_desc desc_;
    Buffer<unsigned char> frame_; // with its header
    uint32_t used_ = 0;           // bytes behind the header
    uint64_t frames_ = 0;
    Kind kind_{};
    bool failed_ = false, inside_ = false;
    const void* waiting_ = nullptr;
    bool (*record_)(const void* waiting) = nullptr;
    uint32_t steps_ = 0; // since a hash
    static constexpr size_t most_seen = 4096;
    Buffer<uint64_t> seen_;      // a place for each hash that it may be in, the last one that came there
    Buffer<AssetRecord> assets_; // by id
    uint32_t asset_count_ = 0;
    template <class Function> struct Callers {
        Function function = nullptr;
        void* user = nullptr;
    };
    Callers<lr_wind_fn> wind_;
    Callers<lr_water_fn> surface_;
    std::atomic_flag writing_;
};

} // namespace lr::recording
