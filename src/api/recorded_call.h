// A call as it goes into a recording: its arguments before it is carried out, if it is, and what came out after it.
#pragma once

#include "api/check_arguments.h"
#include "recording/recorder.h"

#include <type_traits>

namespace lr::api {

template <class T>
concept Handle = requires(T handle) {
    handle.id;
};

// What is recorded of a call is said once, by a function that takes a Call. It is gone through up to four times: to see whether anything is
// named that would have to be read; for large arrays; to write the arguments; for what came out. The caller's memory is read in the middle two
// alone, which come when the call has accepted what it was given: nobody has said before that it can be read.
class Call {
public:
    enum class Pass { ask, survey, write, output };

    Call(recording::Recorder& recorder, const char* function, recording::Kind kind = recording::Kind::call)
        : recorder_(&recorder), op_(recording::op_of(function)), kind_(kind) {}

    // Whether it names anything in the caller's memory.
    template <class Tell> bool names_memory(Tell&& tell) {
        tell(*this);
        return names_memory_;
    }
    // False where there is no memory to record what they name: without it nobody could play what follows.
    template <class Tell> bool arguments(Tell&& tell) {
        pass_ = Pass::survey;
        tell(*this);
        open(starved_ ? recording::call_cut : uint16_t{0});
        pass_ = Pass::write;
        if (!starved_) tell(*this);
        close();
        return !starved_;
    }
    // It has accepted nothing, and is recorded without arguments.
    void refused() {
        open(recording::call_cut);
        close();
    }
    bool recorded() const { return recorded_; }
    template <class Tell> void result(Tell&& tell, lr_status status, const lr_world& world) {
        pass_ = Pass::output;
        if (status == LR_OK) tell(*this);
        recorder_->result(op_, status, output_, world);
    }

    template <class T> void value(T v) {
        static_assert(std::is_arithmetic_v<T>);
        if (pass_ == Pass::write) recorder_->value(v);
    }
    // Whether what this points to may be read now. That there is nothing is recorded.
    bool reads(const void* from) {
        if (!from) value(static_cast<uint32_t>(recording::Where::null));
        if (from && pass_ == Pass::ask) names_memory_ = true;
        return from && (pass_ == Pass::survey || pass_ == Pass::write);
    }
    // Bytes that the call reads whole, whatever they say. Null too.
    void array(const void* bytes, uint64_t size) {
        if (!reads(bytes) || pass_ != Pass::write) return;
        recorder_->value(recording::Where::here);
        recorder_->value(size);
        recorder_->put(bytes, size);
    }
    // The same of what may be large, and given again.
    void shared_array(const void* bytes, uint64_t size) {
        if (size <= recording::most_here) return array(bytes, size);
        if (!reads(bytes)) return;
        if (pass_ == Pass::survey) {
            blobs_[blob_count_ % most_blobs] = recorder_->blob(bytes, size);
            ++blob_count_;
            return;
        }
        // Of colliders there may be many: those that were not kept are found again.
        const uint64_t hash =
            blob_count_ <= most_blobs ? blobs_[blobs_written_++] : recording::Recorder::blob_hash(bytes, size);
        recorder_->value(recording::Where::blob);
        recorder_->value(size);
        recorder_->value(hash);
    }
    // A struct; false where there is none, or it is not read now.
    template <class T> bool structure(const T* given, T& out) {
        if (!reads(given)) return false;
        copy_struct(given, out);
        value(static_cast<uint32_t>(recording::Where::here));
        write(out);
        return true;
    }
    template <class T> bool structure(const T* given) {
        T unused;
        return structure(given, unused);
    }
    // `each` for what an element points to.
    template <class T, class Each> void structures(const T* given, uint32_t count, Each&& each) {
        value(count);
        if (!reads(count != 0 ? given : nullptr)) return;
        value(static_cast<uint32_t>(recording::Where::here));
        const ArrayOf<T> all(given);
        T one;
        for (uint32_t i = 0; i < count; ++i) {
            all.copy(i, one);
            write(one);
            each(one);
        }
    }
    template <class T> void structures(const T* given, uint32_t count) {
        structures(given, count, [](const T&) {});
    }
    // Makes a record of its own where the asset is new.
    uint32_t asset(const lr_asset& asset) {
        uint32_t id = 0;
        if (!recorder_->asset(asset, id)) starved_ = true;
        return id;
    }
    void raw(const void* bytes, uint64_t size) {
        if (pass_ == Pass::write) recorder_->put(bytes, size);
    }

    // After the call: a handle or number, or several.
    template <class T> void output(const T* out, uint32_t count = 1) {
        if (pass_ != Pass::output || !out || count == 0) return;
        if (count == 1) {
            if constexpr (Handle<T>)
                output_ = out->id;
            else
                output_ = static_cast<uint64_t>(*out);
            return;
        }
        recording::Hash hash(count);
        hash.add(out, sizeof(T) * uint64_t{count});
        output_ = hash.value();
    }

private:
    template <class T> void write(const T& s) {
        value(recording::recorded_bytes<T>);
        raw(&s, recording::recorded_bytes<T>);
    }
    void open(uint16_t flags) {
        recorded_ = true;
        recorder_->open(kind_);
        recorder_->value(op_);
        recorder_->value(flags);
    }
    void close() {
        recorder_->close();
        if (kind_ == recording::Kind::call) recorder_->enter();
    }

    static constexpr uint32_t most_blobs = 8;
    recording::Recorder* recorder_;
    recording::Op op_;
    recording::Kind kind_;
    Pass pass_ = Pass::ask;
    bool names_memory_ = false, recorded_ = false, starved_ = false;
    uint64_t output_ = 0;
    uint64_t blobs_[most_blobs] = {};
    uint32_t blob_count_ = 0, blobs_written_ = 0;
};

} // namespace lr::api
