// Every call of the header, with each pointer null and each struct in every size: 0, too small, exact, larger with a tail of zeros,
// larger with another tail, absurd.
#include "support/every_call.h"

#include <algorithm>
#include <functional>
#include <optional>

using namespace test;

namespace {

// Structs that have grown since their first release.
template <class T> constexpr auto first_size = static_cast<uint32_t>(sizeof(T));
template <> constexpr auto first_size<lr_aerodynamics> = static_cast<uint32_t>(offsetof(lr_aerodynamics, plate_lift));

struct Sizes {
    uint32_t first, now;

    // From callers built with this header, with an older one, or with a newer one whose structs are larger.
    std::vector<uint32_t> good() const { return {first, now, now + 4, now + 64}; }
    // No caller has these.
    std::vector<uint32_t> bad() const {
        std::vector<uint32_t> sizes = {65537, 0x7fffffff, 0xffffffff};
        for (uint32_t size = 0; size < now; ++size)
            if (size != first) sizes.push_back(size);
        return sizes;
    }
};
template <class T> constexpr Sizes sizes_of = {first_size<T>, static_cast<uint32_t>(sizeof(T))};

// A caller's struct of a given size, at the end of the caller's memory: the library must not touch bytes behind it.
class Caller {
public:
    Caller(const void* from, uint32_t from_size, uint32_t size, unsigned char tail = 0)
        : words_(size / 8 + 16), size_(size) {
        std::memset(words_.data(), canary, words_.size() * 8);
        std::memset(words_.data(), tail, size);
        std::memcpy(words_.data(), from, std::min(size, from_size));
        std::memcpy(words_.data(), &size, sizeof size);
        before_ = words_;
    }
    void* data() { return words_.data(); }
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

// The checks are no templates, which the compiler would translate for each of some 300 arguments.
void check_init(Sizes sizes, const std::function<lr_status(void*, uint32_t)>& function) {
    CHECK(function(nullptr, sizes.now) == LR_ERROR_NULL_ARGUMENT);
    const std::vector<unsigned char> garbage(sizes.now, 0x5a);
    for (uint32_t size : sizes.bad()) {
        CAPTURE(size);
        Caller caller(garbage.data(), sizes.now, sizes.now);
        CHECK(function(caller.data(), size) == LR_ERROR_STRUCT_SIZE);
        CHECK(caller.unchanged());
    }
    // The part unknown to this library becomes zero.
    for (uint32_t size : sizes.good()) {
        CAPTURE(size);
        Caller caller(garbage.data(), sizes.now, size, 0x5a);
        CHECK(function(caller.data(), size) == LR_OK);
        CHECK(caller.says_its_size());
        CHECK(caller.nothing_behind_is_written());
        if (size > sizes.now) CHECK(caller.zero_from(sizes.now));
    }
}

// A call with valid arguments, of which one pointer can be exchanged.
struct AnyCall {
    virtual ~AnyCall() = default;
    virtual void arrange(Stage& stage) = 0;
    virtual const void* pointer(size_t place) const = 0;
    virtual lr_status with(size_t place, void* instead) const = 0;
};
template <class Function, class... A> struct Call final : AnyCall {
    using Arguments = std::tuple<A...>;

    Call(Function function, Arguments (*arguments)(Stage&)) : function_(function), arguments_(arguments) {}
    void arrange(Stage& stage) override { given_.emplace(arguments_(stage)); }
    const void* pointer(size_t place) const override {
        return std::apply(
            [&](const A&... all) {
                size_t i = 0;
                const void* found = nullptr;
                ((found = i++ == place ? address(all) : found), ...);
                return found;
            },
            *given_);
    }
    lr_status with(size_t place, void* instead) const override { return call(function_, *given_, place, instead); }

private:
    template <class T> static const void* address(const T& one) {
        if constexpr (Pointer<T>)
            return one.pointer;
        else
            return nullptr;
    }
    Function function_;
    Arguments (*arguments_)(Stage&);
    std::optional<Arguments> given_;
};

// The tail of a struct must be zeros, and results are written to its front alone.
void check_sizes(AnyCall& one, size_t place, Sizes sizes) {
    Stage stage;
    one.arrange(stage);
    const auto* const valid = static_cast<const unsigned char*>(one.pointer(place));
    for (uint32_t size : sizes.bad()) {
        // On the heap, of exactly its size: AddressSanitizer detects reads past the end.
        std::vector<unsigned char> bad(valid, valid + sizes.now);
        std::memcpy(bad.data(), &size, sizeof size);
        const std::vector<unsigned char> before = bad;
        CAPTURE(size);
        CHECK(one.with(place, bad.data()) == LR_ERROR_STRUCT_SIZE);
        CHECK(bad == before);
    }
    for (size_t past : {0u, 1u, 63u}) {
        Caller caller(valid, sizes.now, sizes.now + 64);
        caller.byte(sizes.now + past) = 1;
        caller.remember();
        CAPTURE(past);
        CHECK(one.with(place, caller.data()) == LR_ERROR_STRUCT_SIZE);
        CHECK(caller.unchanged());
    }
    for (uint32_t size : sizes.good()) {
        CAPTURE(size);
        Stage fresh;
        one.arrange(fresh);
        Caller caller(one.pointer(place), sizes.now, size);
        CHECK(one.with(place, caller.data()) == LR_OK);
        CHECK(caller.says_its_size());
        CHECK(caller.nothing_behind_is_written());
        if (size > sizes.now) CHECK(caller.zero_from(sizes.now));
    }
}

void check_null(AnyCall& one, size_t place, bool is_needed) {
    Stage stage;
    one.arrange(stage);
    const uint64_t before = hash_of(stage.place);
    const lr_status status = one.with(place, nullptr);
    CAPTURE(place);
    CHECK((status == LR_ERROR_NULL_ARGUMENT) == is_needed);
    if (is_needed) CHECK(hash_of(stage.place) == before);
}

template <class A> void check_argument(AnyCall& one, size_t place, bool nulls) {
    if constexpr (Pointer<A>) {
        using T = std::remove_pointer_t<decltype(A::pointer)>;
        if (nulls) check_null(one, place, needed<A>);
        if constexpr (Sized<T>)
            if (!nulls) check_sizes(one, place, sizes_of<T>);
    }
}

template <class... P, class... A>
void check_call(lr_status (*function)(P...), std::tuple<A...> (*arguments)(Stage&), bool nulls) {
    static_assert(sizeof...(P) == sizeof...(A));
    Call<lr_status (*)(P...), A...> one(function, arguments);
    size_t place = 0;
    (check_argument<A>(one, place++, nulls), ...);
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
#define LR_STRUCT(name, initial)                                                                                       \
    check_init(sizes_of<name>, [](void* s, uint32_t size) { return name##_init(static_cast<name*>(s), size); });
#include "../../src/api/structs.inc"
#undef LR_STRUCT
}
