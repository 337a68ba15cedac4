// SPDX-License-Identifier: GPL-2.0-or-later
// The renderer's interface: what a frame is (settings, view, entities, lights, pictures on top) and
// what comes back (a picture, linear radiance, times per pass). A front end fills a Frame, and
// refresh/vkpt draws it; tests/examples/one_frame.cpp is the shortest. docs/internals/front-end.md
// has the order of calls, and what happens where numbers do not stay the same. Functions throw
// Error or std::bad_alloc, nothing else. Nothing here knows Vulkan beyond the opaque handles a
// window needs to make a surface.
#pragma once

#include "refresh/reports.h"
#include "refresh/settings.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct ImDrawData;
struct VkInstance_T;
struct VkSurfaceKHR_T;

namespace vigil {
class FileSystem;
struct Level;
} // namespace vigil

namespace vigil::refresh {

/// The camera. Angles in degrees: pitch (down positive), yaw (counter-clockwise from +x), roll.
/// `fov` is Quake's: horizontal degrees on a 4:3 screen; wider screens see more (vertical angle
/// kept). Where `fov_y` is above 0 it is the vertical angle in degrees, and `fov` says nothing.
/// Pixels are square: the horizontal angle follows.
struct View {
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f};
    float fov = 90.0f;
    float fov_y = 0.0f;
};

/// Index of a registered model; -1 draws nothing.
using ModelHandle = int;

/// Index of a registered skin; -1: the model's own.
using SkinHandle = int;

/// Bits of Entity::flags. A path tracer sends camera rays, and from what they hit indirect rays and
/// shadow rays ("light rays" together).
enum EntityFlags : uint32_t {
    /// Camera rays pass through it; it casts shadows, is reflected and lights as ever: the player's
    /// own body.
    entity_hidden_from_camera = 1,
    /// Light rays pass through it: it casts no shadow, also none on itself, and nothing is lit by
    /// it; its lamps are dark. Light falls on it as on anything.
    entity_hidden_from_light = 2,
    /// Camera rays see it before all that lacks this flag, however far away: a weapon that reaches
    /// into a wall. Light falls on it where it is: what lies behind the wall is lit as there.
    entity_in_front = 4,
    entity_weapon = entity_hidden_from_light | entity_in_front,
};

/// One placed model. `number` is unique in a frame and stays the same while the entity exists; see
/// docs/internals/front-end.md for what happens where it does not.
struct Entity {
    int number = 0;
    ModelHandle model = -1;
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f}; // sprites look where the camera does instead
    // Factors on its distance to the right of the line of sight, and above it: a weapon with an
    // angle of view of its own, or, where the first is below 0, in the other hand. Not 0.
    glm::vec2 view_scale{1.0f};
    int skin = 0;  // of .md2: among the model's own
    int frame = 0; // of .md2: shown is mix(frame, old_frame, backlerp); of .sp2: the picture
    int old_frame = 0;
    float backlerp = 0.0f;
    // Opacity in steps of 1 / 255: the chance that a ray stops at a triangle (a factor on that of
    // translucent faces). Below 1 triangles exist from their front only. 0 draws nothing.
    float alpha = 1.0f;
    uint32_t flags = 0; // EntityFlags
    // Radiance (linear RGB) that a white texel shows to camera rays besides what it reflects. It
    // lights nothing. particle_radiance is full brightness.
    glm::vec3 glow{0.0f};
    // Of .md2, unless it is 0: the model as a shell of this colour, 4 units outside of itself (0.5
    // with entity_in_front). It shines as a Particle does, and light rays pass through it.
    glm::vec3 shell{0.0f};
    SkinHandle custom_skin = -1; // of .md2
};

/// A small glowing octahedron of `radius` units around `origin` that emits `radiance` (linear RGB).
/// `id` stays the same while the light exists. Camera rays pass through it unless it is `visible`.
struct DynamicLight {
    uint32_t id = 0;
    glm::vec3 origin{0.0f};
    float radius = 2.0f;
    glm::vec3 radiance{0.0f};
    bool visible = true;
};

