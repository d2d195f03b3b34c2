// Writes one call to a recording: its arguments before it runs, its outputs afterwards.
#pragma once

#include "api/check_arguments.h"
#include "environment/wind_source.h"
#include "recording/recorder.h"
#include "world/world.h"

#include <type_traits>

namespace lr::api {

template <class T>
concept Handle = requires(T handle) {
    handle.id;
};

// record_argument() of each argument runs in up to four passes: ask (does the call pass pointers?), survey (write large arrays as records of their
// own), write (the arguments), output (the results). Only survey and write read the caller's memory; they run after accepted(), because pointers are
// not validated before.
class Call {
public:
    enum class Pass { ask, survey, write, output };

    Call(recording::Recorder& recorder, const char* function, recording::Kind kind = recording::Kind::call)
        : recorder_(&recorder), op_(recording::op_of(function)), kind_(kind) {}

    // Whether the call passes non-null pointers.
    template <class Record> bool names_memory(Record&& record) {
        record(*this);
        return names_memory_;
    }
    // False when out of memory for the data behind the pointers. The call must then be refused: a replay could not continue.
    template <class Record> bool arguments(Record&& record) {
        pass_ = Pass::survey;
        record(*this);
        open(starved_ ? recording::call_cut : uint16_t{0});
        pass_ = Pass::write;
        if (!starved_) record(*this);
        close();
        return !starved_;
    }
    // Records a refused call, without its arguments.
    void refused() {
        open(recording::call_cut);
        close();
    }
    bool recorded() const { return recorded_; }
    template <class Record> void result(Record&& record, lr_status status, const lr_world& world) {
        pass_ = Pass::output;
        if (status == LR_OK) record(*this);
        recorder_->result(op_, status, output_, world);
    }

    template <class T> void value(T v) {
        static_assert(std::is_arithmetic_v<T>);
        if (pass_ == Pass::write) recorder_->value(v);
    }
    // Whether this pass reads through the pointer. Records a null pointer.
    bool reads(const void* from) {
        if (!from) value(static_cast<uint32_t>(recording::Where::null));
        if (from && pass_ == Pass::ask) names_memory_ = true;
        return from && (pass_ == Pass::survey || pass_ == Pass::write);
    }
    // An array that the call reads completely; can be null.
    void array(const void* bytes, uint64_t size) {
        if (!reads(bytes) || pass_ != Pass::write) return;
        recorder_->value(recording::Where::here);
        recorder_->value(size);
        recorder_->put(bytes, size);
    }
    // The same for an array that can be large and passed repeatedly: written once as a blob, then referred to by its hash.
    void shared_array(const void* bytes, uint64_t size) {
        if (size <= recording::most_here) return array(bytes, size);
        if (!reads(bytes)) return;
        if (pass_ == Pass::survey) {
            blobs_[blob_count_ % most_blobs] = recorder_->blob(bytes, size);
            ++blob_count_;
            return;
        }
        // One call can create many colliders; beyond most_blobs the hashes are computed again.
        const uint64_t hash =
            blob_count_ <= most_blobs ? blobs_[blobs_written_++] : recording::Recorder::blob_hash(bytes, size);
        recorder_->value(recording::Where::blob);
        recorder_->value(size);
        recorder_->value(hash);
    }
    // A struct. False if it is null or this pass does not read it.
    template <class T> bool structure(const T* given, T& out) {
        if (!reads(given)) return false;
        copy_struct(given, out);
        value(static_cast<uint32_t>(recording::Where::here));
        write(out);
        return true;
    }
    // `each` records the arrays that an element points to.
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
    // The number of an asset. A new asset becomes a record of its own.
    uint32_t asset(const lr_asset& asset) {
        uint32_t id = 0;
        if (!recorder_->asset(asset, id)) starved_ = true;
        return id;
    }
    void raw(const void* bytes, uint64_t size) {
        if (pass_ == Pass::write) recorder_->put(bytes, size);
    }

