// SPDX-License-Identifier: GPL-2.0-or-later
#include "console/foreign_names.h"

#include "common/error.h"
#include "console/arguments.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace vigil {

namespace {

constexpr std::string_view no_camera = "The camera is a pinhole, without a depth of field.";
constexpr std::string_view no_curve = "pt_tonemap chooses a curve without parameters.";
constexpr std::string_view no_histogram = "Exposure follows the picture's mean lightness.";
constexpr std::string_view no_blend = "The client blends nothing over the picture.";
constexpr std::string_view no_bloom = "Light does not bleed over its edges.";
constexpr std::string_view no_fog = "There is no fog for light to be seen in.";
constexpr std::string_view no_hdr = "The picture is made for displays without HDR.";
constexpr std::string_view no_time_of_day = "The level says where its sun stands.";
constexpr std::string_view no_sky_model = "The level's own sky shines.";
constexpr std::string_view no_upscaler = "vid_scale scales up by itself.";
constexpr std::string_view no_scale_range = "vid_scale falls down to 25 and rises up to 100.";
constexpr std::string_view one_channel = "The denoiser has one channel for all light.";
constexpr std::string_view no_refraction = "Glass lets light through straight.";
constexpr std::string_view no_materials = "Materials stay as the level has them.";
constexpr std::string_view all_lights = "Every light of the level counts.";

constexpr ForeignName names[] = {
    {"bloom_enable", "", "", no_bloom},
    {"bloom_intensity", "", "", no_bloom},
    {"bloom_sigma", "", "", no_bloom},
    {"drs_adjust_down", "", "", no_scale_range},
    {"drs_adjust_up", "", "", no_scale_range},
    {"drs_enable", "vid_fps_target", "0|60", "drs_target says another rate than 60."},
    {"drs_gain", "", "", no_scale_range},
    {"drs_maxscale", "", "", no_scale_range},
    {"drs_minscale", "", "", no_scale_range},
    {"drs_target", "vid_fps_target", "same", "It starts at once, without drs_enable."},
    {"flt_antilag_hf", "flt_antilag", "0|1", one_channel},
    {"flt_antilag_lf", "flt_antilag", "0|1", one_channel},
    {"flt_antilag_spec", "flt_antilag", "0|1", one_channel},
    {"flt_atrous_hf", "flt_atrous", "same", one_channel},
    {"flt_atrous_lf", "flt_atrous", "same", one_channel},
    {"flt_atrous_spec", "flt_atrous", "same", one_channel},
    {"flt_fixed_albedo", "", "", no_materials},
    {"flt_fsr_easu", "", "", no_upscaler},
    {"flt_fsr_enable", "", "", no_upscaler},
    {"flt_fsr_rcas", "", "", no_upscaler},
    {"flt_fsr_sharpness", "", "", no_upscaler},
    {"flt_scale_hf", "", "", one_channel},
    {"flt_scale_lf", "", "", one_channel},
    {"flt_scale_overlay", "", "", one_channel},
    {"flt_scale_spec", "", "", one_channel},
    {"flt_show_gradients", "", "", "`view` lists what can be shown."},
    {"flt_temporal_hf", "", "", one_channel},
    {"flt_temporal_lf", "", "", one_channel},
    {"flt_temporal_spec", "", "", one_channel},
    {"gr_eccentricity", "", "", no_fog},
    {"gr_enable", "", "", no_fog},
    {"gr_intensity", "", "", no_fog},
    {"next_sun", "", "", no_time_of_day},
    {"physical_sky", "", "", no_sky_model},
    {"physical_sky_brightness", "pt_sky_scale", "exp2", "It scales the level's own sky."},
    {"physical_sky_draw_clouds", "", "", no_sky_model},
    {"physical_sky_space", "", "", no_sky_model},
    {"profiler", "scr_stats", "off|passes", "TAB switches it too."},
    {"pt_accumulation_rendering", "pt_accumulate", "0|1",
     "It averages at once, not only in a pause. The menu and the console stay."},
    {"pt_accumulation_rendering_framenum", "", "", "pt_accumulate averages without an end."},
    {"pt_aperture", "", "", no_camera},
    {"pt_aperture_angle", "", "", no_camera},
    {"pt_aperture_type", "", "", no_camera},
    {"pt_bump_scale", "", "", no_materials},
    {"pt_caustics", "", "", no_refraction},
    {"pt_direct_dyn_lights", "", "", all_lights},
    {"pt_direct_polygon_lights", "", "", all_lights},
    {"pt_direct_sun_light", "pt_sun_scale", "0|1", "It also takes the sun's light after a bounce."},
    {"pt_dof", "", "", no_camera},
    {"pt_focus", "", "", no_camera},
    {"pt_indirect_dyn_lights", "", "", all_lights},
    {"pt_indirect_polygon_lights", "", "", all_lights},
    {"pt_light_stats", "pt_sll_stats", "0|1", "Only pt_nee sll has these statistics."},
    {"pt_metallic_override", "", "", no_materials},
    {"pt_num_bounce_rays", "pt_bounces", "up", "Its 0.5 is pt_indirect_rate half here."},
    {"pt_projection", "", "", "The picture is a perspective one."},
    {"pt_reflect_refract", "", "", no_refraction},
    {"pt_roughness_override", "", "", no_materials},
    {"pt_thick_glass", "", "", no_refraction},
    {"scr_fps", "scr_stats", "off|groups", "TAB switches it too."},
    {"screenshotjpg", "screenshot", "", "Pictures are PNG."},
    {"screenshotpng", "screenshot", "", "Pictures are PNG."},
    {"screenshottga", "screenshot", "", "Pictures are PNG."},
    {"sun_angle", "pt_sun_size", "same", "Both are the diameter in degrees."},
    {"sun_animate", "", "", no_time_of_day},
    {"sun_azimuth", "", "", no_time_of_day},
    {"sun_bounce", "", "", "Sunlight bounces like all light."},
    {"sun_brightness", "pt_sun_scale", "*0.1", "10 there is 1 here, which is the level's own sun."},
    {"sun_color", "", "", "The level says what colour its sun has."},
    {"sun_elevation", "", "", no_time_of_day},
    {"sun_gamepad", "", "", no_time_of_day},
    {"sun_latitude", "", "", no_time_of_day},
    {"sun_preset", "", "", no_time_of_day},
    {"tm_blend_distance_factor", "", "", no_blend},
    {"tm_blend_max_alpha", "", "", no_blend},
    {"tm_blend_scale_border", "", "", no_blend},
    {"tm_blend_scale_center", "", "", no_blend},
    {"tm_blend_scale_fade_exp", "", "", no_blend},
    {"tm_debug", "", "", "`view` lists what can be shown."},
    {"tm_dyn_range_stops", "", "", no_curve},
    {"tm_enable", "pt_tonemap", "none|filmic", "pt_tonemap has a third curve, reinhard."},
    {"tm_exposure_bias", "pt_exposure_bias", "same", "Both are stops. The default there is -1."},
    {"tm_exposure_speed_down", "pt_exposure_speed", "same", "One speed serves both ways."},
    {"tm_exposure_speed_up", "pt_exposure_speed", "same", "One speed serves both ways."},
    {"tm_hdr_peak_nits", "", "", no_hdr},
    {"tm_hdr_saturation_scale", "", "", no_hdr},
    {"tm_high_percentile", "", "", no_histogram},
    {"tm_knee_start", "", "", no_curve},
    {"tm_low_percentile", "", "", no_histogram},
    {"tm_max_luminance", "", "", no_histogram},
    {"tm_min_luminance", "", "", no_histogram},
    {"tm_noise_blend", "", "", no_curve},
    {"tm_noise_stops", "", "", no_curve},
    {"tm_reinhard", "pt_tonemap", "filmic|reinhard", "There is no blend of both curves."},
    {"tm_slope_blur_sigma", "", "", no_curve},
    {"tm_white_point", "", "", no_curve},
    {"ui_hdr_nits", "", "", no_hdr},
    {"vid_rtx", "", "", "Vigil always traces paths."},
    {"viewsize", "vid_scale", "same", "Both are percents."},
};

} // namespace

