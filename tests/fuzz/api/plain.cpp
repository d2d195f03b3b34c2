// Plain getters and setters of the header with any arguments; new ones are included automatically. A refusal for any reason must
// have changed nothing.
#include "fuzz/api/model.h"
#include "support/arguments.h"

namespace fuzz {
namespace {

using test::may;
using test::must;

#define LR_STRUCT(name, initial)                                                                                       \
    inline lr_status init(name* s, uint32_t size) {                                                                    \
        return LR_CALL(name##_init)(s, size);                                                                          \
    }
#include "../src/api/structs.inc"
#undef LR_STRUCT

struct Arguments {
    Fuzzer& f;
    World& w;
    lr_world* world;
    lr_batch batch = f.pick_batch(w, f.in.handle(0));
    lr_body body = f.pick_body(w, f.in.handle(0));
    lr_collider collider = f.pick_collider(w, f.in.handle(0));
    std::vector<std::unique_ptr<uint64_t[]>> kept = {};

    template <class T> T* memory() {
        kept.push_back(std::make_unique<uint64_t[]>(sizeof(T) / 8 + 1));
        return f.in.null(1) ? nullptr : reinterpret_cast<T*>(kept.back().get());
    }
    // With up to three changed words.
    template <class T> T* of() {
        kept.push_back(std::make_unique<uint64_t[]>(sizeof(T) / 8 + 1));
        auto* const s = reinterpret_cast<T*>(kept.back().get());
        if (init(s, sizeof(T)) != LR_OK) defect("an _init function", "its own size is refused");
        for (size_t i = 0; i < f.in.variant(); ++i) {
            const size_t at = 4 * (1 + f.in.value(2 * i) % (sizeof(T) / 4 - 1));
            const uint8_t byte = f.in.value(2 * i + 1);
            const uint32_t word = byte % 2 ? f.in.integer(byte) : std::bit_cast<uint32_t>(f.in.real(byte));
            std::memcpy(reinterpret_cast<unsigned char*>(s) + at, &word, sizeof word);
        }
        return f.in.null(1) ? nullptr : s;
    }
};

template <class A> auto changed(const A& argument, Fuzzer& f, size_t index) {
    const uint8_t byte = f.in.value(index % 6);
    if constexpr (std::is_same_v<A, int>)
        return f.in.integer(byte);
    else if constexpr (std::is_same_v<A, float>)
        return f.in.real(byte);
    else
        return argument;
}

template <class... P, class... A>
void run(Fuzzer& f, const char* name, lr_status (*function)(P...), std::tuple<A...> (*arguments)(Arguments&)) {
    World& w = f.world();
    Expected expected;
    for (int status = LR_ERROR_REENTRANT; status < LR_OK; ++status)
        if (status != LR_ERROR_INTERNAL) expected.may(status);
    Call call(f, w, name, expected);
    Arguments s{f, w, call.world()};
    const auto all = [&]<size_t... I>(const std::tuple<A...>& given, std::index_sequence<I...>) {
        return std::tuple(changed(std::get<I>(given), f, I)...);
    }
    (arguments(s), std::index_sequence_for<A...>());
    w.state.wild = true;
    call.ended(test::call(function, all));
}

struct Function {
    const char* name;
    void (*run)(Fuzzer&, const char* name);
};
#undef LR_CALL
#define LR_CALL(name, ...)
#define LR_PLAIN_CALL(name, ...)                                                                                       \
    {#name, [](Fuzzer& f, const char* own_name) {                                                                      \
         run(                                                                                                          \
             f, own_name, &(name), +[](Arguments& s) { return std::tuple(__VA_ARGS__); });                             \
     }},
const Function functions[] = {
#include "api/calls.inc"
};

} // namespace

void call_plain(Fuzzer& f) {
    if (!f.world().at) return;
    uint32_t sum = 0;
    for (size_t i = 0; i < 6; ++i) sum = 31 * sum + f.in.value(i);
    const Function& function = functions[sum % std::size(functions)];
    note_reached(function.name);
    function.run(f, function.name);
}

} // namespace fuzz
