// The course of a call on a world: detect concurrent use, record the call if a recording runs, check the arguments, log a refusal. An exported
// function passes args(...), its unchanged arguments, and a lambda that takes the world and the converted arguments:
//   const S&, S&, const S*                   a struct with a struct_size: input, output, optional input
//   Batch&, Body, WindSource&, ColliderSlot  the object of a handle
//   Structs<S>, Handles<H>                   an array
//   Triple                                   three finite numbers
//   T&                                       Required(T*): an output number or handle
//   T                                        any other type, passed through
//
// Arguments are checked from left to right. `function` is the name of the exported function, by default.
#pragma once

#include "api/check_arguments.h"
#include "environment/wind_source.h"
#include "recording/recorder.h"
#include "world/world.h"

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace lr::api {

template <class T>
concept Handle = requires(T handle) {
    handle.id;
};

// An array of structs with a struct_size, which is that of the first: all must have the same. A call accepts all elements or none: it checks each
// before it uses the first.
template <Sized S> struct Structs {
    const S* first;
    uint32_t count;
    const S* at(uint32_t i) const {
        return reinterpret_cast<const S*>(reinterpret_cast<const unsigned char*>(first) +
                                          uint64_t{first->struct_size} * i);
    }
    template <class Check> Outcome check(Check&& each) const { // stops at the first refused element
        S one{};
        for (uint32_t i = 0; i < count; ++i) {
            // First: an element with a larger struct_size than the stride would be read past the array's end.
            uint32_t size = 0;
            std::memcpy(&size, at(i), sizeof size);
            Outcome outcome = size == first->struct_size ? read_struct(at(i), one) : LR_ERROR_STRUCT_SIZE;
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

// A function object by reference: what is common to all calls is compiled once.
template <class Signature> class Ref;
template <class R, class... A> class Ref<R(A...)> {
public:
    template <class F>
    Ref(const F& f)
        : object_(&f), call_([](const void* object, A... a) -> R { return (*static_cast<const F*>(object))(a...); }) {}
    R operator()(A... a) const { return call_(object_, a...); }

private:
    const void* object_;
    R (*call_)(const void*, A...);
};
class Call;
using Record = Ref<void(Call&)>; // calls record_argument() for each argument

// Writes one call to a recording: its arguments before it runs, its outputs afterwards. record_argument() of each argument runs in up to four passes:
// ask (does the call pass pointers?), survey (write large arrays as records of their own), write (the arguments), output (the results). Only survey
// and write read the caller's memory; they run after accepted(), because pointers are not validated before.
class Call {
public:
    enum class Pass { ask, survey, write, output };

    Call(recording::Recorder& recorder, const char* function, recording::Kind kind = recording::Kind::call)
        : recorder_(&recorder), op_(recording::op_of(function)), kind_(kind) {}

    // Whether the call passes non-null pointers.
    bool names_memory(Record record) {
        record(*this);
        return names_memory_;
    }
    // False when out of memory for the data behind the pointers. The call must then be refused: a replay could not continue.
    bool arguments(Record record) {
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
    void result(Record record, lr_status status, const lr_world& world) {
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
    template <class S, class Each> void structures(const Structs<S>& all, Each&& each) {
        value(all.count);
        if (!reads(all.count != 0 ? all.first : nullptr)) return;
        value(static_cast<uint32_t>(recording::Where::here));
        S one;
        for (uint32_t i = 0; i < all.count; ++i) {
            copy_struct(all.at(i), one);
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
    call.structures(all, [](const S&) {});
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
    call.structures(all, [&](const lr_collider_desc& d) {
        const bool mesh = d.kind == LR_COLLIDER_MESH, field = d.kind == LR_COLLIDER_HEIGHTFIELD;
        call.shared_array(mesh || d.kind == LR_COLLIDER_HULL ? d.vertices : nullptr, 12 * uint64_t{d.vertex_count});
        call.shared_array(mesh ? d.indices : nullptr, 12 * uint64_t{d.triangle_count});
        call.shared_array(field ? d.heights : nullptr, 4 * uint64_t{d.counts[0]} * d.counts[1]);
    });
}
inline void record_argument(Call& call, const Snapshot& snapshot) {
    if (call.reads(snapshot.memory)) call.array(snapshot.memory, snapshot_bytes(snapshot.memory));
}

// Called by a function after its checks and before its first change of the world, from when a recording can read the arguments. False: no memory for
// the recording, so the call must be refused.
inline bool accepted(const lr_world& world) {
    return !world.recorder || world.recorder->accepted();
}

struct Body {
    Batch& batch;
    uint32_t index;
};
struct ColliderSlot {
    uint32_t slot;
};
using Triple = const float (&)[3];

// Given<A> holds an argument as passed. Taken<P, A> converts it to the lambda's parameter type P.
template <class A> struct Given {
    A given;
    Outcome take(const lr_world&) { return {}; }
    void finish() {} // after a successful call
};
template <class P, class A> struct Taken : Given<A> {
    P get() { return this->given; }
};
template <class B>
requires std::is_same_v<std::remove_const_t<B>, Batch>
struct Taken<B&, lr_batch> : Given<lr_batch> {
    B* batch = nullptr;
    Outcome take(const lr_world& world) {
        batch = world.find(given);
        return batch ? LR_OK : LR_ERROR_STALE_BATCH;
    }
    B& get() { return *batch; }
};
template <> struct Taken<Body, lr_body> : Given<lr_body> {
    Batch* batch = nullptr;
    uint32_t index = 0;
    Outcome take(const lr_world& world) {
        batch = world.find(given, index);
        return batch ? LR_OK : LR_ERROR_STALE_BODY;
    }
    Body get() { return {*batch, index}; }
};
template <> struct Taken<const WindSource&, lr_wind_source> : Given<lr_wind_source> {
    const WindSource* source = nullptr;
    Outcome take(const lr_world& world) {
        source = world.wind.find(given);
        return source ? LR_OK : LR_ERROR_STALE_WIND_SOURCE;
    }
    const WindSource& get() { return *source; }
};
template <> struct Taken<ColliderSlot, lr_collider> : Given<lr_collider> {
    uint32_t slot = 0;
    Outcome take(const lr_world& world) { return world.colliders.find(given, slot) ? LR_OK : LR_ERROR_STALE_COLLIDER; }
    ColliderSlot get() { return {slot}; }
};
template <Sized S> struct Taken<const S&, const S*> : Given<const S*> {
    S copy{};
    Outcome take(const lr_world&) { return read_struct(this->given, copy); }
    const S& get() { return copy; }
};
template <Sized S> struct Taken<const S*, const S*> : Given<const S*> {
    S copy{};
    Outcome take(const lr_world&) { return this->given ? read_struct(this->given, copy) : LR_OK; }
    const S* get() { return this->given ? &copy : nullptr; }
};
template <Sized S> struct Taken<S&, S*> : Given<S*> {
    S result{};
    Outcome take(const lr_world&) { return check_size(this->given); }
    S& get() { return result; }
    void finish() { write_struct(result, this->given); }
};
template <> struct Taken<const SourceDesc&, SourceOf> : Given<SourceOf> {
    SourceDesc source{};
    Outcome take(const lr_world&) {
        const lr_status status = check_size(given.desc, given.type.size, given.type.size);
        if (status == LR_OK) source = source_of(given.type, given.desc);
        return status;
    }
    const SourceDesc& get() { return source; }
};
template <> struct Taken<Triple, const float*> : Given<const float*> {
    float copy[3] = {};
    Outcome take(const lr_world&) {
        if (!given) return LR_ERROR_NULL_ARGUMENT;
        std::copy(given, given + 3, copy);
        return lr::finite(copy) ? LR_OK : LR_ERROR_NOT_FINITE;
    }
    Triple get() { return copy; }
};
template <class T> struct Taken<T&, Required<T>> : Given<Required<T>> {
    Outcome take(const lr_world&) { return this->given.out ? LR_OK : LR_ERROR_NULL_ARGUMENT; }
    T& get() { return *this->given.out; }
};
template <class Array>
requires requires(Array a) {
    a.count;
}
struct Taken<const Array&, Array> : Given<Array> {
    Outcome take(const lr_world&) {
        return this->given.count == 0 || this->given.first ? LR_OK : LR_ERROR_NULL_ARGUMENT;
    }
    const Array& get() { return this->given; }
};

// Reserves the world for this thread during its lifetime, if `status` is LR_OK.
class Entry {
public:
    Entry(const lr_world& world, const char* function)
        : call_guard_(world.call_guard), checked_(call_guard_.checked()),
          status_(checked_ ? enter(world, function) : LR_OK) {}
    ~Entry() {
        if (checked_ && status_ == LR_OK) call_guard_.leave();
    }
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    lr_status status() const { return status_; }

private:
    CallGuard& call_guard_;
    bool checked_;
    lr_status status_;
};

void end_recording(lr_world& world, const char* why); // why: a warning for the log, or null

template <class... A> std::tuple<A...> args(A... given) {
    return {given...};
}

// The parameters of a lambda after the world.
template <class F> struct Wants : Wants<decltype(&F::operator())> {};
template <class F, class R, class W, class... P> struct Wants<R (F::*)(W&, P...) const> {
    template <class... A> static std::tuple<Taken<P, A>...> take(const A&... given) {
        return {Taken<P, A>{{given}}...};
    }
};

// Checks the arguments and calls the lambda if they are valid. A lambda that returns void cannot fail.
template <class W, class F, class... A> Outcome carry_out(W& world, const std::tuple<A...>& given, const F& f) {
    auto all = std::apply([](const A&... one) { return Wants<F>::take(one...); }, given);
    const auto call = [&](auto&... taken) {
        Outcome outcome;
        if (((outcome = taken.take(world)).refused() || ...)) return outcome;
        if constexpr (std::is_void_v<decltype(f(world, taken.get()...))>)
            f(world, taken.get()...);
        else
            outcome = f(world, taken.get()...);
        if (!outcome.refused()) (taken.finish(), ...);
        return outcome;
    };
    return std::apply(call, all);
}

// Whether a handle is valid.
template <class T, class H>
int32_t is_valid(const lr_world* world, H handle, const char* function = __builtin_FUNCTION()) {
    if (!world) return 0;
    const Entry entry(*world, function);
    return entry.status() == LR_OK && Taken<T, H>{{handle}}.take(*world).status == LR_OK ? 1 : 0;
}

// A call that does not change the world; recordings omit it.
lr_status query(const lr_world* world, const char* function, Ref<Outcome()> body);
template <class F, class... A>
lr_status query(const lr_world* world, const std::tuple<A...>& given, const F& f,
                const char* function = __builtin_FUNCTION()) {
    return query(world, function, [&] { return carry_out(*world, given, f); });
}

// A call that can change the world. Without pointer arguments it is recorded at once. With pointers it is recorded by accepted(), or at the latest on
// success. A refused call, whose pointers can be invalid, is recorded without arguments.
lr_status change(lr_world* world, const char* function, Record record, Ref<Outcome()> body);
template <class F, class... A>
lr_status change(lr_world* world, const std::tuple<A...>& given, const F& f,
                 const char* function = __builtin_FUNCTION()) {
    const auto record = [&](Call& call) {
        std::apply([&](const A&... all) { (record_argument(call, all), ...); }, given);
    };
    return change(world, function, record, [&] { return carry_out(*world, given, f); });
}
} // namespace lr::api