/// A thin glowing spindle between two points (a laser); light as from a DynamicLight. `radius` is
/// that of its middle in map units; `id` stays the same while the beam exists.
struct Beam {
    uint32_t id = 0;
    glm::vec3 from{0.0f};
    glm::vec3 to{0.0f};
    float radius = 1.0f;
    glm::vec3 radiance{0.0f};
};

/// A torch: a square that emits `radiance` from the bottom of an open black tube, whose mouth is at
/// `origin` and looks along `angles` (as a View's; roll turns it). `radius` is the tube's. Surfaces
/// within 10 degrees of its axis see the whole square, beyond 30 degrees none of it. A light as any
/// other, that the tube shades. `id` stays the same while it exists.
struct Spot {
    uint32_t id = 0;
    glm::vec3 origin{0.0f};
    glm::vec3 angles{0.0f};
    float radius = 1.5f;
    glm::vec3 radiance{0.0f};
};

/// A spark or drop: a small triangle that faces the camera. It shows to the camera with the
/// radiance `color` * particle_radiance and casts a shadow, but lights nothing: it is too small to
/// matter, and there are many.
struct Particle {
    glm::vec3 origin{0.0f};
    float size = 1.0f;     // from the middle to the corners, in map units
    glm::vec3 color{1.0f}; // linear, 0..1; there should be few different ones
    float alpha = 1.0f;    // as an Entity's

    bool operator==(const Particle&) const = default;
};

/// Index of a registered picture.
using PictureHandle = int;
inline constexpr PictureHandle no_picture = -1;

/// A rectangle of the screen, drawn over the world: a part of a picture, scaled to it without a
/// filter, or a colour alone. Later ones cover earlier ones. Corners and sizes are in pixels, from
/// the top left; what lies outside the clip rectangle or the screen is not drawn.
struct Draw {
    PictureHandle picture = no_picture;
    glm::ivec2 corner{0};
    glm::ivec2 size{0};
    glm::vec2 from{0.0f}; // the part of the picture: 0..1, from its top left
    glm::vec2 to{1.0f};
    // Factor on its colours (sRGB-encoded) and opacity; without a picture, colour and opacity.
    glm::vec4 color{1.0f};
    glm::ivec2 clip_corner{0};
    glm::ivec2 clip_size{std::numeric_limits<int>::max()};
};

/// Radiance that stands for what the first Quake II draws at full brightness
/// (docs/internals/units.md).
inline constexpr float particle_radiance = 20.0f;

/// Radiance that the first Quake II's things shine of themselves: those that are never quite dark
/// (its flag for a least light), and those to pick up, which pulse with its clock.
inline float game_glow(bool never_dark, bool to_pick_up, double seconds) {
    constexpr double part = 0.02, radians_per_s = 7.0;
    const double pulse = 0.5 + 0.5 * std::sin(radians_per_s * seconds);
    return particle_radiance *
           static_cast<float>((never_dark ? part : 0.0) + (to_pick_up ? part * pulse : 0.0));
}

/// The first Quake II's light of an effect, with the radius that its game gives, is a ball of
/// game_light_size times that radius, and its colour times game_light_radiance times that radius is
/// the ball's radiance (docs/internals/units.md says why).
inline constexpr float game_light_size = 1.0f / 25.0f, game_light_radiance = 11.4f;

/// Light styles are multipliers of emitted radiance; Quake II has 256.
inline constexpr int light_style_count = 256;

struct Frame {
    Settings settings; // those of construction (vk_) are not looked at again
    View view;
    double time_s = 0.0; // drives warping, scrolling and animated textures
    std::span<const Entity> entities;
    std::span<const DynamicLight> dynamic_lights;
    std::span<const Beam> beams;
    std::span<const Spot> spots;
    std::span<const Particle> particles;
    std::array<float, light_style_count> light_styles{};
    std::span<const Draw> draws;   // part of the picture; also before a level is loaded, over black
    bool show_level = true;        // false: as before a level is loaded: a film, a menu
    ImDrawData* overlay = nullptr; // console and menus, drawn over the picture; may be null
    bool uncapped = false;         // the display is not waited for, whatever vid_vsync says
};

