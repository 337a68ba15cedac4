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
    check_count(arguments, 0, 1, "view [NAME]");
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

std::vector<std::string> view_candidates(CommandArguments arguments) {
    std::vector<std::string> names;
    if (!arguments.empty()) return names;
    for (const ViewInfo& info : view_infos)
        names.emplace_back(info.name);
    return names;
}

void guiding(Client& client) {
    Session& session = client.session_in_level();
    session.take_frame_times(true);
    log_info("{}", guiding_text(session.renderer().report_guiding()));
    if (session.count_statistics().frame_count() > 0)
        log_info("{}", session.count_statistics().table());
}

void vlcinfo(Client& client) {
    Session& session = client.session_in_level();
    session.render_if_stale(); // `setviewpos ...; vlcinfo` is about the new view
    log_info("{}", light_cache_text(session.renderer().report_guiding()));
}

void cdqinfo(Client& client) {
    Session& session = client.session_in_level();
    session.render_if_stale();
    log_info("{}", quadtree_text(session.renderer().report_guiding()));
}

} // namespace

void add_guiding_commands(Client& client) {
    CommandRegistry& commands = client.commands();
    commands.add(
        "view",
        "[NAME]: shows what the path tracer knows instead of the picture, or lists the views",
        [&client](CommandArguments arguments) { view(client, arguments); }, view_candidates);
    commands.add("viewnext", ": the next view of the list; after the last one, the picture",
                 [&client](CommandArguments) { step_view(client, 1); });
    commands.add("viewprev", ": the view before",
                 [&client](CommandArguments) { step_view(client, -1); });
    commands.add("guiding",
                 ": memory of octree and light caches, and what they counted in recent frames",
                 [&client](CommandArguments) { guiding(client); });
    commands.add("guidingreset", ": forgets what frames taught (octree, caches, shadow statistics)",
                 [&client](CommandArguments) { client.session_in_level().reset_guiding(); });
    commands.add("vlcinfo", ": the octree's leaf under the crosshair and the lights of its cache",
                 [&client](CommandArguments) { vlcinfo(client); });
    commands.add(
        "cdqinfo",
        ": the quadtree of directions of the leaf under the crosshair, and how its rays did",
        [&client](CommandArguments) { cdqinfo(client); });
}

} // namespace vigil::client
