// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/checkpoint.h"

#include "bench/reference.h"
#include "common/binary_file.h"
#include "common/error.h"
#include "common/output.h"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <system_error>
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

/// The member; null where there is none, or no object.
ordered_json member(const ordered_json& object, const std::string& name) {
    const auto found = object.find(name);
    return found != object.end() ? *found : ordered_json();
}

/// Whether both are the same, in whatever order their members stand.
bool same(const ordered_json& a, const ordered_json& b) {
    return nlohmann::json(a) == nlohmann::json(b);
}

/// Whether both heads have the same members, but for what is planned.
bool same_measurement(const ordered_json& head, const ordered_json& before) {
    for (const auto& [name, value] : head.items())
        if (name != "planned" && !same(value, member(before, name))) return false;
    return true;
}

} // namespace

ordered_json read_report(const std::filesystem::path& path) {
    const BinaryFile file(path);
    const std::vector<std::uint8_t> bytes = file.read(0, file.size());
    return ordered_json::parse(bytes.begin(), bytes.end(), nullptr, false);
}

Checkpoint::Checkpoint(std::filesystem::path path, ordered_json head, bool keep)
    : path_(std::move(path)), report_(std::move(head)) {
    report_["program"] = fmt::format("{:016x}", program_hash());
    const ordered_json about = report_;
    const std::string text = about.dump();
    report_["key"] = fmt::format("{:016x}", hash_bytes(std::as_bytes(std::span(text))));
    report_["finished"] = false;
    ordered_json& parts = report_["parts"] = ordered_json::array();
    if (!std::filesystem::is_regular_file(path_)) return;
    const ordered_json before = read_report(path_), known = member(before, "parts");
    if (!known.is_array()) return;
    if (same_measurement(about, before) && (keep || !before.value("finished", true))) {
        const ordered_json planned = member(about, "planned"), was = member(before, "planned");
        for (const ordered_json& part : known) {
            const auto name = part.value("part", std::string());
            if (same(member(planned, name), member(was, name))) parts.push_back(part);
        }
    }
    if (parts.size() < known.size())
        aside_ = std::filesystem::path(path_).replace_extension(
            before.value("key", std::string("before")) + ".json");
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

void Checkpoint::save() {
    if (const std::filesystem::path aside = std::exchange(aside_, {}); !aside.empty()) {
        std::error_code failed;
        std::filesystem::rename(path_, aside, failed);
        if (failed) fail("{}: {}", aside.string(), failed.message());
        fmt::print("{}: the older report has other parts; it is now {}\n", path_.string(),
                   aside.string());
    }
    write_file(path_, report_.dump(1) + "\n");
}

} // namespace vigil::bench
