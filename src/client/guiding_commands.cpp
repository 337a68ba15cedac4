// SPDX-License-Identifier: GPL-2.0-or-later
// Console commands about what the renderer has learned, and about looking at it: view, viewnext,
// viewprev, guiding, guidingreset, vlcinfo, cdqinfo.
#include "client/client.h"
#include "client/measure/report_text.h"
#include "common/log.h"
#include "console/arguments.h"
#include "shared/views.h"

#include <iterator>

namespace vigil::client {

namespace {

void say_view(Client& client) {
    const ViewInfo& info = view_infos[client.commands().variables()->pt_view];
    log_info("view {}: {}", info.name, info.help);
}

void view(Client& client, CommandArguments arguments) {
    const int now = client.commands().variables()->pt_view;
    if (!arguments.empty()) {
        client.commands().set_variable("pt_view", arguments[0]);
        return say_view(client);
    }
    for (const ViewInfo& info : view_infos)
        log_info("{} {:<12} {}", info.number == now ? '*' : ' ', info.name, info.help);
}

/// The view `step` rows further in the list, round and round; none, the picture, is one of them.
void step_view(Client& client, int step) {
    const int count = static_cast<int>(std::size(view_infos));
    CvarRegistry& variables = client.commands().variables();
    variables.set(&CvarValues::pt_view, (variables->pt_view + count + step) % count);
    say_view(client);
}

void guiding(Client& client, CommandArguments) {
    Session& session = client.session_in_level();
    session.take_frame_times(true);
    log_info("{}", guiding_text(session.renderer().report_guiding()));
    if (session.count_statistics().frame_count() > 0)
        log_info("{}", session.count_statistics().table());
}

/// `setviewpos ...; vlcinfo` is about the new view.
auto under_crosshair(Client& client) {
    Session& session = client.session_in_level();
    session.render_if_stale();
    return session.renderer().report_guiding();
}

} // namespace

ClientCommands guiding_commands() {
    const auto views = [](const Client&) { return choice_names(*find_cvar("pt_view")); };
    return {
        {"view",
         "[NAME]: Shows what the path tracer knows instead of the picture. Alone, it lists the "
         "views.",
         view, views},
        {"viewnext", ": Shows the next view of the list. The picture follows the last one.",
         [](Client& c, CommandArguments) { step_view(c, 1); }},
        {"viewprev", ": Shows the view before.",
         [](Client& c, CommandArguments) { step_view(c, -1); }},
        {"guiding",
         ": Prints memory of octree and light caches, and what they counted in recent frames.",
         guiding},
        {"guidingreset", ": Forgets what frames have taught: octree, caches and statistics.",
         [](Client& c, CommandArguments) { c.session_in_level().reset_guiding(); }},
        {"vlcinfo", ": Prints the octree's leaf under the crosshair and the lights of its cache.",
         [](Client& c, CommandArguments) { log_info("{}", light_cache_text(under_crosshair(c))); }},
        {"cdqinfo",
         ": Prints the quadtree of directions under the crosshair, and how its rays did.",
         [](Client& c, CommandArguments) { log_info("{}", quadtree_text(under_crosshair(c))); }}};
}

} // namespace vigil::client
