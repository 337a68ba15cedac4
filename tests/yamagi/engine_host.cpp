// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine_host.h"

#include "common/error.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <gtest/gtest.h>

namespace vigil::test {

namespace {

/// The module has no reason to end the engine.
void fail_test(int, const char* text, ...) {
    ADD_FAILURE() << text;
}

} // namespace

using yamagi::EngineFunctions;
using yamagi::EngineVariable;
using yamagi::Flag;

EngineHost* EngineHost::running = nullptr;

EngineHost::EngineHost(std::string version, MemorySource::Files files) {
    running = this;
    files_.mount_folder(VIGIL_SOURCE_DIR "/tests/data/baseq2");
    files_.mount(std::make_unique<MemorySource>(std::move(files)));
    set("version", version);
    set("r_mode", "-1");
    set("r_customwidth", std::to_string(width));
    set("r_customheight", std::to_string(height));
    library_ = dlopen(VIGIL_MODULE, RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library_, nullptr) << dlerror();
    get_ = library_ != nullptr ? dlsym(library_, "GetRefAPI") : nullptr;
    EXPECT_NE(get_, nullptr);
}

EngineHost::~EngineHost() {
    if (functions_.shutdown != nullptr) functions_.shutdown();
    if (library_ != nullptr) dlclose(library_);
    running = nullptr;
}

void EngineHost::get_functions(int api) {
    ASSERT_NE(get_, nullptr);
    constexpr std::byte guard{0xa5};
    std::array<std::byte, 512> room{};
    room.fill(guard);
    const auto get = reinterpret_cast<void* (*)(void*, EngineFunctions)>(get_);
    EXPECT_EQ(get(room.data(), offered()), room.data());
    const size_t bytes = yamagi::bytes_of_api(api);
    EXPECT_TRUE(std::all_of(room.begin() + static_cast<ptrdiff_t>(bytes), room.end(),
                            [&](std::byte b) { return b == guard; }));
    // Before API 6 there was no drawable_size.
    functions_ = {};
    constexpr size_t added = offsetof(yamagi::ModuleFunctions, drawable_size);
    const size_t left_out = api <= 5 ? sizeof(void*) : 0;
    auto* const to = reinterpret_cast<std::byte*>(&functions_);
    std::memcpy(to, room.data(), added);
    std::memcpy(to + added + left_out, room.data() + added, bytes - added);
}

// ---- variables and commands ----

EngineHost::Variable& EngineHost::variable(const char* name, const char* default_text) {
    const auto [row, is_new] = variables_.try_emplace(name);
    if (is_new) {
        row->second.name = name;
        row->second.text = row->second.default_text = default_text;
        update(row->second);
    }
    return row->second;
}

void EngineHost::update(Variable& variable) {
    variable.shown.name = variable.name.c_str();
    variable.shown.text = variable.text.c_str();
    variable.shown.default_text = variable.default_text.c_str();
    variable.shown.value = std::strtof(variable.text.c_str(), nullptr);
    variable.shown.modified = 1;
}

void EngineHost::set(const std::string& name, const std::string& text) {
    Variable& found = variable(name.c_str(), "");
    found.text = text;
    update(found);
}

std::string EngineHost::text(const std::string& name) const {
    const auto row = variables_.find(name);
    return row != variables_.end() ? row->second.text : "(there is none)";
}

void EngineHost::run(const std::vector<std::string>& words) {
    const auto command = commands_.find(words.at(0));
    ASSERT_NE(command, commands_.end()) << words[0];
    words_ = words;
    command->second();
}

size_t EngineHost::count(std::string_view part) const {
    return static_cast<size_t>(std::ranges::count_if(
        lines, [&](const std::string& line) { return line.find(part) != std::string::npos; }));
}

HostPicture EngineHost::screenshot() {
    shot_ = {};
    run({"screenshot"});
    EXPECT_EQ(shot_.width, width);
    EXPECT_EQ(shot_.height, height);
    return shot_;
}

// ---- what the module may call ----

EngineFunctions EngineHost::offered() {
    EngineFunctions f{};
    f.error = fail_test;
    f.add_command = [](const char* name, void (*command)()) { running->commands_[name] = command; };
    f.remove_command = [](const char* name) { running->commands_.erase(name); };
    f.argument_count = [] { return static_cast<int>(running->words_.size()); };
    f.argument = [](int index) { return running->words_.at(static_cast<size_t>(index)).c_str(); };
    f.execute = [](int, const char*) {};
    f.print = [](int, const char* format, va_list arguments) {
        std::array<char, 4096> text{};
        std::vsnprintf(text.data(), text.size(), format, arguments);
        std::string line = text.data();
        EXPECT_TRUE(line.ends_with('\n'));
        line.pop_back();
        std::printf("    %s\n", line.c_str());
        running->lines.push_back(std::move(line));
    };
    f.load_file = [](const char* name, void** content) {
        if (content != nullptr) *content = nullptr;
        try {
            const auto found = running->files_.find(name);
            if (!found) return -1;
            if (content == nullptr) return static_cast<int>(found->bytes);
            const std::vector<uint8_t> bytes = running->files_.read(name);
            *content = std::malloc(bytes.size() + 1);
            std::memcpy(*content, bytes.data(), bytes.size());
            return static_cast<int>(bytes.size());
        } catch (const Error&) {
            return -1;
        }
    };
    f.free_file = [](void* content) { std::free(content); };
    f.game_folder = [] { return running->folder.c_str(); };
    f.variable = [](const char* name, const char* default_text, int) {
        return &running->variable(name, default_text).shown;
    };
    f.set_variable = [](const char* name, const char* text) {
        running->set(name, text);
        return &running->variable(name, "").shown;
    };
    f.set_variable_value = [](const char* name, float value) {
        running->set(name, std::to_string(value));
    };
    f.mode_size = [](int* w, int* h, int mode) -> Flag {
        *w = width;
        *h = height;
        return mode < 5 ? 1 : 0;
    };
    f.init_menu = [] { ++running->menus; };
    f.write_screenshot = [](int w, int h, int components, const void* texels) {
        EXPECT_EQ(components, 3);
        const auto* const first = static_cast<const uint8_t*>(texels);
        running->shot_ = {w, h, {first, first + 3 * w * h}};
    };
    f.open_window = [](int, int* w, int* h) -> Flag {
        if (running->functions_.prepare_for_window() == -1) return 0;
        if (running->functions_.init_context(nullptr) == 0) return 0;
        ++running->windows;
        EXPECT_EQ(*w, width);
        EXPECT_EQ(*h, height);
        return 1;
    };
    f.desktop_size = [](int* w, int* h) -> Flag {
        *w = width;
        *h = height;
        return 1;
    };
    f.request_restart = [](int) {};
    return f;
}

} // namespace vigil::test
