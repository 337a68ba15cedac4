// SPDX-License-Identifier: GPL-2.0-or-later
// A report that grows part by part and survives an interruption: it is written after every part,
// and the same measurement, begun again, goes on with the parts that are there. The same program
// must have measured them, with the same settings; other parts may be planned (--level).
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
    /// `head` is what stands above the parts; `planned` in it has what tells each part from others.
    /// Parts of an unfinished report at `path` are taken over where they and the rest of the head
    /// are the same; with `keep`, those of a finished one too. The first add() or finish()
    /// replaces the file. If it has other parts, it is renamed to NAME.KEY.json, with its own key.
    Checkpoint(std::filesystem::path path, nlohmann::ordered_json head, bool keep);

    /// The part with this `part` member, or null.
    const nlohmann::ordered_json* find(const std::string& part) const;
    /// Adds a part and writes the report. Throws Error when it cannot be written.
    void add(const std::string& part, const nlohmann::ordered_json& content);
    /// Marks the report as finished and writes it. Throws Error.
    void finish();

    const nlohmann::ordered_json& report() const { return report_; }

private:
    void save();

    std::filesystem::path path_;
    nlohmann::ordered_json report_;
    std::filesystem::path aside_; // where the file goes first; empty if nothing in it is missing
};

} // namespace vigil::bench
