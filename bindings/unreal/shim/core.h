// Stand-ins for the parts of Unreal's Core that the plugin uses: the same names and signatures, in new, short code. With them a
// compiler checks the plugin's sources without the engine, and tests run them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using int8 = std::int8_t;
using int16 = std::int16_t;
using int32 = std::int32_t;
using int64 = long long; // as in the engine, even if std::int64_t is long
using uint8 = std::uint8_t;
using uint16 = std::uint16_t;
using uint32 = std::uint32_t;
using uint64 = unsigned long long;
using SIZE_T = std::size_t;
using TCHAR = char16_t; // as on Unreal's Linux
#define TEXT_PASTE(X) u##X
#define TEXT(X) TEXT_PASTE(X)
#define WITH_EDITOR 1
#define WITH_EDITORONLY_DATA 1
#define UE_DOUBLE_PI 3.141592653589793238
#define FORCEINLINE inline

std::u16string ShimWiden(const std::string& Text);
std::string ShimNarrow(const std::u16string& Text);

namespace ESearchCase {
enum Type { CaseSensitive, IgnoreCase };
}

template <typename T> std::remove_reference_t<T>&& MoveTemp(T&& Value) {
    return std::move(Value);
}

template <typename T> struct TNumericLimits {
    static constexpr T Lowest() { return std::numeric_limits<T>::lowest(); }
    static constexpr T Max() { return std::numeric_limits<T>::max(); }
};

struct FMath {
    template <typename T> static constexpr T Min(T A, T B) { return A < B ? A : B; }
    template <typename T> static constexpr T Max(T A, T B) { return A > B ? A : B; }
    template <typename T> static constexpr T Clamp(T X, T Low, T High) { return X < Low ? Low : X < High ? X : High; }
    template <typename T> static constexpr T DivideAndRoundUp(T Dividend, T Divisor) {
        return (Dividend + Divisor - 1) / Divisor;
    }
    static double Sqrt(double X) { return std::sqrt(X); }
    static double Cos(double X) { return std::cos(X); }
    static double Sin(double X) { return std::sin(X); }
    static double Pow(double A, double B) { return std::pow(A, B); }
    static int32 FloorToInt32(double X) { return static_cast<int32>(std::floor(X)); }
    static int32 CeilToInt32(float X) { return static_cast<int32>(std::ceil(X)); }
};

class FString {
public:
    FString() = default;
    FString(const TCHAR* Text) : Data(Text != nullptr ? Text : u"") {}
    explicit FString(std::u16string Text) : Data(std::move(Text)) {}

    const TCHAR* operator*() const { return Data.c_str(); }
    bool IsEmpty() const { return Data.empty(); }
    int32 Len() const { return static_cast<int32>(Data.size()); }
    FString& operator+=(const FString& Other) { return Data += Other.Data, *this; }
    friend FString operator+(const FString& A, const TCHAR* B) { return FString(A.Data + B); }
    bool Equals(const FString& Other, ESearchCase::Type Case = ESearchCase::CaseSensitive) const;
    bool operator==(const FString& Other) const { return Data == Other.Data; }

    template <typename FmtType, typename... Types> static FString Printf(const FmtType& Fmt, Types... Args) {
        static_assert(std::is_array_v<FmtType>, "Formatting string must be a TCHAR array.");
        static_assert((... && (std::is_arithmetic_v<Types> || std::is_enum_v<Types> || std::is_pointer_v<Types>)),
                      "Invalid argument type passed to FString::Printf");
        return Format(Fmt, {FArgument(Args)...});
    }

private:
    struct FArgument {
        template <typename T> explicit FArgument(T Value) {
            if constexpr (std::is_floating_point_v<T>) {
                Kind = 'f', Real = Value;
            } else if constexpr (std::is_same_v<T, const TCHAR*> || std::is_same_v<T, TCHAR*>) {
                Kind = 's', Pointer = Value;
            } else if constexpr (std::is_pointer_v<T>) {
                Kind = 'p';
            } else if constexpr (std::is_signed_v<T>) {
                Kind = 'd', Integer = static_cast<int64>(Value);
            } else {
                Kind = 'u', Integer = static_cast<int64>(Value);
            }
        }
        char Kind = 0;
        double Real = 0.0;
        int64 Integer = 0;
        const TCHAR* Pointer = nullptr;
    };
    // Ends the program if a conversion does not fit its argument: the engine refuses such formats at compile time.
    static FString Format(const TCHAR* Fmt, std::initializer_list<FArgument> Arguments);