    // A result of the call: one handle or number, or an array as a hash.
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

// Argument types of calls and how each is recorded, for calls of the host and for calls that set up a recording's initial state.

// An array of structs with a struct_size. A call accepts all elements or none: it checks each before it uses the first.
template <Sized S> struct Structs {
    const S* first;
    uint32_t count;
    template <class Check> Outcome check(Check&& each) const { // stops at the first refused element
        S one{};
        for (uint32_t i = 0; i < count; ++i) {
            Outcome outcome = ArrayOf<S>(first).read(i, one);
            if (!outcome.refused()) outcome = each(one);
            if (outcome.refused()) return outcome;
        }
        return {};
    }
    template <class Use> void visit(Use&& use) const { // after check()
        check([&](const S& one) {
            use(one);
            return Outcome{};
        });
    }
};
template <Sized S> Structs(const S*, uint32_t) -> Structs<S>; // clang 14 needs these
template <class H> struct Handles {
    const H* first;
    uint32_t count;
};
template <class H> Handles(const H*, uint32_t) -> Handles<H>;
// `count` results; null if the caller does not want them.
template <class T> struct Out {
    T* first;
    uint32_t count = 1;
};
template <class T> Out(T*, uint32_t = 1) -> Out<T>;
template <class T> struct Required {
    explicit Required(T* p) : out(p) {}
    T* out; // unchanged if the call is refused
};
struct Snapshot {
    const void* memory;
    uint64_t size;
};

// Records arguments and results. Structs that contain pointers have overloads of their own.
template <class T>
requires std::is_arithmetic_v<T>
void record_argument(Call& call, T v) {
    call.value(v);
}
template <Handle H> void record_argument(Call& call, H handle) {
    call.value(handle.id);
}
template <Sized S> void record_argument(Call& call, const S* s) {
    S unused{};
    call.structure(s, unused);
}
inline void record_argument(Call& call, const float* three) {
    call.array(three, 3 * sizeof(float));
}
template <class S> void record_argument(Call& call, const Structs<S>& all) {
    call.structures(all.first, all.count, [](const S&) {});
}
template <class H> void record_argument(Call& call, const Handles<H>& all) {
    call.value(all.count);
    call.array(all.first, sizeof(H) * uint64_t{all.count});
}
template <class T> void record_argument(Call& call, const Out<T>& out) {
    call.output(out.first, out.count);
}
template <class T> void record_argument(Call& call, const Required<T>& required) {
    call.output(required.out);
}

inline void record_argument(Call& call, const lr_batch_desc* desc) {
    lr_batch_desc d{};
    if (!call.reads(desc)) return;
    copy_struct(desc, d);
    const recording::BatchRecord record{call.asset(*d.asset), d.capacity,     d.load_model, d.clock,    d.table_end,
                                        d.integrator,         d.damping_gain, d.noise_gain, d.variation};
    call.value(static_cast<uint32_t>(recording::Where::here));
    call.raw(&record, sizeof record);
}

// A desc of a wind source, with the samples of a grid.
struct SourceOf {
    const SourceType& type;
    const void* desc;
};
inline void record_argument(Call& call, const SourceOf& given) {
    if (!call.reads(given.desc)) return;
    call.value(static_cast<uint32_t>(recording::Where::here));
    call.value(given.type.bytes);
    call.value(given.type.size); // struct_size of this header
    call.raw(static_cast<const unsigned char*>(given.desc) + 4, given.type.bytes - 4);
    if (&given.type != &source_type::wind_grid) return;
    const SourceDesc d = source_of(given.type, given.desc);
    call.shared_array(d.samples, d.samples ? sizeof(float) * sample_count(d) : 0);
}

// Includes the arrays that each kind of collider uses.
inline void record_argument(Call& call, const Structs<lr_collider_desc>& all) {
    call.structures(all.first, all.count, [&](const lr_collider_desc& d) {
        const bool mesh = d.kind == LR_COLLIDER_MESH, field = d.kind == LR_COLLIDER_HEIGHTFIELD;
        call.shared_array(mesh || d.kind == LR_COLLIDER_HULL ? d.vertices : nullptr, 12 * uint64_t{d.vertex_count});
        call.shared_array(mesh ? d.indices : nullptr, 12 * uint64_t{d.triangle_count});
        call.shared_array(field ? d.heights : nullptr, 4 * uint64_t{d.counts[0]} * d.counts[1]);
    });
}
inline void record_argument(Call& call, const Snapshot& snapshot) {
    if (call.reads(snapshot.memory)) call.array(snapshot.memory, snapshot_bytes(snapshot.memory));
}
} // namespace lr::api
