// SPDX-License-Identifier: GPL-2.0-or-later
// Loads a shared object and runs its one_frame, as an engine does with its renderer's module:
//
//     load_module MODULE ARGUMENTS...
#include <dlfcn.h>

#include <cstdio>

int main(int argc, char** argv) {
    void* const module = argc > 1 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
    void* const run = module != nullptr ? dlsym(module, "one_frame") : nullptr;
    if (run == nullptr) {
        std::fprintf(stderr, "load_module: %s\n", argc > 1 ? dlerror() : "which module?");
        return 2;
    }
    return reinterpret_cast<int (*)(int, char**)>(run)(argc - 1, argv + 1);
}