    std::u16string Data;
};

struct FShimWide {
    std::u16string Text;
    operator const TCHAR*() const { return Text.c_str(); }
    const TCHAR* Get() const { return Text.c_str(); }
};
#define UTF8_TO_TCHAR(X) (FShimWide{ShimWiden(X)}.Get())

class FName {
public:
    FName() = default;
    FName(const TCHAR* Text) : Data(Text) {}
    FString ToString() const { return FString(Data); }
    bool operator==(const FName& Other) const { return Data == Other.Data; }

private:
    std::u16string Data;
};
inline const FName NAME_None;

class FText {
public:
    FText() = default;
    explicit FText(FString Text) : Data(std::move(Text)) {}
    const FString& ToString() const { return Data; }

private:
    FString Data;
};
#define LOCTEXT(Key, Text) FText(FString(TEXT(Text)))

enum class EAllowShrinking : uint8 { No, Yes };

template <typename T> class TArray {
    // std::vector<bool> has no references to its elements.
    using TStored = std::conditional_t<std::is_same_v<T, bool>, uint8, T>;

public:
    using ElementType = T;
    TArray() = default;
    TArray(std::initializer_list<T> From) : Items(From.begin(), From.end()) {}

    int32 Num() const { return static_cast<int32>(Items.size()); }
    TStored* GetData() { return Items.data(); }
    const TStored* GetData() const { return Items.data(); }
    TStored& operator[](int32 Index) { return Items.at(static_cast<std::size_t>(Index)); }
    const TStored& operator[](int32 Index) const { return Items.at(static_cast<std::size_t>(Index)); }
    int32 Add(const T& Item) { return Items.push_back(Item), Num() - 1; }
    int32 Add(T&& Item) { return Items.push_back(std::move(Item)), Num() - 1; }
    int32 AddUnique(const T& Item) {
        const auto Found = std::find(Items.begin(), Items.end(), Item);
        return Found != Items.end() ? static_cast<int32>(Found - Items.begin()) : Add(Item);
    }
    void Append(const T* From, int32 Count) { Items.insert(Items.end(), From, From + Count); }
    void Append(const TArray& Other) { Items.insert(Items.end(), Other.Items.begin(), Other.Items.end()); }
    void Init(const T& Item, int32 Count) { Items.assign(static_cast<std::size_t>(Count), static_cast<TStored>(Item)); }
    void Reserve(int32 Count) { Items.reserve(static_cast<std::size_t>(Count)); }
    void Reset() { Items.clear(); }
    void Empty() { Items = {}; }
    T& Last() { return Items.back(); }
    void SetNum(int32 Count) { Items.resize(static_cast<std::size_t>(Count)); }
    void SetNumUninitialized(int32 Count, EAllowShrinking = EAllowShrinking::Yes) {
        Items.resize(static_cast<std::size_t>(Count));
    }
    void SetNumZeroed(int32 Count) { Items.resize(static_cast<std::size_t>(Count)); }
    int32 Remove(const T& Item) {
        const std::size_t Before = Items.size();
        Items.erase(std::remove(Items.begin(), Items.end(), Item), Items.end());
        return static_cast<int32>(Before - Items.size());
    }
    void RemoveAtSwap(int32 Index) {
        (*this)[Index] = std::move(Items.back());
        Items.pop_back();
    }
    bool Contains(const T& Item) const { return std::find(Items.begin(), Items.end(), Item) != Items.end(); }
    auto begin() { return Items.begin(); }
    auto end() { return Items.end(); }
    auto begin() const { return Items.begin(); }
    auto end() const { return Items.end(); }
    bool operator==(const TArray& Other) const { return Items == Other.Items; }

private:
    std::vector<TStored> Items;
};

