#include "lr_bench/vector_pipes.h"
#include "lr_bench/subject.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

namespace lr_bench {

#if defined(__x86_64__)
namespace {

double cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

constexpr int repeats = 30000;

// Eight independent results; registers 8 and 9 are the operands.
#define LR_EIGHT(line) line(0) line(1) line(2) line(3) line(4) line(5) line(6) line(7)
#define LR_LOOP(name, r, line)                                                                                         \
    void name(float* memory) {                                                                                         \
        asm volatile(                                                                                                  \
            "vbroadcastss %0, %%" r "8\n\tvbroadcastss %0, %%" r "9\n\t"                                               \
            "mov %1, %%ecx\n\t.p2align 5\n1:\n\t" LR_EIGHT(line) LR_EIGHT(line) "dec %%ecx\n\tjnz 1b\n\tvzeroupper"    \
            :                                                                                                          \
            : "m"(*memory), "i"(repeats), "r"(memory)                                                                  \
            : "memory", "rcx", "cc", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9");  \
    }
// clang-format off
#define LR_WIDTH(w, r)                                                                                                  \
    LR_LOOP(mul_##w, r, LR_MUL_##w)       LR_LOOP(add_##w, r, LR_ADD_##w)     LR_LOOP(fma_##w, r, LR_FMA_##w)           \
    LR_LOOP(mixed_##w, r, LR_MIXED_##w)   LR_LOOP(div_##w, r, LR_DIV_##w)     LR_LOOP(sqrt_##w, r, LR_SQRT_##w)         \
    LR_LOOP(muludq_##w, r, LR_MULUDQ_##w) LR_LOOP(mulld_##w, r, LR_MULLD_##w) LR_LOOP(logic_##w, r, LR_LOGIC_##w)       \
    LR_LOOP(shift_##w, r, LR_SHIFT_##w)   LR_LOOP(shuffle_##w, r, LR_SHUFFLE_##w)                                       \
    LR_LOOP(convert_##w, r, LR_CONVERT_##w) LR_LOOP(load_##w, r, LR_LOAD_##w) LR_LOOP(store_##w, r, LR_STORE_##w)
#define LR_3(op, r, i) op " %%" r "8, %%" r "9, %%" r #i "\n\t"
#define LR_2(op, r, i) op " %%" r "8, %%" r #i "\n\t"

#define LR_MUL_256(i) LR_3("vmulps", "ymm", i)
#define LR_ADD_256(i) LR_3("vaddps", "ymm", i)
#define LR_FMA_256(i) LR_3("vfmadd213ps", "ymm", i)
#define LR_MIXED_256(i) LR_3("vmulps", "ymm", i) LR_3("vaddps", "ymm", i)
#define LR_DIV_256(i) LR_3("vdivps", "ymm", i)
#define LR_SQRT_256(i) LR_2("vsqrtps", "ymm", i)
#define LR_MULUDQ_256(i) LR_3("vpmuludq", "ymm", i)
#define LR_MULLD_256(i) LR_3("vpmulld", "ymm", i)
#define LR_LOGIC_256(i) LR_3("vpxor", "ymm", i)
#define LR_SHIFT_256(i) "vpsrld $8, %%ymm8, %%ymm" #i "\n\t"
#define LR_SHUFFLE_256(i) "vshufps $0xb1, %%ymm8, %%ymm9, %%ymm" #i "\n\t"
#define LR_CONVERT_256(i) LR_2("vcvtdq2ps", "ymm", i)
#define LR_LOAD_256(i) "vmovups (%2), %%ymm" #i "\n\t"
#define LR_STORE_256(i) "vmovups %%ymm8, (%2)\n\t"

#define LR_MUL_512(i) LR_3("vmulps", "zmm", i)
#define LR_ADD_512(i) LR_3("vaddps", "zmm", i)
#define LR_FMA_512(i) LR_3("vfmadd213ps", "zmm", i)
#define LR_MIXED_512(i) LR_3("vmulps", "zmm", i) LR_3("vaddps", "zmm", i)
#define LR_DIV_512(i) LR_3("vdivps", "zmm", i)
#define LR_SQRT_512(i) LR_2("vsqrtps", "zmm", i)
#define LR_MULUDQ_512(i) LR_3("vpmuludq", "zmm", i)
#define LR_MULLD_512(i) LR_3("vpmulld", "zmm", i)
#define LR_LOGIC_512(i) LR_3("vpxord", "zmm", i)
#define LR_SHIFT_512(i) "vpsrld $8, %%zmm8, %%zmm" #i "\n\t"
#define LR_SHUFFLE_512(i) "vshufps $0xb1, %%zmm8, %%zmm9, %%zmm" #i "\n\t"
#define LR_CONVERT_512(i) LR_2("vcvtdq2ps", "zmm", i)
#define LR_LOAD_512(i) "vmovups (%2), %%zmm" #i "\n\t"
#define LR_STORE_512(i) "vmovups %%zmm8, (%2)\n\t"

LR_WIDTH(256, "ymm")
LR_WIDTH(512, "zmm")

struct Operation {
    int width;
    const char* name;
    void (*run)(float*);
    int instructions; // per line
};
#define LR_ROWS(w)                                                                                                      \
    {w, "mul", mul_##w, 1}, {w, "add", add_##w, 1}, {w, "fma", fma_##w, 1}, {w, "mul+add", mixed_##w, 2},               \
    {w, "div", div_##w, 1}, {w, "sqrt", sqrt_##w, 1}, {w, "vpmuludq", muludq_##w, 1}, {w, "vpmulld", mulld_##w, 1},     \
    {w, "logic", logic_##w, 1}, {w, "shift", shift_##w, 1}, {w, "shuffle", shuffle_##w, 1},                             \
    {w, "convert", convert_##w, 1}, {w, "load", load_##w, 1}, {w, "store", store_##w, 1}
constexpr Operation operations[] = {LR_ROWS(256), LR_ROWS(512)};
// clang-format on

} // namespace

int write_ports(const char* path) {
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return 2;
    const bool wide = __builtin_cpu_supports("avx512f") != 0;
    std::FILE* const file = std::fopen(path, "w");
    if (!file) return 1;
    std::fprintf(file, "width,operation,cycles\n");
    alignas(64) float memory[64];
    std::fill(std::begin(memory), std::end(memory), 1.5f);
    const auto clock = make_clock();
    for (const Operation& o : operations) {
        if (o.width == 512 && !wide) continue;
        // In turns with the clock measurement, so that both have the same frequency.
        std::vector<double> cycles;
        for (int round = 0; round < 61; ++round) {
            const double t0 = cpu_seconds();
            o.run(memory);
            const double t1 = cpu_seconds();
            for (int i = 0; i < 64; ++i) clock->step();
            const double t2 = cpu_seconds();
            cycles.push_back((t1 - t0) / repeats / (16 * o.instructions) / ((t2 - t1) / (64 * clock_chain)));
        }
        std::nth_element(cycles.begin(), cycles.begin() + 30, cycles.end());
        std::fprintf(file, "%d,%s,%.3f\n", o.width, o.name, cycles[30]);
    }
    return std::fclose(file) == 0 ? 0 : 1;
}
#else
int write_ports(const char*) {
    return 2;
}
#endif

} // namespace lr_bench
