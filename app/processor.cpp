#include <unistd.h>

#include <cstring>

// Linked into each program beside its main and compiled for any x86-64, so that a processor that lacks what the rest is
// compiled for gets a line and not an illegal instruction.

// Before the constructors of all other files, which may use what is lacking.
__attribute__((constructor(101))) static void expect_processor() {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma")) return;
    const char* line =
        "carrel: failed: this processor lacks AVX2, BMI2 or FMA, expected one of x86-64-v3 (from 2013 on)\n";
    if (write(STDERR_FILENO, line, strlen(line)) < 0) _exit(1);
    _exit(1);
}
