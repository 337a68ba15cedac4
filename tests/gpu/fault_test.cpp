// SPDX-License-Identifier: GPL-2.0-or-later
// What the programs do when Vulkan fails: whichever call it is, whenever it happens, and whether it
// fails for good or for once. They go on, or they end with one message that names the fault and
// with exit status 1; they destroy what they made, and what was finished is kept. Each call is
// failed for good at its first time, and once at its middle and its last time; with
// VIGIL_FAULTS=all at every time.
#include "common/process.h"
#include "common/scratch_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <thread>

namespace vigil::test {
namespace {

struct Outcome {
    int status = 0; // 128 + signal where one ended it
    std::string text;
    long errors() const {
        std::istringstream lines(text);
        long count = 0;
        for (std::string line; std::getline(lines, line);)
            count += line.starts_with("error: ");
        return count;
    }
};

class Faults : public testing::Test {
protected:
    /// Starts a program with a fault (fault_layer.cpp), its words split at spaces.
    std::unique_ptr<Process> start(const char* program, const std::string& fault,
                                   const std::string& text) const {
        std::istringstream stream(text);
        std::vector<std::string> words = {program};
        for (std::string word; stream >> word;)
            words.push_back(word);
        std::filesystem::remove(file("log"));
        return std::make_unique<Process>(
            words, file("log"),
            std::map<std::string, std::string>{
                {"VIGIL_FAULT", fault},
                {"VIGIL_FAULT_COUNTS", file("counts")},
                {"VK_LAYER_PATH", VIGIL_LAYERS},
                {"VK_INSTANCE_LAYERS", "VK_LAYER_VIGIL_fault"},
                // Compiled shaders are kept from run to run, apart from the user's.
                {"XDG_CACHE_HOME", (std::filesystem::current_path() / "test-cache").string()},
                {"XDG_CONFIG_HOME", file("config")}});
    }

    Outcome outcome_of(Process& program) const {
        // Compiling all shaders anew takes minutes on a software driver.
        const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(15);
        while (program.running() && std::chrono::steady_clock::now() < last)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        EXPECT_FALSE(program.running()) << "it does not end";
        program.send(SIGKILL);
        const int status = program.wait();
        return {status, text_of("log")};
    }

    /// Renders a level without a window, at two sizes, and takes a picture.
    Outcome render(const std::string& fault) const {
        return outcome_of(*start(VIGIL, fault,
                                 headless() + " +set pt_nee vlc +map rooms +wait 3 +set vid_width "
                                              "80 +wait 2 +screenshot"));
    }

    /// Shows a level in a window, with something drawn over it, and takes a picture.
    Outcome show(const std::string& fault) const {
        return outcome_of(*start(VIGIL, fault,
                                 headless() + " +set vid_driver sdl +set vid_vsync 0 +set "
                                              "scr_stats 1 +map rooms +wait 4 +screenshot +quit"));
    }

    std::string headless(const std::string& data = "/tests/data") const {
        return "+set basedir " + (VIGIL_SOURCE_DIR + data) + " +set outdir " +
               folder_.path().string() +
               " +set vid_driver headless +set vid_width 64 +set vid_height 48";
    }

    std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
    std::string text_of(const std::string& name) const {
        std::ifstream stream(file(name));
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    nlohmann::json report_of(const std::string& name) const {
        const auto report = nlohmann::json::parse(text_of(name), nullptr, false);
        return report.is_object() ? report : nlohmann::json::object(); // nothing is there yet
    }

    ScratchFolder folder_;
};

/// Whether the program ends where a call fails.
enum class Ends {
    Yes,
    Sometimes, // not where nothing depends on it any more
    No,
};

struct FailingCall {
    const char* call;
    int result;
    Ends ends = Ends::Yes;
    const char* word = nullptr; // of the message; the call's name where there is none here
    bool window = false;
};

void PrintTo(const FailingCall& row, std::ostream* out) {
    *out << row.call;
}

class AnyCall : public Faults, public testing::WithParamInterface<FailingCall> {
protected:
    Outcome run(const std::string& fault) const {
        return GetParam().window ? show(fault) : render(fault);
    }

