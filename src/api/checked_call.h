// The course of a call on a world: detect concurrent use, record the call if a recording runs, check the arguments, log a refusal. An exported
// function passes args(...), its unchanged arguments, and a lambda that takes the world and the converted arguments:
//   const S&, S&, const S*            a struct with a struct_size: input, output, optional input
//   Batch&, Body, Wind, ColliderSlot  the object of a handle
//   Structs<S>, Handles<H>            an array
//   Triple                            three finite numbers
//   T&                                Required(T*): an output number or handle
//   T                                 any other type, passed through
//
// Arguments are checked from left to right.
#pragma once

#include "api/recorded_call.h"
#include "world/world.h"

#include <algorithm>
#include <tuple>

namespace lr::api {

// Called by a function after its checks and before its first change of the world, from when a recording can read the arguments. False: no memory for
// the recording, so the call must be refused.
inline bool accepted(const lr_world& world) {
    return !world.recorder || world.recorder->accepted();
}

struct Body {
    Batch& batch;
    uint32_t index;
};
struct Wind {
    lr_wind_source source;
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
template <> struct Taken<Wind, lr_wind_source> : Given<lr_wind_source> {
    Outcome take(const lr_world& world) { return world.wind.find(given) ? LR_OK : LR_ERROR_STALE_WIND_SOURCE; }
    Wind get() { return {given}; }
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
        const lr_status status = check_size(given.desc, given.type.size);
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
template <class W, class F, class... A>
lr_status carry_out(W& world, const char* function, const std::tuple<A...>& given, const F& f) {
    const FloatMode mode;
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
    const char* why = nullptr;
    const lr_status status = guarded([&] {
        auto all = std::apply([](const A&... one) { return Wants<F>::take(one...); }, given);
        const Outcome outcome = std::apply(call, all);
        why = outcome.why;
        return outcome.status;
    });
    if (status != LR_OK) world.log(LR_LOG_ERROR, function, why ? why : lr_status_string(status));
    return status;
}

// Whether a handle is valid.
template <class T, class H> int32_t is_valid(const lr_world* world, const char* function, H handle) {
    if (!world) return 0;
    const Entry entry(*world, function);
    return entry.status() == LR_OK && Taken<T, H>{{handle}}.take(*world).status == LR_OK ? 1 : 0;
}

// A call that does not change the world; recordings omit it.
template <class F, class... A>
lr_status query(const lr_world* world, const char* function, const std::tuple<A...>& given, const F& f) {
    if (!world) return note_refusal(function, {LR_ERROR_NULL_ARGUMENT, "world is null"});
    const Entry entry(*world, function);
    return entry.status() == LR_OK ? carry_out(*world, function, given, f) : entry.status();
}

// A call that can change the world. Without pointer arguments it is recorded at once. With pointers it is recorded by accepted(), or at the latest on
// success. A refused call, whose pointers can be invalid, is recorded without arguments.
template <class F, class... A>
lr_status change(lr_world* world, const char* function, const std::tuple<A...>& given, const F& f) {
    if (!world) return note_refusal(function, {LR_ERROR_NULL_ARGUMENT, "world is null"});
    const Entry entry(*world, function);
    if (entry.status() != LR_OK) return entry.status();
    recording::Recorder* const recorder = world->recorder;
    if (!recorder) return carry_out(*world, function, given, f);
    Call call(*recorder, function);
    const auto record_all = [&](Call& c) {
        std::apply([&](const A&... all) { (record_argument(c, all), ...); }, given);
    };
    const auto record = [&] { return call.arguments(record_all); };
    if (call.names_memory(record_all))
        recorder->wait_for(record);
    else
        record();
    const lr_status status = carry_out(*world, function, given, f);
    if (status == LR_OK) recorder->accepted();
    recorder->wait_for_nothing();
    if (!call.recorded()) call.refused();
    call.result(record_all, status, *world);
    if (recorder->failed()) end_recording(*world, "the recording has ended: its `write` returned an error");
    return status;
}
} // namespace lr::api