/// A picture in 8-bit sRGB, RGBA, rows from the top.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<uint8_t> rgba;
};

/// Linear radiance (RGB floats, rows from the top).
struct RadiancePicture {
    int width = 0;
    int height = 0;
    int frames = 0; // frames averaged
    std::vector<float> rgb;
};

/// What a pass belongs to in reports, as the paper's figures 11 and 12 have it.
enum class PassGroup {
    Other,
    Preparation, ///< octree, caches, quadtrees
    PathTracing,
    Filter ///< what makes a calm picture of it
};

struct PassTime {
    std::string name;
    double milliseconds = 0.0;
    PassGroup group = PassGroup::Other;
};

/// A number that was counted in a frame, by name: of the octree and the light caches.
struct FrameCount {
    std::string name;
    double value = 0.0;
};

/// Bytes that the host copied into a buffer of this name.
struct Upload {
    std::string name;
    uint64_t bytes = 0;
};

/// What was measured in one frame: GPU times in the order of its passes (empty on devices without
/// timestamps), what guiding counted (empty while it is off), and what was copied for it since the
/// frame before, by name (its overlay aside).
struct FrameTimes {
    uint64_t frame = 0; // as Renderer::render returned it
    std::vector<PassTime> passes;
    std::vector<FrameCount> counts;
    std::vector<Upload> uploads;
};

/// What should never happen, counted since the renderer was made.
struct Health {
    uint32_t nonfinite = 0;      // values that were not finite, or negative, and count as 0
    int validation_messages = 0; // warnings and errors of the validation layer, while it is on
};

/// What render() waits for before it can trace: shaders on their way through the driver's compiler.
struct Compilation {
    std::vector<std::string> passes; ///< whose shaders are under way
    int done = 0;                    ///< passes
    int total = 0;                   ///< passes; all of them are done in the last report
    float share = 0.0f;              ///< of the work, 0..1, by the sizes of the shaders
    double seconds = 0.0;            ///< waited so far
};

/// Hears of a wait that is worth telling of, several times a second until it is over.
class CompilationWatcher {
public:
    virtual ~CompilationWatcher() = default;
    /// What is drawn over the last picture meanwhile; may be null. The last time it takes the place
    /// of Frame::overlay. An Error that it throws ends render(), and no other may follow.
    virtual ImDrawData* compiling(const Compilation& state) = 0;
};

/// What a window offers the renderer. Implemented by platform/sdl2 and platform/glfw.
class SurfaceProvider {
public:
    virtual ~SurfaceProvider() = default;
    /// Vulkan instance extensions that create_surface needs.
    virtual std::vector<std::string> instance_extensions() const = 0;
    /// Makes a VkSurfaceKHR; throws Error. The renderer destroys it.
    virtual VkSurfaceKHR_T* create_surface(VkInstance_T* instance) = 0;
    /// Size in pixels now; (0, 0) while minimised.
    virtual glm::ivec2 framebuffer_size() const = 0;
};

class Renderer {
public:
    virtual ~Renderer() = default;

    /// Uploads a level: geometry, materials, lights. Forgets all models of the level before. Throws
    /// Error and then keeps the level before. Random numbers start anew: the same frames after it
    /// are the same pictures. Of the settings it takes pt_subdivide.
    virtual void load_level(std::shared_ptr<const Level> level, const Settings& settings) = 0;

    /// Handle of "*3" (brush model), "models/x.md2", "models/x.glb" or "sprites/x.sp2"; loads it on
    /// first use. Light rays pass through sprites; their pictures' alpha is coverage, texel by
    /// texel. Throws Error naming the file and the fault.
    virtual ModelHandle register_model(std::string_view name) = 0;

