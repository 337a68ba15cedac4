// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/checkpoint.h"

#include "bench/reference.h"
#include "common/binary_file.h"
#include "common/output.h"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vigil::bench {

using nlohmann::ordered_json;

namespace {

/// Of the program that runs: what another build measured is not gone on with.
std::uint64_t program_hash() {
    const BinaryFile program("/proc/self/exe");
    const std::vector<std::uint8_t> bytes = program.read(0, program.size());
    return hash_bytes(std::as_bytes(std::span(bytes)));
}

} // namespace

ordered_json read_report(const std::filesystem::path& path) {
    const BinaryFile file(path);
    const std::vector<std::uint8_t> bytes = file.read(0, file.size());
    return ordered_json::parse(bytes.begin(), bytes.end(), nullptr, false);
}

Checkpoint::Checkpoint(std::filesystem::path path, ordered_json head, bool keep)
    : path_(std::move(path)), report_(std::move(head)) {
    const std::string text = report_.dump();
    report_["key"] =
        fmt::format("{:016x}", hash_bytes(std::as_bytes(std::span(text)), program_hash()));
    report_["finished"] = false;
    report_["parts"] = ordered_json::array();
    if (!std::filesystem::is_regular_file(path_)) return;
    const ordered_json before = read_report(path_);
    const auto key = report_["key"].get<std::string>();
    if (!before.is_object() || before.value("key", std::string()) != key) return;
    if (before.value("finished", true) && !keep) return;
    if (before.contains("parts") && before["parts"].is_array()) report_["parts"] = before["parts"];
}

const ordered_json* Checkpoint::find(const std::string& part) const {
    for (const ordered_json& known : report_["parts"])
        if (known.value("part", std::string()) == part) return &known;
    return nullptr;
}

void Checkpoint::add(const std::string& part, const ordered_json& content) {
    ordered_json entry = {{"part", part}};
    entry.update(content);
    report_["parts"].push_back(std::move(entry));
    save();
}

void Checkpoint::finish() {
    report_["finished"] = true;
    save();
}

void Checkpoint::save() const {
    write_file(path_, report_.dump(1) + "\n");
}

} // namespace vigil::bench
