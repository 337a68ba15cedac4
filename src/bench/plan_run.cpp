// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/checkpoint.h"
#include "bench/measure.h"
#include "bench/plan.h"
#include "bench/plan_csv.h"
#include "client/measure/commit.h"
#include "common/error.h"
#include "common/log.h"
#include "console/cvar.h"
#include "console/outdir.h"
#include "refresh/vkpt/gpu/device.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

/// Clamped settings and missing textures must be seen; what levels contain need not.
class WarningLog {
public:
    WarningLog()
        : sink_(add_log_sink([](Severity severity, std::string_view line) {
              if (severity != Severity::Info) fmt::print(stderr, "{}\n", line);
          })) {}
    ~WarningLog() { remove_log_sink(sink_); }
    WarningLog(const WarningLog&) = delete;
    WarningLog& operator=(const WarningLog&) = delete;

private:
    int sink_;
};

/// Sets variables, and sets them back when it ends.
class ScopedSettings {
public:
    explicit ScopedSettings(std::span<const Setting> settings) {
        for (const Setting& setting : settings) {
            before_.push_back({setting.name, cvars().get_text(setting.name)});
            cvars().set(setting.name, setting.value);
        }
    }
    ~ScopedSettings() {
        for (auto setting = before_.rbegin(); setting != before_.rend(); ++setting)
            cvars().set(setting->name, setting->value);
    }
    ScopedSettings(const ScopedSettings&) = delete;
    ScopedSettings& operator=(const ScopedSettings&) = delete;

private:
    std::vector<Setting> before_;
};

std::string device_description() {
    gpu::DeviceOptions options;
    options.name = cvars().get_text("vk_device");
    return gpu::Device(options, nullptr).description();
}

/// Runs of rows, which is what progress counts.
int step_count(const QualityOptions& options) {
    const bool flies = options.measured == Measured::Times || options.measured == Measured::Economy;
    const int views = flies ? 1 : options.views;
    return views * options.seeds * static_cast<int>(options.rows.size());
}

/// What tells one measurement of a part from another.
ordered_json part_json(const Part& part) {
    const QualityOptions& options = part.options;
    ordered_json rows = ordered_json::array();
    for (const QualityRow& row : options.rows)
        rows.push_back(to_json(row));
    ordered_json json = {{"level", part.level},
                         {"width", options.size.x},
                         {"height", options.size.y},
                         {"views", options.views},
                         {"seeds", options.seeds},
                         {"first_seed", options.first_seed},
                         {"warmup", options.warmup},
                         {"frames", options.frames},
                         {"baseline", options.baseline},
                         {"reference", options.reference.label},
                         {"reference_paths", options.reference_paths},
                         {"floor", options.floor},
                         {"variables", variables_json(options.settings)},
                         {"rows", std::move(rows)}};
    if (!part.axis.empty()) json[part.axis] = part.value;
    return json;
}

/// The head of the report: everything that is measured, and on what.
ordered_json head_json(const Plan& plan, const std::string& device) {
    const QualityOptions& options = plan.options;
    ordered_json planned = ordered_json::object();
    for (const Part& part : plan.parts)
        planned[part.name] = part_json(part);
    ordered_json head = {{"measured", plan.name},
                         {"device", device},
                         {"commit", client::commit()},
                         {"width", options.size.x},
                         {"height", options.size.y},
                         {"seeds", options.seeds},
                         {"first_seed", options.first_seed},
                         {"warmup", options.warmup},
                         {"camera_fps", place_fps},
                         {"baseline", options.baseline},
                         {"intervals", "typical runs"},
                         {"trimmed_share", trimmed_share},
                         {"bright_factor", bright_factor},
                         {"reference_share", options.reference_share},
                         {"variables", variables_json(options.settings)},
                         {"planned", std::move(planned)}};
    head.update(plan.about);
    return head;
}

/// Measures a part, prints its tables, returns what the report keeps.
ordered_json measure_part(const Part& part, Progress& progress) {
    const ScopedSettings settings(part.options.settings);
    QualityRenderer renderer(part.options, part.level);
    ordered_json json = part_json(part);
    json.erase("rows");
    progress.note("preparing");
    renderer.prepare(part.options.rows);
    Measure* const measures[] = {measure_errors, measure_curve, measure_times,
                                 measure_turn,   measure_route, measure_still,
                                 measure_change, measure_cut,   measure_economy};
    const PartReport report = measures[static_cast<std::size_t>(part.options.measured)](
        part.options, renderer, part.level, progress);
    json.update(report.json);
    json["triangles"] = renderer.triangle_count();
    json["lights"] = renderer.light_count();
    if (!part.axis.empty()) fmt::print("\n== {}", part.name);
    fmt::print("{}", report.text);
    std::fflush(stdout);
    return json;
}

} // namespace

int run_plan(const Plan& plan) {
    const WarningLog warnings;
    cvars().set("pt_jitter", "0"); // references show the pixels that single frames show
    const ScopedSettings settings(plan.options.settings);
    const std::filesystem::path path = plan.options.json.empty()
                                           ? output_path(plan.name + ".json")
                                           : std::filesystem::path(plan.options.json);
    const std::string device = device_description();
    fmt::print("{}\n", device);
    Checkpoint checkpoint(path, head_json(plan, device), plan.options.keep);

    int steps = 0;
    for (const Part& part : plan.parts)
        steps += step_count(part.options);
    int failures = 0;
    {
        Progress progress(steps);
        for (const Part& part : plan.parts) {
            const int before = progress.done();
            if (checkpoint.find(part.name) != nullptr) {
                fmt::print("{}: measured before, kept\n", part.name);
                progress.skip(step_count(part.options));
                continue;
            }
            try {
                progress.begin(part.name);
                checkpoint.add(part.name, measure_part(part, progress));
            } catch (const Error& error) {
                fmt::print(stderr, "{}: {}\n", part.name, error.what());
                progress.skip(before + step_count(part.options) - progress.done());
                ++failures;
            }
        }
    }
    if (failures > 0 && checkpoint.report()["parts"].empty()) return 1;
    if (failures == 0) checkpoint.finish();
    const std::filesystem::path csv = std::filesystem::path(path).replace_extension(".csv");
    write_file(csv, plan_csv(checkpoint.report()));
    fmt::print("\nreport: {}, {}\n", path.string(), csv.string());
    return failures == 0 ? 0 : 1;
}

} // namespace vigil::bench
