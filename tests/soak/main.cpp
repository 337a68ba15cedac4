// SPDX-License-Identifier: GPL-2.0-or-later
// The program `vigil` with one more command: soak.
#include "client/program.h"
#include "soak/soak_command.h"

int main(int argc, char** argv) {
    const std::span<const char* const> words(argv, static_cast<size_t>(argc));
    return vigil::client::run_program(words.subspan(argc > 0 ? 1 : 0),
                                      vigil::refresh::make_vkpt_renderer,
                                      vigil::client::add_soak_command);
}
