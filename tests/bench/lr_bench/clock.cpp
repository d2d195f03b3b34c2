#include "lr_bench/subject.h"

namespace lr_bench {
namespace {

class Clock final : public Subject {
public:
    bool step() override {
        uint64_t x = chain_;
        for (uint32_t i = 0; i < clock_chain; i += 16) {
#if defined(__x86_64__)
            asm volatile(".rept 16\n\tadd $1, %0\n\t.endr" : "+r"(x) : : "cc");
#elif defined(__aarch64__)
            asm volatile(".rept 16\n\tadd %0, %0, #1\n\t.endr" : "+r"(x));
#else
            for (int k = 0; k < 16; ++k) {
                ++x;
                asm volatile("" : "+r"(x));
            }
#endif
        }
        chain_ = x;
        return true;
    }

private:
    uint64_t chain_ = 0;
};

} // namespace

std::unique_ptr<Subject> make_clock() {
    return std::make_unique<Clock>();
}

} // namespace lr_bench
