// SPDX-License-Identifier: GPL-2.0-or-later
// The pipeline cache on disk: whatever lies there, pipelines are made, one line at most says that
// the file was of no use, and a good one takes its place.
#include "refresh/vkpt/gpu/pipeline.h"

#include "common/full_disk.h"
#include "common/scratch_folder.h"
#include "common/sealed.h"
#include "empty.comp.h"
#include "gpu/validated.h"

#include <cstring>
#include <random>

namespace vigil::gpu {
namespace {

using test::LogCapture;
using test::read_whole;

constexpr std::string_view kind = "vigil pipelines 1";

class PipelineCacheTest : public testing::Test {
protected:
    PipelineCacheTest() : device_(test::validated(), nullptr) {}
    ~PipelineCacheTest() override { EXPECT_EQ(device_.validation_messages(), 0); }
    /// Opens the cache, makes a pipeline with it and saves it; returns what was logged.
    std::vector<LogCapture::Line> use() {
        const LogCapture log;
        {
            const PipelineCache cache(device_, file_);
            const PipelineLayout layout(device_, {});
            const ComputePipeline pipeline(device_, layout, &cache, empty_comp, {}, "empty");
            EXPECT_TRUE(pipeline);
        }
        return log.lines;
    }

    std::span<const std::byte> content_of(const std::string& file) const {
        return unseal(kind, std::as_bytes(std::span(file))).value();
    }

    test::ScratchFolder folder_;
    const std::filesystem::path file_ = folder_.path() / "cache" / "pipelines.bin";
    Device device_;
};

TEST_F(PipelineCacheTest, IsKeptForTheNextTime) {
    EXPECT_TRUE(use().empty());
    const std::string first = read_whole(file_);
    EXPECT_GE(content_of(first).size(), sizeof(VkPipelineCacheHeaderVersionOne));
    EXPECT_TRUE(use().empty());
    EXPECT_EQ(read_whole(file_), first);
}

TEST_F(PipelineCacheTest, AnythingElseIsReplacedWithOneMessage) {
    use();
    const std::string good = read_whole(file_);
    std::mt19937 random(1);
    std::string noise(5000, '\0');
    for (char& c : noise)
        c = static_cast<char>(random());
    std::string damaged = good;
    damaged[good.size() - 3] = static_cast<char>(damaged[good.size() - 3] ^ 0x10);
    // Another driver's: a good seal around a header with another UUID.
    const auto content = content_of(good);
    std::vector<std::byte> foreign(content.begin(), content.end());
    foreign[offsetof(VkPipelineCacheHeaderVersionOne, pipelineCacheUUID)] ^= std::byte{1};
    // As the driver writes it, without a seal.
    const std::string bare(reinterpret_cast<const char*>(content.data()), content.size());

    for (const std::string& bytes : {noise, good.substr(0, good.size() / 2), damaged,
                                     seal(kind, foreign), bare, seal(kind, {}), std::string("x")}) {
        folder_.write("cache/pipelines.bin", bytes);
        const auto lines = use();
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_NE(lines[0].text.find("pipelines.bin: from another device or driver, or damaged"),
                  std::string::npos)
            << lines[0].text;
        EXPECT_TRUE(use().empty()) << "a good one took its place";
    }
}

TEST_F(PipelineCacheTest, AFolderInItsPlaceIsLeftAlone) {
    std::filesystem::create_directories(file_);
    const auto lines = use();
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].text.find("the pipeline cache is not saved"), std::string::npos);
    EXPECT_NE(lines[0].text.find("pipelines.bin: cannot replace: Is a directory"),
              std::string::npos);
}

TEST_F(PipelineCacheTest, AFullDiskKeepsTheOldFile) {
    folder_.write("cache/pipelines.bin", "old");
    std::vector<LogCapture::Line> lines;
    {
        const test::FullDisk disk(16);
        lines = use();
    }
    ASSERT_EQ(lines.size(), 2u); // the damaged one, and the new one that cannot be written
    EXPECT_NE(lines[1].text.find("the pipeline cache is not saved"), std::string::npos);
    EXPECT_NE(lines[1].text.find("pipelines.bin: cannot write: File too large"), std::string::npos);
    EXPECT_EQ(read_whole(file_), "old");
}

} // namespace
} // namespace vigil::gpu
