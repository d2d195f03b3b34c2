// A caller's wind or water callback, and whether it has given invalid values.
#pragma once

#include "base/float_mode.h"

#include <atomic>

namespace lr {

template <class Function> class Callback {
public:
    void set_callback(Function* function, void* user) {
        replace_callback(function, user);
        blamed_.store(false, std::memory_order_relaxed);
        told_ = false;
    }
    // For a function with the same results: a report made before is not repeated.
    void replace_callback(Function* function, void* user) { callback_ = function, user_ = user; }
    Function* callback() const { return callback_; }
    void* callback_user() const { return user_; }

    template <class Query> void ask_callback(const Query& query) const {
        const FloatMode mode; // restores the caller's mode after the callback
        callback_(user_, &query);
    }
    // Any thread.
    void blame_callback() { blamed_.store(true, std::memory_order_relaxed); }
    // Whether to report an invalid value: true at most once per callback.
    bool take_blame() {
        if (told_ || !blamed_.load(std::memory_order_relaxed)) return false;
        return told_ = true;
    }

private:
    Function* callback_ = nullptr;
    void* user_ = nullptr;
    std::atomic<bool> blamed_{false};
    bool told_ = false;
};
} // namespace lr
