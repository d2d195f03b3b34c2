// Argument types of calls, and how each is recorded: for calls of the host, and for the calls that set up a recording's initial state.
#pragma once

#include "api/recorded_call.h"
#include "environment/wind_source.h"
#include "world/world.h"

namespace lr::api {

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
void tell(Call& call, T v) {
    call.value(v);
}
template <Handle H> void tell(Call& call, H handle) {
    call.value(handle.id);
}
template <Sized S> void tell(Call& call, const S* s) {
    call.structure(s);
}
inline void tell(Call& call, const float* three) {
    call.array(three, 3 * sizeof(float));
}
template <class S> void tell(Call& call, const Structs<S>& all) {
    call.structures(all.first, all.count);
}
template <class H> void tell(Call& call, const Handles<H>& all) {
    call.value(all.count);
    call.array(all.first, sizeof(H) * uint64_t{all.count});
}
template <class T> void tell(Call& call, const Out<T>& out) {
    call.output(out.first, out.count);
}
template <class T> void tell(Call& call, const Required<T>& required) {
    call.output(required.out);
}

inline void tell(Call& call, const lr_batch_desc* desc) {
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
inline void tell(Call& call, const SourceOf& given) {
    if (!call.reads(given.desc)) return;
    call.value(static_cast<uint32_t>(recording::Where::here));
    call.value(given.type.bytes);
    call.value(given.type.size); // struct_size of this header
    call.raw(static_cast<const unsigned char*>(given.desc) + 4, given.type.bytes - 4);
    if (&given.type != &source_type::wind_grid) return;
    const SourceDesc d = source_of(given.type, given.desc);
    call.shared_array(d.samples, d.samples ? sizeof(float) * sample_count(d) : 0);
}

// With the arrays that each kind of collider uses.
inline void tell(Call& call, const Structs<lr_collider_desc>& all) {
    call.structures(all.first, all.count, [&](const lr_collider_desc& d) {
        const bool mesh = d.kind == LR_COLLIDER_MESH, field = d.kind == LR_COLLIDER_HEIGHTFIELD;
        call.shared_array(mesh || d.kind == LR_COLLIDER_HULL ? d.vertices : nullptr, 12 * uint64_t{d.vertex_count});
        call.shared_array(mesh ? d.indices : nullptr, 12 * uint64_t{d.triangle_count});
        call.shared_array(field ? d.heights : nullptr, 4 * uint64_t{d.counts[0]} * d.counts[1]);
    });
}
inline void tell(Call& call, const Snapshot& snapshot) {
    if (call.reads(snapshot.memory)) call.array(snapshot.memory, snapshot_bytes(snapshot.memory));
}
} // namespace lr::api