    /// Handle of a picture that Entity::custom_skin may name, while the level lasts. Throws Error
    /// naming the file if it cannot be read.
    virtual SkinHandle register_skin(std::string_view name) = 0;

    /// Shows another sky box ("env/NAMErt.pcx" and so on) than the level asks for, until the next
    /// level. It turns with the frames' time about `axis`; the sun stays. Without pictures of that
    /// name the sky is plain. Throws Error if no level is loaded.
    virtual void set_sky(std::string_view name, float degrees_per_second, glm::vec3 axis) = 0;

    /// Handle of a picture for Draw, any image file ("pics/tag1.pcx", "textures/a.png"); loads it
    /// on first use. Levels come and go, pictures stay. Throws Error naming the file and the fault.
    virtual PictureHandle register_picture(std::string_view name) = 0;
    /// Handle of a picture that the front end makes itself: a film, the preview of a model. Each
    /// call makes another; it is transparent until change_picture says what it shows. Throws Error
    /// if a side is not 1 to 4,096 texels.
    virtual PictureHandle make_picture(glm::ivec2 size) = 0;
    /// What a picture shows from the next frame on, whoever made it: RGBA, sRGB, rows from the top.
    /// Throws Error if there is no such picture, or if it has another number of texels.
    virtual void change_picture(PictureHandle picture, std::span<const uint8_t> rgba) = 0;
    /// Its size in texels. Throws Error if there is no such picture.
    virtual glm::ivec2 picture_size(PictureHandle picture) const = 0;

    /// Renders one frame and, with a window, presents it. Before a level is loaded it shows draws
    /// and overlay over black. Before the first filtered frame of a level, unless it is uncapped,
    /// flt_first more are traced that nobody sees. Returns the frame's number, counted from 0,
    /// those included. Throws Error if a draw names no picture, and then has done nothing; or if
    /// memory or device fail, and then throws again until a level is loaded.
    virtual uint64_t render(const Frame& frame) = 0;

    /// Who is told while render() waits for a compiler; null: nobody. It must outlive the renderer,
    /// or be taken back.
    virtual void watch_compilation(CompilationWatcher* /*watcher*/) {}
    /// Whether shaders are being compiled; that cannot be broken off.
    virtual bool compiling() const { return false; }

    /// The last frame after tone mapping, with or without its overlay. Throws Error without one.
    virtual Picture read_picture(bool with_overlay) = 0;
    /// The last frame's radiance: filtered with flt_enable, averaged over frames while
    /// pt_accumulate is on. Throws Error if there is none.
    virtual RadiancePicture read_radiance() = 0;

    /// Times of the frames that the GPU has finished since the last call, oldest first, without
    /// waiting; with `wait`, of all frames rendered so far. At most the last 1,024 are kept.
    virtual std::vector<FrameTimes> take_frame_times(bool wait) = 0;

    /// Waits for the device.
    virtual Health health() const = 0;
    /// Names of device and driver, in one line.
    virtual std::string device_name() const = 0;
    // Reports wait for the device; they throw Error before a level is loaded.
    /// What a frame with these settings traces, and how.
    virtual SceneReport report_scene(const Settings& settings) const = 0;
    virtual GuidingReport report_guiding() const = 0;
    /// Forgets what frames have taught, octree and light caches first of all: the next frame learns
    /// anew.
    virtual void reset_guiding() = 0;
    /// Writes the level with this view as glTF 2.0 (PATH.gltf + PATH.bin + textures);
    /// docs/internals/export.md has units.
    virtual void export_scene(const Frame& frame, const std::string& path) = 0;
};

/// Makes the Vulkan path tracer. `surface` may be null (headless: pictures of vid_width x
/// vid_height). Throws Error that says which package to install when there is no Vulkan driver.
std::unique_ptr<Renderer> make_vkpt_renderer(FileSystem& files, SurfaceProvider* surface,
                                             const Settings& settings);

} // namespace vigil::refresh