template <typename T> class TArrayView {
public:
    TArrayView(T* InData, int32 InCount) : Data(InData), Count(InCount) {}
    template <std::size_t N> TArrayView(T (&Array)[N]) : Data(Array), Count(static_cast<int32>(N)) {}
    T& operator[](int32 Index) const { return Data[Index]; }
    int32 Num() const { return Count; }

private:
    T* Data;
    int32 Count;
};
template <typename T> using TConstArrayView = TArrayView<const T>;

template <typename T> class TOptional {
public:
    TOptional() = default;
    TOptional(T InValue) : Value(std::move(InValue)) {}
    bool IsSet() const { return Value.has_value(); }
    const T& GetValue() const { return Value.value(); }

private:
    std::optional<T> Value;
};

template <typename T> class TFunctionRef;
template <typename R, typename... A> class TFunctionRef<R(A...)> {
public:
    template <typename F>
    requires(!std::is_same_v<std::decay_t<F>, TFunctionRef>) TFunctionRef(F&& Function)
        : Object(&Function), Call([](const void* From, A... Arguments) -> R {
              return (*static_cast<std::remove_reference_t<F>*>(const_cast<void*>(From)))(Arguments...);
          }) {}
    R operator()(A... Arguments) const { return Call(Object, Arguments...); }

private:
    const void* Object;
    R (*Call)(const void*, A...);
};

enum class ESPMode : uint8 { NotThreadSafe, ThreadSafe };

template <typename T, ESPMode Mode> class TSharedRef;
template <typename T, ESPMode Mode = ESPMode::ThreadSafe> class TSharedPtr {
public:
    TSharedPtr(std::nullptr_t = nullptr) {}
    explicit TSharedPtr(std::shared_ptr<T> From) : Data(std::move(From)) {}
    template <typename U> TSharedPtr(const TSharedRef<U, Mode>& From) : Data(From.Data) {}
    bool IsValid() const { return Data != nullptr; }
    T* Get() const { return Data.get(); }
    T* operator->() const { return Data.get(); }
    T& operator*() const { return *Data; }
    void Reset() { Data.reset(); }

private:
    std::shared_ptr<T> Data;
};
template <typename T, ESPMode Mode = ESPMode::ThreadSafe> class TSharedRef {
public:
    explicit TSharedRef(std::shared_ptr<T> From) : Data(std::move(From)) {}
    T* operator->() const { return Data.get(); }
    T& operator*() const { return *Data; }

private:
    template <typename U, ESPMode M> friend class TSharedPtr;
    std::shared_ptr<T> Data;
};
template <typename T, ESPMode Mode = ESPMode::ThreadSafe, typename... A>
TSharedRef<T, Mode> MakeShared(A&&... Arguments) {
    return TSharedRef<T, Mode>(std::make_shared<T>(std::forward<A>(Arguments)...));
}

template <typename T> class TUniquePtr {
public:
    TUniquePtr() = default;
    TUniquePtr(std::nullptr_t) {}
    explicit TUniquePtr(T* From) : Data(From) {}
    TUniquePtr(TUniquePtr&&) = default;
    TUniquePtr& operator=(TUniquePtr&&) = default;
    bool IsValid() const { return Data != nullptr; }
    T* Get() const { return Data.get(); }
    T* operator->() const { return Data.get(); }
    T& operator*() const { return *Data; }
    void Reset() { Data.reset(); }

private:
    std::unique_ptr<T> Data;
};
template <typename T, typename... A> TUniquePtr<T> MakeUnique(A&&... Arguments) {
    return TUniquePtr<T>(new T(std::forward<A>(Arguments)...));
}

