// SPDX-License-Identifier: GPL-2.0-or-later
// The console command soak, which plays at random. No part of the program that people play.
#pragma once

#include "client/client.h"

namespace vigil::client {

void add_soak_command(Client& client);

} // namespace vigil::client
