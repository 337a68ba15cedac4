// SPDX-License-Identifier: GPL-2.0-or-later
// What the programs do when Vulkan fails: whichever call it is and whenever it happens, they end
// with one message that names the fault and with exit status 1, and what was finished is kept.
#include "common/process.h"
#include "common/scratch_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
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
                {"VK_LAYER_PATH", VIGIL_LAYERS},
                {"VK_INSTANCE_LAYERS", "VK_LAYER_VIGIL_fault"},
                // Compiled shaders are kept from run to run, apart from the user's.
                {"XDG_CACHE_HOME", (std::filesystem::current_path() / "test-cache").string()},
                {"XDG_CONFIG_HOME", file("config")}});
    }

    Outcome outcome_of(Process& program) const {
        const int status = program.wait();
        return {status, text_of("log")};
    }

    /// Renders a level without a window, at two sizes, and takes a picture.
    Outcome render(const std::string& fault) const {
        return outcome_of(*start(VIGIL, fault,
                                 headless() + " +map rooms +wait 3 +set vid_width 80 +wait 2 "
                                              "+screenshot"));
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

struct FailingCall {
    const char* call; // and its result
    const char* word; // of the message
};

class AnyCall : public Faults, public testing::WithParamInterface<FailingCall> {};

TEST_P(AnyCall, EndsTheProgramWithAMessage) {
    // Up to where the fault comes after the end.
    int first = 1, failed = 0;
    for (;; first += 1 + first) {
        const Outcome outcome = render(std::string(GetParam().call) + " " + std::to_string(first));
        if (outcome.status == 0) {
            EXPECT_EQ(outcome.errors(), 0) << outcome.text;
            break;
        }
        ++failed;
        EXPECT_EQ(outcome.status, 1) << "call " << first << '\n' << outcome.text;
        EXPECT_GE(outcome.errors(), 1) << outcome.text;
        EXPECT_LE(outcome.errors(), 2) << outcome.text; // of the command, and of the program
        EXPECT_NE(outcome.text.find(GetParam().word), std::string::npos) << outcome.text;
        ASSERT_LT(first, 1000);
    }
    EXPECT_GE(failed, 1) << "the fault was not met";
}

INSTANTIATE_TEST_SUITE_P(
    Calls, AnyCall,
    testing::Values(FailingCall{"vkAllocateMemory -2", "out of device memory"},
                    FailingCall{"vkBindBufferMemory -2", "out of device memory"},
                    FailingCall{"vkCreateBuffer -1", "out of host memory"},
                    FailingCall{"vkCreateImage -2", "out of device memory"},
                    FailingCall{"vkCreateComputePipelines -1", "out of host memory"},
                    FailingCall{"vkMapMemory -5", "vkMapMemory"},
                    FailingCall{"vkQueueSubmit -4", "device was lost"},
                    FailingCall{"vkWaitForFences -4", "device was lost"}),
    [](const auto& instance) {
        const std::string call = instance.param.call;
        return call.substr(0, call.find(' '));
    });

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
    const Outcome outcome = render("vkQueueSubmit -4 1000000");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
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
    EXPECT_NE(outcome.text.find("reported is what was finished"), std::string::npos)
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
