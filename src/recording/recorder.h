// Writes a recording: splits records into frames and passes each complete frame to the host.
#pragma once

#include "base/allocator.h"
#include "base/threads.h"
#include "recording/recording_format.h"

#include <utility>

struct lr_asset;
struct lr_world;

namespace lr::recording {

class Recorder {
public:
    // Null when out of memory. desc: already checked.
    static Recorder* create(Allocator& allocator, const lr_recording_desc& desc);
    static void destroy(Recorder* recorder);

    // Writes the file header and the world's record. Records of setup calls follow.
    void begin(const lr_world& world);
    // Gives the world its own callbacks back.
    void end(lr_world& world);

    // A record: open(), put(), close(). No effect after the host's `write` has failed.
    void open(Kind kind);
    void put(const void* bytes, uint64_t size);
    template <class T> void value(const T& v) { put(&v, sizeof v); }
    void close() { flush(0); }
    template <class... T> void whole(Kind kind, const T&... values) {
        open(kind);
        (value(values), ...);
        close();
    }
    bool failed() const { return failed_; }

    // The number of an asset; writes a record if the asset is new. False when out of memory.
    bool asset(const lr_asset& asset, uint32_t& id);
    // Whether the hash is remembered. Remembers it.
    bool seen(uint64_t hash);
    // Writes bytes that calls refer to by the returned hash. Writes them again if the hash has been forgotten.
    uint64_t blob(const void* bytes, uint64_t size);
    static uint64_t blob_hash(const void* bytes, uint64_t size) {
        Hash hash(size);
        hash.add(bytes, size);
        return hash.value();
    }

    // The next accepted() calls `record`, which writes the arguments of the current call.
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
    void enter() { inside_ = true; } // a recorded call runs
    void result(Op op, lr_status status, uint64_t output, const lr_world& world);
    // After a callback was set: replaces it by one that also records its answers.
    void listen(lr_world& world);

private:
    friend class lr::Allocator;
    Recorder(Allocator& allocator, const lr_recording_desc& desc) : allocator_(&allocator), desc_(desc) {}
    ~Recorder() = default;
    void flush(uint16_t flags);
    static void wind_asked(void* self, const lr_wind_query* query);
    static void surface_asked(void* self, const lr_water_query* query);
    void answer(Kind kind, uint32_t count, uint32_t batch, double time, const void* const* keys, uint32_t key_rows,
                const float* const* values, uint32_t value_count);

    Allocator* allocator_;
    lr_recording_desc desc_;
    Buffer<unsigned char> frame_; // header and payload
    uint32_t used_ = 0;           // bytes of payload
    uint64_t frames_ = 0;
    Kind kind_{};
    bool failed_ = false, inside_ = false;
    const void* waiting_ = nullptr;
    bool (*record_)(const void* waiting) = nullptr;
    uint32_t steps_ = 0; // since the last hash
    static constexpr size_t most_seen = 4096;
    Buffer<uint64_t> seen_;      // a direct-mapped cache: hash h is in slot h % most_seen
    Buffer<AssetRecord> assets_; // index: id
    uint32_t asset_count_ = 0;
    template <class Function> struct Callers {
        Function function = nullptr;
        void* user = nullptr;
    };
    Callers<lr_wind_fn> wind_;
    Callers<lr_water_fn> surface_;
    WaitedCount writing_{0};
};
} // namespace lr::recording
