// SPDX-License-Identifier: GPL-2.0-or-later
// Demos: every block up to the first that is refused, as playback reads them.
#include "formats/dm2_file.h"
#include "formats/dm2_parser.h"
#include "target.h"

#include <vector>

namespace vigil::fuzz {

void fuzz_dm2(Input bytes) {
    parse_or_refuse("x.dm2", [&] {
        dm2::File file("x.dm2", {bytes.begin(), bytes.end()});
        dm2::Parser parser(file.name());
        std::vector<dm2::Message> messages;
        while (const auto block = file.next()) {
            messages.clear();
            parser.parse(*block, messages);
        }
    });
}

} // namespace vigil::fuzz
