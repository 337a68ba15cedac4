// SPDX-License-Identifier: GPL-2.0-or-later
// A report that grows part by part and survives an interruption: it is written after every part,
// and the same measurement, begun again, goes on with the parts that are there. What "the same" is
// a key tells; the program that measured belongs to it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace vigil::bench {

/// The report at the path; no object where it cannot be read as JSON. Throws Error where there is
/// no file.
nlohmann::ordered_json read_report(const std::filesystem::path& path);

class Checkpoint {
public:
    /// `head` is what stands above the parts; it and the program itself are the key. Parts of an
    /// unfinished report at `path` with this key are taken over; with `keep`, those of a finished
    /// one too. Any other file there is replaced by the first save().
    Checkpoint(std::filesystem::path path, nlohmann::ordered_json head, bool keep);

    /// The part with this `part` member, or null.
    const nlohmann::ordered_json* find(const std::string& part) const;
    /// Adds a part and writes the report. Throws Error when it cannot be written.
    void add(const std::string& part, const nlohmann::ordered_json& content);
    /// Marks the report as finished and writes it. Throws Error.
    void finish();

    const nlohmann::ordered_json& report() const { return report_; }

private:
    void save() const;

    std::filesystem::path path_;
    nlohmann::ordered_json report_;
};

} // namespace vigil::bench
