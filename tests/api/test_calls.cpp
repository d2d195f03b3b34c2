// Every call of the header, with each pointer null and each struct in every size: 0, too small, exact, larger with a tail of zeros,
// larger with another tail, absurd.
#include "support/every_call.h"

#include <algorithm>

using namespace test;

namespace {

// Structs that have grown since their first release.
template <class T> constexpr auto first_size = static_cast<uint32_t>(sizeof(T));
template <> constexpr auto first_size<lr_aerodynamics> = static_cast<uint32_t>(offsetof(lr_aerodynamics, plate_lift));

// Sizes from callers built with this header, with an older one, or with a newer one whose structs are larger.
template <class T> std::vector<uint32_t> good_sizes() {
    constexpr auto size = static_cast<uint32_t>(sizeof(T));
    return {first_size<T>, size, size + 4, size + 64};
}

// No caller has these sizes.
template <class T> std::vector<uint32_t> bad_sizes() {
    std::vector<uint32_t> sizes = {65537, 0x7fffffff, 0xffffffff};
    for (uint32_t size = 0; size < sizeof(T); ++size)
        if (size != first_size<T>) sizes.push_back(size);
    return sizes;
}

// A caller's struct of a given size, at the end of the caller's memory: the library must not touch bytes behind it.
class Caller {
public:
    template <class T>
    Caller(const T& from, uint32_t size, unsigned char tail = 0) : words_(size / 8 + 16), size_(size) {
        std::memset(words_.data(), canary, words_.size() * 8);
        std::memset(words_.data(), tail, size);
        std::memcpy(words_.data(), static_cast<const void*>(&from), std::min<size_t>(size, sizeof(T)));
        std::memcpy(words_.data(), &size, sizeof size);
        before_ = words_;
    }
    template <class T> T* as() { return reinterpret_cast<T*>(words_.data()); }
    unsigned char& byte(size_t i) { return bytes()[i]; }
    void remember() { before_ = words_; }
    bool unchanged() const { return words_ == before_; }
    bool says_its_size() { return std::memcmp(bytes(), &size_, sizeof size_) == 0; }
    bool nothing_behind_is_written() {
        return std::all_of(bytes() + size_, bytes() + words_.size() * 8, [](unsigned char b) { return b == canary; });
    }
    bool zero_from(size_t first) {
        return std::all_of(bytes() + first, bytes() + size_, [](unsigned char b) { return b == 0; });
    }

private:
    static constexpr unsigned char canary = 0x5a;
    unsigned char* bytes() { return reinterpret_cast<unsigned char*>(words_.data()); }
    std::vector<uint64_t> words_, before_;
    uint32_t size_;
};

template <class T> void check_init(lr_status (*function)(T*, uint32_t)) {
    CHECK(function(nullptr, sizeof(T)) == LR_ERROR_NULL_ARGUMENT);
    T garbage;
    std::memset(static_cast<void*>(&garbage), 0x5a, sizeof garbage);
    for (uint32_t size : bad_sizes<T>()) {
        CAPTURE(size);
        Caller caller(garbage, sizeof(T));
        CHECK(function(caller.as<T>(), size) == LR_ERROR_STRUCT_SIZE);
        CHECK(caller.unchanged());
    }
    // The part unknown to this library becomes zero.
    for (uint32_t size : good_sizes<T>()) {
        CAPTURE(size);
        Caller caller(garbage, size, 0x5a);
        CHECK(function(caller.as<T>(), size) == LR_OK);
        CHECK(caller.says_its_size());
        CHECK(caller.nothing_behind_is_written());
        if (size > sizeof(T)) CHECK(caller.zero_from(sizeof(T)));
    }
}

// The tail of a struct must be zeros, and results are written to its front alone.
template <size_t K, Sized T, class Function, class Arguments>
void check_sizes(Function function, Arguments (*arguments)(Stage&)) {
    Stage stage;
    const Arguments given = arguments(stage);
    const T good = *std::get<K>(given).pointer;
    for (uint32_t size : bad_sizes<T>()) {
        // On the heap, of exactly its size: AddressSanitizer detects reads past the end.
        const auto bad = std::make_unique<T>(good);
        bad->struct_size = size;
        const T before = *bad;
        CAPTURE(size);
        CHECK(call<K>(function, given, bad.get()) == LR_ERROR_STRUCT_SIZE);
        CHECK(std::memcmp(bad.get(), &before, sizeof before) == 0);
    }
    for (uint32_t size : good_sizes<T>()) {
        CAPTURE(size);
        Stage fresh;
        const Arguments others = arguments(fresh);
        Caller caller(*std::get<K>(others).pointer, size);
        CHECK(call<K>(function, others, caller.as<T>()) == LR_OK);
        CHECK(caller.says_its_size());
        CHECK(caller.nothing_behind_is_written());
        if (size > sizeof(T)) CHECK(caller.zero_from(sizeof(T)));
    }
    for (size_t at : {sizeof(T), sizeof(T) + 1, sizeof(T) + 63}) {
        Caller caller(good, sizeof(T) + 64);
        caller.byte(at) = 1;
        caller.remember();
        CAPTURE(at);
        CHECK(call<K>(function, given, caller.as<T>()) == LR_ERROR_STRUCT_SIZE);
        CHECK(caller.unchanged());
    }
}

template <size_t K, class A, class Function, class Arguments>
void check_null(Function function, Arguments (*arguments)(Stage&)) {
    if constexpr (Pointer<A>) {
        Stage stage;
        const Arguments given = arguments(stage);
        const uint64_t before = hash_of(stage.place);
        const lr_status status = call<K>(function, given, nullptr);
        CAPTURE(K);
        CHECK((status == LR_ERROR_NULL_ARGUMENT) == needed<A>);
        if (needed<A>) CHECK(hash_of(stage.place) == before);
    }
}

template <class T> T* pointer_of(Must<T>*);
template <class T> T* pointer_of(May<T>*);
template <class A> void* pointer_of(A*);

template <class... P, class... A>
void check_call(lr_status (*function)(P...), std::tuple<A...> (*arguments)(Stage&), bool nulls) {
    static_assert(sizeof...(P) == sizeof...(A));
    const auto one = [&]<size_t K, class Of>(std::integral_constant<size_t, K>, Of*) {
        using T = std::remove_pointer_t<decltype(pointer_of(static_cast<Of*>(nullptr)))>;
        if (nulls) check_null<K, Of>(function, arguments);
        if constexpr (Sized<T>)
            if (!nulls) check_sizes<K, T>(function, arguments);
    };
    [&]<size_t... I>(std::index_sequence<I...>) {
        (one(std::integral_constant<size_t, I>(), static_cast<A*>(nullptr)), ...);
    }
    (std::index_sequence_for<A...>());
}

void check_all_calls(bool nulls) {
#define LR_CALL(name, ...)                                                                                             \
    SUBCASE(#name) {                                                                                                   \
        check_call(                                                                                                    \
            &(name), +[](Stage& s) { return std::tuple(__VA_ARGS__); }, nulls);                                        \
    }
#define LR_PLAIN_CALL LR_CALL
#include "api/calls.inc"
#undef LR_PLAIN_CALL
#undef LR_CALL
}

} // namespace

TEST_CASE("every pointer that must be given is asked for, and no other") {
    check_all_calls(true);
}

TEST_CASE("every function checks struct_size and the tail of a larger struct") {
    check_all_calls(false);
}

TEST_CASE("every init function takes exact and larger sizes, refuses others, and writes no further") {
#define LR_STRUCT(name, initial) check_init<name>(&(name##_init));
#include "../../src/api/structs.inc"
#undef LR_STRUCT
}