    /// How often the call is made where nothing fails.
    long calls_without_a_fault() const {
        static std::map<bool, std::map<std::string, long>> known; // by GetParam().window
        std::map<std::string, long>& counts = known[GetParam().window];
        if (counts.empty()) {
            const Outcome outcome = run("");
            EXPECT_EQ(outcome.status, 0) << outcome.text;
            counts = calls_of_last_run();
        }
        return counts[GetParam().call];
    }

    std::map<std::string, long> calls_of_last_run() const {
        std::map<std::string, long> counts;
        std::istringstream lines(text_of("counts"));
        std::string name;
        for (long number = 0; lines >> name >> number;)
            counts[name] = number;
        return counts;
    }

    /// Fails the call from its time `first` on, so many times; always for -1. A run that waits less
    /// for the driver's compiler draws fewer frames: where it never came to that time, its last
    /// one is failed.
    void expect_good_end(long first, long times) const {
        const FailingCall& row = GetParam();
        const std::string fault = fmt::format("{} {} {}{}", row.call, row.result, first,
                                              times < 0 ? "" : fmt::format(" {}", times));
        SCOPED_TRACE(fault);
        std::filesystem::remove(file("vigil0000.png"));
        const Outcome outcome = run(fault);
        EXPECT_EQ(outcome.text.find("fault layer: "), std::string::npos) << outcome.text;
        const long made = calls_of_last_run()[row.call];
        if (outcome.status == 0 && made < first) {
            ASSERT_GE(made, 1) << outcome.text;
            return expect_good_end(made, times);
        }
        if (outcome.status == 0) {
            const bool always = first == 1 && times < 0;
            EXPECT_TRUE(row.ends == Ends::No || (row.ends == Ends::Sometimes && !always))
                << "the failure was not noticed\n"
                << outcome.text;
            EXPECT_EQ(outcome.errors(), 0) << outcome.text;
            EXPECT_TRUE(std::filesystem::exists(file("vigil0000.png"))) << outcome.text;
            return;
        }
        EXPECT_NE(row.ends, Ends::No) << outcome.text;
        EXPECT_EQ(outcome.status, 1) << outcome.text;
        EXPECT_GE(outcome.errors(), 1) << outcome.text;
        EXPECT_LE(outcome.errors(), 2) << outcome.text; // of the command, and of the program
        const std::string word = row.word != nullptr ? row.word : row.call;
        EXPECT_NE(outcome.text.find(word), std::string::npos) << outcome.text;
    }
};

TEST_P(AnyCall, EndsTheProgramWithAMessageOrLetsItGoOn) {
    if (GetParam().window && std::getenv("DISPLAY") == nullptr)
        GTEST_SKIP() << "no display: windows cannot be tested";
    const long calls = calls_without_a_fault();
    ASSERT_GE(calls, 1) << "the program never makes this call";
    const char* const which = std::getenv("VIGIL_FAULTS");
    if (which != nullptr && std::string(which) == "all") {
        for (long first = 1; first <= calls && !HasFailure(); ++first)
            for (const long times : {-1, 1, 2})
                expect_good_end(first, times);
        return;
    }
    expect_good_end(1, -1);
    for (const long first : std::set<long>{(calls + 1) / 2, calls})
        expect_good_end(first, 1);
}

constexpr int out_of_host_memory = -1, out_of_device_memory = -2, initialization_failed = -3,
              device_lost = -4, map_failed = -5, surface_lost = -1000000000,
              out_of_date = -1000001004;

INSTANTIATE_TEST_SUITE_P(
    Calls, AnyCall,
    testing::Values(
        FailingCall{"vkAllocateCommandBuffers", out_of_host_memory},
        FailingCall{"vkAllocateDescriptorSets", out_of_device_memory},
        FailingCall{"vkAllocateMemory", out_of_device_memory, Ends::Yes, "out of device memory"},
        FailingCall{"vkBeginCommandBuffer", out_of_host_memory},
        FailingCall{"vkBindBufferMemory", out_of_device_memory},
        FailingCall{"vkBindImageMemory", out_of_device_memory},
        FailingCall{"vkCreateBuffer", out_of_host_memory},
        FailingCall{"vkCreateBufferView", out_of_device_memory},
        FailingCall{"vkCreateCommandPool", out_of_host_memory},
        FailingCall{"vkCreateComputePipelines", out_of_host_memory},
        FailingCall{"vkCreateDescriptorPool", out_of_device_memory},
        FailingCall{"vkCreateDescriptorSetLayout", out_of_host_memory},
        FailingCall{"vkCreateDevice", initialization_failed},
        FailingCall{"vkCreateFence", out_of_host_memory},
        FailingCall{"vkCreateImage", out_of_device_memory},
        FailingCall{"vkCreateImageView", out_of_device_memory},
        FailingCall{"vkCreateInstance", initialization_failed},
        FailingCall{"vkCreatePipelineCache", out_of_host_memory},
        FailingCall{"vkCreatePipelineLayout", out_of_host_memory},
        FailingCall{"vkCreateQueryPool", out_of_device_memory},
        FailingCall{"vkCreateShaderModule", out_of_host_memory},
        FailingCall{"vkDeviceWaitIdle", device_lost, Ends::Sometimes, "device was lost"},
        FailingCall{"vkEndCommandBuffer", out_of_host_memory},
        FailingCall{"vkEnumeratePhysicalDevices", out_of_host_memory},
        FailingCall{"vkGetPipelineCacheData", out_of_host_memory, Ends::No},
        FailingCall{"vkGetQueryPoolResults", out_of_host_memory, Ends::No},
        FailingCall{"vkMapMemory", map_failed},
        FailingCall{"vkQueueSubmit", device_lost, Ends::Yes, "device was lost"},
        FailingCall{"vkResetCommandPool", out_of_device_memory},
        FailingCall{"vkResetFences", out_of_device_memory},
        FailingCall{"vkWaitForFences", device_lost, Ends::Yes, "device was lost"}),
    [](const auto& instance) { return std::string(instance.param.call); });

INSTANTIATE_TEST_SUITE_P(
    WindowCalls, AnyCall,
    testing::Values(
        FailingCall{"vkAcquireNextImageKHR", out_of_date, Ends::No, nullptr, true},
        FailingCall{"vkCreateFramebuffer", out_of_host_memory, Ends::Yes, nullptr, true},
        FailingCall{"vkCreateGraphicsPipelines", out_of_device_memory, Ends::Yes,
                    "imgui_impl_vulkan", true},
        FailingCall{"vkCreateRenderPass", out_of_host_memory, Ends::Yes, nullptr, true},
        FailingCall{"vkCreateSampler", out_of_device_memory, Ends::Yes, "imgui_impl_vulkan", true},
        FailingCall{"vkCreateSemaphore", out_of_host_memory, Ends::Yes, nullptr, true},
        FailingCall{"vkCreateSwapchainKHR", out_of_device_memory, Ends::Yes, nullptr, true},
        FailingCall{"vkGetPhysicalDeviceSurfaceCapabilitiesKHR", surface_lost, Ends::Yes, nullptr,
                    true},
        FailingCall{"vkGetPhysicalDeviceSurfaceFormatsKHR", out_of_host_memory, Ends::Yes, nullptr,
                    true},
        FailingCall{"vkGetPhysicalDeviceSurfacePresentModesKHR", out_of_host_memory, Ends::Yes,
                    nullptr, true},
        FailingCall{"vkGetPhysicalDeviceSurfaceSupportKHR", out_of_host_memory, Ends::No, nullptr,
                    true},
        FailingCall{"vkGetSwapchainImagesKHR", out_of_host_memory, Ends::Yes, nullptr, true},
        FailingCall{"vkQueuePresentKHR", out_of_date, Ends::No, nullptr, true}),
    [](const auto& instance) { return std::string(instance.param.call); });

// The surfaces of X; SDL asks for the first kind, GLFW for the second.
TEST_F(Faults, AWindowWithoutASurfaceEndsTheProgramWithAMessage) {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "no display: windows cannot be tested";
    constexpr std::pair<const char*, const char*> faults[] = {
        {"sdl", "vkCreateXlibSurfaceKHR -3 1"},        {"glfw", "vkCreateXcbSurfaceKHR -3 1"},
        {"sdl", "vkCreateSwapchainKHR -1000000000 1"}, {"sdl", "vkQueuePresentKHR -1000000000 3"},
        {"glfw", "vkQueuePresentKHR -1000000000 3"},   {"sdl", "vkAcquireNextImageKHR -4 3"}};
    for (const auto& [system, fault] : faults) {
        const Outcome outcome = outcome_of(*start(
            VIGIL, fault, headless() + " +set vid_driver " + system + " +map rooms +wait 9 +quit"));
        EXPECT_EQ(outcome.status, 1) << fault << '\n' << outcome.text;
        EXPECT_GE(outcome.errors(), 1) << outcome.text;
        EXPECT_TRUE(outcome.text.find("surface") != std::string::npos ||
                    outcome.text.find("device was lost") != std::string::npos)
            << outcome.text;
    }
}

TEST_F(Faults, WithoutAFaultTheLayerChangesNothing) {
    // It would tell of objects that are left, and of copies that the host reads without a barrier:
    // pictures, and the statistics of the guiding.
    const Outcome outcome = render("vkQueueSubmit -4 1000000");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(outcome.text.find("fault layer: "), std::string::npos) << outcome.text;
    EXPECT_TRUE(std::filesystem::exists(file("vigil0000.png")));
}

TEST_F(Faults, ALostDeviceLeavesTheRepetitionsThatAreFinished) {
    const std::string words =
        headless("/") + " +set timedemo 40 +set timedemo_json demo.json +demomap ring";
    const auto program = start(VIGIL, "vkQueueSubmit -4 @" + file("now"), words);
    // The second of Quake's lines: a repetition is finished, others are not.
    const auto lines = [&] {
        const std::string log = text_of("log");
        std::size_t count = 0;
        for (std::size_t at = log.find(" fps\n"); at != std::string::npos;
             at = log.find(" fps\n", at + 1))
            ++count;
        return count;
    };
    while (lines() < 1 && program->running())
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::ofstream(file("now")) << "now";
    const Outcome outcome = outcome_of(*program);
    EXPECT_EQ(outcome.status, 1) << outcome.text;
    EXPECT_NE(outcome.text.find("device was lost"), std::string::npos) << outcome.text;
    EXPECT_NE(outcome.text.find("the report has what was finished"), std::string::npos)
        << outcome.text;
    const nlohmann::json report = report_of("demo.json");
    const std::size_t finished = report.value("repetitions", nlohmann::json::array()).size();
    EXPECT_GE(finished, 1u) << outcome.text;
    EXPECT_LT(finished, 40u);
    std::size_t frames = 0;
    for (const auto& repetition : report["repetitions"])
        frames += repetition["frame_count"].get<std::size_t>();
    EXPECT_EQ(report["frames"].size(), frames);
}

TEST_F(Faults, ALostDeviceLeavesThePartsThatAreFinished) {
    const std::string words =
        std::string("quality --level rooms --level lamp --technique sll --views 1 --seeds 4 --size "
                    "64x36 --warmup 200 --reference-paths 16 --basedir ") +
        VIGIL_SOURCE_DIR + "/tests/data --set outdir " + folder_.path().string() + " --json " +
        file("quality.json");
    const auto program = start(VIGIL_BENCH, "vkQueueSubmit -4 @" + file("now"), words);
    const auto parts = [&] {
        return report_of("quality.json").value("parts", nlohmann::json::array()).size();
    };
    while (parts() == 0 && program->running())
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::ofstream(file("now")) << "now";
    const Outcome outcome = outcome_of(*program);
    EXPECT_EQ(outcome.status, 1) << outcome.text;
    EXPECT_NE(outcome.text.find("device was lost"), std::string::npos) << outcome.text;
    EXPECT_GE(parts(), 1u);
    EXPECT_FALSE(report_of("quality.json").value("finished", false));
}

} // namespace
} // namespace vigil::test
