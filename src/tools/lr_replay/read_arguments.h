// Reads the arguments of a recorded call, which api/checked_call.h writes. Throws FaultId::malformed.
#pragma once

#include "recording/recording_format.h"
#include "tools/lr_replay/replay_faults.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace lr::replay {

using Bytes = std::vector<unsigned char>;
using FindBlob = std::function<bool(uint64_t hash, Bytes& out)>;

// An array, null or given, aligned for every type that calls use.
struct Array {
    bool given = false;
    Bytes bytes;
    template <class T> const T* as() const { return given ? reinterpret_cast<const T*>(bytes.data()) : nullptr; }
};

class Arguments {
public:
    Arguments(const unsigned char* data, size_t size, const FindBlob& find, std::ostream* text)
        : at_(data), end_(data + size), find_(&find), text_(text) {}

    template <class T> T value() {
        T v;
        take(&v, sizeof v);
        if constexpr (requires { v.id; })
            say() << v.id;
        else
            say() << v;
        return v;
    }
    // An array of `expected` bytes, or of any size for `any`; can be null.
    static constexpr uint64_t any = UINT64_MAX;
    Array array(uint64_t expected) {
        Array out;
        const auto where = take<recording::Where>();
        if (where == recording::Where::null) {
            say() << "null";
            return out;
        }
        const auto size = take<uint64_t>();
        say() << size << " bytes";
        if (expected != any && size != expected) wrong("an array has the wrong length");
        out.given = true;
        if (where == recording::Where::here) {
            if (size > left()) wrong("an array extends beyond the record");
            out.bytes.assign(at_, at_ + size);
            at_ += size;
        } else if (where != recording::Where::blob || !(*find_)(take<uint64_t>(), out.bytes) ||
                   out.bytes.size() != size) {
            wrong("an array was not recorded");
        }
        // Keeps data() from being null.
        if (out.bytes.empty()) out.bytes.reserve(16);
        return out;
    }
    // `count` floats, recorded without their size.
    Array floats(uint32_t count) {
        Array out;
        out.given = take<recording::Where>() != recording::Where::null;
        if (!out.given) return out;
        if (uint64_t{count} * sizeof(float) > left()) wrong("an array extends beyond the record");
        out.bytes.assign(at_, at_ + size_t{count} * sizeof(float));
        at_ += size_t{count} * sizeof(float);
        if (out.bytes.empty()) out.bytes.reserve(16);
        return out;
    }
    // False if it is null.
    template <class T> bool structure(T& out) {
        if (take<recording::Where>() == recording::Where::null) {
            say() << "null";
            return false;
        }
        read(out);
        return true;
    }
    template <class T> bool plain(T& out) {
        if (take<recording::Where>() == recording::Where::null) {
            say() << "null";
            return false;
        }
        take(&out, sizeof out);
        return true;
    }
    // each(element) reads the arrays that follow the element.
    template <class T, class Each> bool structures(uint32_t& count, std::vector<T>& out, Each&& each) {
        count = value<uint32_t>();
        if (take<recording::Where>() == recording::Where::null) return false;
        for (uint32_t i = 0; i < count; ++i) {
            T one;
            read(one);
            out.push_back(one);
            each(out.back());
        }
        return true;
    }
    template <class T> bool structures(uint32_t& count, std::vector<T>& out) {
        return structures(count, out, [](T&) {});
    }
    void end() {
        if (at_ != end_) wrong("it is longer than its call requires");
    }
    [[noreturn]] static void wrong(const std::string& what) {
        throw Fault(FaultId::malformed, "a record is malformed: " + what);
    }

private:
    size_t left() const { return static_cast<size_t>(end_ - at_); }
    void take(void* to, size_t size) {
        if (size > left()) wrong("it is shorter than its call requires");
        std::memcpy(to, at_, size);
        at_ += size;
    }
    template <class T> T take() {
        T v;
        take(&v, sizeof v);
        return v;
    }
    // A struct of an older library can be shorter; the tail of a newer, longer struct must be zero.
    template <class T> void read(T& out) {
        const auto size = take<uint32_t>();
        if (size < sizeof(uint32_t) || size > left()) wrong("a struct extends beyond the record");
        constexpr uint32_t known = recording::recorded_bytes<T>;
        if (std::any_of(at_ + std::min(size, known), at_ + size, [](unsigned char byte) { return byte != 0; }))
            throw Fault(FaultId::unknown_call, "a struct of a newer library");
        std::memset(static_cast<void*>(&out), 0, sizeof out);
        std::memcpy(static_cast<void*>(&out), at_, std::min(size, known));
        out.struct_size = sizeof(T);
        at_ += size;
        say() << "{" << size << " bytes}";
    }
    std::ostream& say() {
        static thread_local std::ostringstream nowhere;
        if (!text_) {
            nowhere.seekp(0);
            return nowhere;
        }
        if (said_) *text_ << ", ";
        said_ = true;
        return *text_;
    }

    const unsigned char* at_;
    const unsigned char* end_;
    const FindBlob* find_;
    std::ostream* text_;
    bool said_ = false;
};
} // namespace lr::replay