std::span<const ForeignName> foreign_names() {
    return names;
}

const ForeignName* find_foreign_name(std::string_view name) {
    const auto* row = std::ranges::lower_bound(names, name, {}, &ForeignName::name);
    return row != std::end(names) && row->name == name ? row : nullptr;
}

std::string converted_value(const ForeignName& foreign, std::string_view text) {
    const std::string_view how = foreign.convert;
    if (how == "same") return std::string(text);
    float value = 0.0f;
    if (!parse_number(text, value)) fail("{}: \"{}\" is not a number", foreign.name, text);
    if (how == "exp2") return fmt::format("{:.6g}", std::exp2(value));
    if (how == "up") return fmt::format("{:.6g}", std::ceil(value));
    if (how.starts_with('*')) {
        float factor = 1.0f;
        parse_number(how.substr(1), factor);
        return fmt::format("{:.6g}", value * factor);
    }
    const size_t bar = how.find('|');
    return std::string(value > 0.0f ? how.substr(bar + 1) : how.substr(0, bar));
}

std::string describe_foreign_name(const ForeignName& foreign) {
    if (foreign.target.empty())
        return fmt::format("{} of Quake II RTX has no counterpart here. {}", foreign.name,
                           foreign.about);
    const std::string_view how = foreign.convert;
    std::string conversion;
    if (const size_t bar = how.find('|'); bar != std::string_view::npos)
        conversion = fmt::format(" 0 is {}, more is {}.", how.substr(0, bar), how.substr(bar + 1));
    else if (how == "exp2")
        conversion = " The value here is 2 to the power of it.";
    else if (how == "up")
        conversion = " The value here is the next whole number.";
    else if (how.starts_with('*'))
        conversion = fmt::format(" The value here is {} times it.", how.substr(1));
    return fmt::format("{} is an alias for {}, as Quake II RTX calls it.{} {}", foreign.name,
                       foreign.target, conversion, foreign.about);
}

} // namespace vigil