namespace ELogVerbosity {
enum Type : uint8 { NoLogging, Fatal, Error, Warning, Display, Log, Verbose, VeryVerbose, All };
}
void ShimLog(const char* Category, ELogVerbosity::Type Verbosity, const FString& Line);

#define DECLARE_LOG_CATEGORY_EXTERN(CategoryName, DefaultVerbosity, CompileTimeVerbosity)                              \
    extern struct FLogCategory##CategoryName {                                                                         \
        static constexpr ELogVerbosity::Type Verbosity = ELogVerbosity::DefaultVerbosity;                              \
    } CategoryName
#define DEFINE_LOG_CATEGORY(CategoryName) FLogCategory##CategoryName CategoryName
#define UE_LOG(CategoryName, Verbosity, Format, ...)                                                                   \
    do {                                                                                                               \
        static_cast<void>(CategoryName);                                                                               \
        ShimLog(#CategoryName, ELogVerbosity::Verbosity, FString::Printf(Format __VA_OPT__(, ) __VA_ARGS__));          \
    } while (false)

struct FMemory {
    static void* Malloc(SIZE_T Count, uint32 Alignment = 0);
    static void Free(void* Original);
};
int64 ShimLiveAllocations();

struct FDelegateHandle {
    uint64 Id = 0;
};

template <typename Signature> class TDelegate;
template <typename R, typename... A> class TDelegate<R(A...)> {
public:
    static TDelegate CreateStatic(R (*Function)(A...)) { return TDelegate(Function); }
    TDelegate() = default;
    bool IsBound() const { return static_cast<bool>(Target); }
    R Execute(A... Arguments) const { return Target(std::forward<A>(Arguments)...); }

private:
    explicit TDelegate(std::function<R(A...)> InTarget) : Target(std::move(InTarget)) {}
    std::function<R(A...)> Target;
};

template <typename Signature> class TMulticastDelegate;
template <typename... A> class TMulticastDelegate<void(A...)> {
public:
    template <typename T> FDelegateHandle AddUObject(T* Object, void (T::*Method)(A...)) {
        Targets.push_back({++Last, [Object, Method](A... Arguments) { (Object->*Method)(Arguments...); }});
        return {Last};
    }
    bool Remove(FDelegateHandle Handle) {
        return std::erase_if(Targets, [Handle](const auto& Target) { return Target.first == Handle.Id; }) > 0;
    }
    void Broadcast(A... Arguments) const {
        for (const auto& Target : Targets) Target.second(Arguments...);
    }

private:
    uint64 Last = 0;
    std::vector<std::pair<uint64, std::function<void(A...)>>> Targets;
};
struct FSimpleMulticastDelegate {
    using FDelegate = TDelegate<void()>;
};

template <typename... A> class TShimDynamicDelegate {
public:
    template <typename T> void ShimAdd(T* Object, void (T::*Method)(A...)) {
        Targets.push_back([Object, Method](A... Arguments) { (Object->*Method)(Arguments...); });
    }
    void Broadcast(A... Arguments) const {
        for (const auto& Target : Targets) Target(Arguments...);
    }
    bool IsBound() const { return !Targets.empty(); }

private:
    std::vector<std::function<void(A...)>> Targets;
};
#define AddDynamic(Object, Method) ShimAdd(Object, Method)
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(Name, Type, Parameter)                                             \
    class Name : public TShimDynamicDelegate<Type> {}

struct TStatId {};
#define DECLARE_STATS_GROUP(Description, Group, Category)                                                              \
    struct Group##_Shim {}
#define DECLARE_CYCLE_STAT(Description, Stat, Group)                                                                   \
    struct Stat##_Shim : Group##_Shim {}
#define SCOPE_CYCLE_COUNTER(Stat)                                                                                      \
    [[maybe_unused]] const Stat##_Shim ShimScope##Stat {}
#define RETURN_QUICK_DECLARE_CYCLE_STAT(Name, Group) return TStatId()
