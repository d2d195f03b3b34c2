// A call as it goes into a recording: its arguments before it is carried out, what came out after it.
#pragma once

#include "api/arguments.h"
#include "record/recorder.h"

#include <type_traits>

namespace lr::api {

// What is recorded of a call is said once, by a function that takes a Call. It is gone through three times: to see whether the
// arguments can be read, which must not be further than the call itself reads them; to write them; for what came out.
class Call {
public:
    enum class Pass { survey, write, output };

    Call(record::Recorder& recorder, record::Op op) : recorder_(&recorder), op_(op) {}

    // False where there is no memory to record what they name: without it nobody could play what follows.
    template <class Tell> bool arguments(Tell&& tell) {
        tell(*this);
        recorder_->open(record::Kind::call);
        recorder_->value(static_cast<uint16_t>(op_));
        recorder_->value(cut_ ? record::call_cut : uint16_t{0});
        pass_ = Pass::write;
        if (!cut_) tell(*this);
        recorder_->close();
        recorder_->enter();
        return !starved_;
    }
    template <class Tell> void result(Tell&& tell, lr_status status, const lr_world& world) {
        pass_ = Pass::output;
        if (!cut_ && status == LR_OK) tell(*this);
        recorder_->result(op_, status, output_, world);
    }

    template <class T> void value(T v) {
        static_assert(std::is_arithmetic_v<T>);
        if (pass_ == Pass::write) recorder_->value(v);
    }
    // A number or a struct.
    template <class T> void argument(T v) {
        if constexpr (std::is_pointer_v<T>)
            structure(v);
        else
            value(v);
    }
    // Bytes that the call reads whole, whatever they say. Null too.
    void array(const void* bytes, uint64_t size) {
        if (pass_ != Pass::write) return;
        recorder_->value(bytes ? record::Where::here : record::Where::null);
        if (!bytes) return;
        recorder_->value(size);
        recorder_->put(bytes, size);
    }
    // The same of what may be large, and given again.
    void shared_array(const void* bytes, uint64_t size) {
        if (!bytes || size <= record::most_here) return array(bytes, size);
        if (pass_ == Pass::survey) {
            blobs_[blob_count_ % most_blobs] = recorder_->blob(bytes, size);
            ++blob_count_;
        }
        if (pass_ != Pass::write) return;
        // Of colliders there may be many: those that were not kept are found again.
        const uint64_t hash =
            blob_count_ <= most_blobs ? blobs_[blobs_written_++] : record::Recorder::blob_hash(bytes, size);
        recorder_->value(record::Where::blob);
        recorder_->value(size);
        recorder_->value(hash);
    }
    // A struct; false where there is none, or none that can be read.
    template <class T> bool structure(const T* given, T& out) {
        if (!given) {
            if (pass_ == Pass::write) recorder_->value(record::Where::null);
            return false;
        }
        if (read_struct(given, out) != LR_OK) return cut();
        if (pass_ == Pass::write) {
            recorder_->value(record::Where::here);
            write(out);
        }
        return true;
    }
    template <class T> bool structure(const T* given) {
        T unused;
        return structure(given, unused);
    }
    // `each` for what an element points to.
    template <class T, class Each> void structures(const T* given, uint32_t count, Each&& each) {
        value(count);
        if (!given || count == 0) {
            if (pass_ == Pass::write) recorder_->value(record::Where::null);
            return;
        }
        if (pass_ == Pass::output) return;
        if (pass_ == Pass::write) recorder_->value(record::Where::here);
        const ArrayOf<T> all(given);
        T one;
        for (uint32_t i = 0; i < count && !cut_; ++i) {
            if (all.read(i, one) != LR_OK) {
                cut();
                return;
            }
            if (pass_ == Pass::write) write(one);
            each(one);
        }
    }
    template <class T> void structures(const T* given, uint32_t count) {
        structures(given, count, [](const T&) {});
    }
    // Makes a record of its own where the asset is new. Any pass.
    uint32_t asset(const lr_asset& asset) {
        uint32_t id = 0;
        if (!recorder_->asset(asset, id)) starved_ = cut_ = true;
        return id;
    }
    // Its arguments are not those of a call that is carried out: it is recorded without them.
    bool cut() {
        cut_ = true;
        return false;
    }
    void raw(const void* bytes, uint64_t size) {
        if (pass_ == Pass::write) recorder_->put(bytes, size);
    }

    // After the call: a handle or number, or several.
    template <class T> void output(const T* out, uint32_t count = 1) {
        if (pass_ != Pass::output || !out || count == 0) return;
        if (count == 1) {
            output_ = static_cast<uint64_t>(*out);
            return;
        }
        record::Hash hash(count);
        hash.add(out, sizeof(T) * uint64_t{count});
        output_ = hash.value();
    }

private:
    template <class T> void write(const T& s) {
        recorder_->value(record::recorded_bytes<T>);
        recorder_->put(&s, record::recorded_bytes<T>);
    }

    static constexpr uint32_t most_blobs = 8;
    record::Recorder* recorder_;
    record::Op op_;
    Pass pass_ = Pass::survey;
    bool cut_ = false, starved_ = false;
    uint64_t output_ = 0;
    uint64_t blobs_[most_blobs] = {};
    uint32_t blob_count_ = 0, blobs_written_ = 0;
};

} // namespace lr::api
