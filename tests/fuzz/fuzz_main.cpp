// SPDX-License-Identifier: GPL-2.0-or-later
// The entry point that libFuzzer calls; compiled once for each target.
#include "target.h"

#define VIGIL_FUZZ_JOIN(a, b) a##b
#define VIGIL_FUZZ_FUNCTION(name) VIGIL_FUZZ_JOIN(fuzz_, name)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    vigil::fuzz::VIGIL_FUZZ_FUNCTION(VIGIL_FUZZ_TARGET)({data, size});
    return 0;
}
