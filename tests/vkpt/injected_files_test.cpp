// SPDX-License-Identifier: GPL-2.0-or-later
// The same files give the same picture, whether they lie in a folder or a front end brings them.
#include "common/memory_source.h"
#include "render_test.h"

namespace vigil::test {
namespace {

class InjectedFilesTest : public RenderTest {};

TEST_F(InjectedFilesTest, AreDrawn) {
    const refresh::Settings settings = cvars().values();
    const Shot shot{{{150, 128, 60}, {5, 20, 0}, 90}, {}, {}};
    refresh::Frame frame = shot.frame();
    frame.settings = settings;
    const auto draw = [&](refresh::Renderer& from, const FileSystem& source) {
        from.load_level(load_level(source, "rooms"), settings);
        from.render(frame);
        return from.read_radiance().rgb;
    };

    MemorySource::Files content;
    for (const std::string& path : files().list("", ""))
        content.emplace(ascii_lower(path), files().read(path));
    FileSystem memory;
    memory.mount(std::make_unique<MemorySource>(std::move(content)));
    vkpt::VkptRenderer other(memory, nullptr, settings);
    const std::vector<float> from_memory = draw(other, memory);
    EXPECT_GT(sum_of(from_memory), 0.0);
    EXPECT_EQ(from_memory, draw(renderer(), files()));
    EXPECT_EQ(other.health().validation_messages, 0);
}

} // namespace
} // namespace vigil::test
