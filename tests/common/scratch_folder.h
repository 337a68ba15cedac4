// SPDX-License-Identifier: GPL-2.0-or-later
// An empty folder below the system's temporary one that is removed with the test, and the log lines
// of the test. For tests only.
#pragma once

#include "common/log.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vigil::test {

class ScratchFolder {
public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "vigil-test-XXXXXX").string();
        if (!mkdtemp(name.data())) ADD_FAILURE() << "no temporary folder";
        path_ = name;
    }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(std::string_view name, std::span<const std::uint8_t> bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        // A new file, since some file systems flush one that is truncated and written again to the
        // disk.
        std::filesystem::remove(file);
        std::ofstream stream(file, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
        return file;
    }
    std::filesystem::path write(std::string_view name, std::string_view text) const {
        return write(name,
                     std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    }

private:
    std::filesystem::path path_;
};

inline std::string read_whole(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Collects what is logged while it lives.
class LogCapture {
public:
    struct Line {
        Severity severity;
        std::string text;
    };

    LogCapture()
        : token_(add_log_sink([this](Severity severity, std::string_view line) {
              lines.push_back({severity, std::string(line)});
          })) {}
    ~LogCapture() { remove_log_sink(token_); }
    LogCapture(const LogCapture&) = delete;
    LogCapture& operator=(const LogCapture&) = delete;

    std::size_t count(Severity severity) const {
        std::size_t number = 0;
        for (const Line& line : lines)
            number += line.severity == severity ? 1 : 0;
        return number;
    }
    bool contains(std::string_view part) const {
        for (const Line& line : lines)
            if (line.text.find(part) != std::string::npos) return true;
        return false;
    }
    std::string all() const {
        std::string text;
        for (const Line& line : lines)
            text += line.text + '\n';
        return text;
    }

    std::vector<Line> lines;

private:
    int token_;
};

/// What the Error says that `function` throws; a test failure when it throws none.
template <typename Function> std::string error_of(Function&& function) {
    try {
        function();
    } catch (const std::exception& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error was thrown";
    return {};
}

} // namespace vigil::test
