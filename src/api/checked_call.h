// How a call on a world goes: its arguments are checked, other threads inside it are found, it is recorded where that was asked for, and the
// log says why it is refused. A function gives args(...) as it has them, and a lambda that takes the world and the types that it wants:
//
//   const S&, S&, const S*            a struct with a struct_size: copied in, written back, or null
//   Batch&, Body, Wind, ColliderSlot  what a handle stands for
//   Structs<S>, Handles<H>            an array
//   Triple                            three finite numbers
//   T&                                of Required(T*): a number or handle that comes out
//   T                                 all else, as it is
//
// They are checked from left to right.
#pragma once

#include "api/recorded_arguments.h"
#include "world/world.h"

#include <algorithm>
#include <tuple>

namespace lr::api {

// A call has looked at all that it was given, and changes the world next: a recording may read it as well. False where there is no memory to
// record it, and the call must be refused.
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

// An argument as it was given, as A, and as a lambda wants it, as P.
template <class A> struct Given {
    A given;
    Outcome take(const lr_world&) { return {}; }
    void finish() {} // after a call that was not refused
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

// The world is the caller's as long as this lives, if `status` is LR_OK.
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

void end_recording(lr_world& world, const char* why); // why: null for no message

template <class... A> std::tuple<A...> args(A... given) {
    return {given...};
}

// The parameters of a lambda behind the world.
template <class F> struct Wants : Wants<decltype(&F::operator())> {};
template <class F, class R, class W, class... P> struct Wants<R (F::*)(W&, P...) const> {
    template <class... A> static std::tuple<Taken<P, A>...> take(const A&... given) {
        return {Taken<P, A>{{given}}...};
    }
};

// Checks the arguments, and makes the call if they are fine. A lambda that returns nothing has succeeded.
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

// Whether a handle stands for a T.
template <class T, class H> int32_t is_valid(const lr_world* world, const char* function, H handle) {
    if (!world) return 0;
    const Entry entry(*world, function);
    return entry.status() == LR_OK && Taken<T, H>{{handle}}.take(*world).status == LR_OK ? 1 : 0;
}

// A call that changes nothing.
template <class F, class... A>
lr_status query(const lr_world* world, const char* function, const std::tuple<A...>& given, const F& f) {
    if (!world) return told(function, {LR_ERROR_NULL_ARGUMENT, "world is null"});
    const Entry entry(*world, function);
    return entry.status() == LR_OK ? carry_out(*world, function, given, f) : entry.status();
}

// A call that may change the world. One that names none of the caller's memory is recorded at once; another when the function says accepted(),
// or at the latest when it has succeeded: a call that is refused has perhaps read nothing, and is recorded without arguments.
template <class F, class... A>
lr_status change(lr_world* world, const char* function, const std::tuple<A...>& given, const F& f) {
    if (!world) return told(function, {LR_ERROR_NULL_ARGUMENT, "world is null"});
    const Entry entry(*world, function);
    if (entry.status() != LR_OK) return entry.status();
    recording::Recorder* const recorder = world->recorder;
    if (!recorder) return carry_out(*world, function, given, f);
    Call call(*recorder, function);
    const auto tell_all = [&](Call& c) { std::apply([&](const A&... one) { (tell(c, one), ...); }, given); };
    const auto record = [&] { return call.arguments(tell_all); };
    if (call.names_memory(tell_all))
        recorder->wait_for(record);
    else
        record();
    const lr_status status = carry_out(*world, function, given, f);
    if (status == LR_OK) recorder->accepted();
    recorder->wait_for_nothing();
    if (!call.recorded()) call.refused();
    call.result(tell_all, status, *world);
    if (recorder->failed()) end_recording(*world, "the recording has ended: its `write` refused");
    return status;
}

} // namespace lr::api
