// SPDX-License-Identifier: GPL-2.0-or-later
// Seeds from the builders of the other tests and from game folders.
#include "seeds.h"

#include "common/archive_builder.h"
#include "common/ascii_case.h"
#include "common/binary_file.h"
#include "common/sealed.h"
#include "formats/picture_bytes.h"
#include "formats/small_level.h"
#include "formats/small_models.h"

#include <algorithm>
#include <string>

namespace vigil::fuzz {

namespace {

namespace fs = std::filesystem;

// The header of a level: signature, version, then offset and length of each lump.
constexpr std::size_t entities_entry = 8 + 8 * level_entities;
constexpr std::size_t visibility_entry = 8 + 8 * level_visibility;

Bytes bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

std::vector<Bytes> texts(std::initializer_list<std::string_view> list) {
    std::vector<Bytes> seeds;
    for (const std::string_view text : list)
        seeds.push_back(bytes_of(text));
    return seeds;
}

std::vector<Bytes> archives(Bytes (*build)(const std::vector<test::ArchiveFile>&)) {
    return {build({}), build({{"a.cfg", "echo a", false}}),
            build({{"maps/a.bsp", std::string(900, 'a') + "end", true},
                   {"textures/b.wal", "stored bytes", false},
                   {"../outside", "refused", false},
                   {"empty.cfg", "", true}})};
}

Bytes build_zip(const std::vector<test::ArchiveFile>& files) {
    return test::build_zip(files);
}

std::vector<Bytes> scripts() {
    return texts({"set pt_nee vlc\nbind x \"toggle pt_spp 1 2\" // comment\n",
                  "alias a \"echo $pt_spp; wait 2; a\"\na\n", "exec self.cfg\n",
                  "set outdir $outdir$outdir\nreset outdir; seta fov 1e2; cvarlist pt_\n",
                  "vid_width \"99999\"; help set\ntoggle vid_fullscreen\nunalias a\n"});
}

/// A lump of the level `file`; empty where its directory is wrong.
Bytes lump_of(const Bytes& file, std::size_t entry) {
    if (file.size() < level_header_size) return {};
    const std::size_t offset = read_u32(file, entry), length = read_u32(file, entry + 4);
    if (offset > file.size() || length > file.size() - offset) return {};
    const auto begin = file.begin() + static_cast<std::ptrdiff_t>(offset);
    return {begin, begin + static_cast<std::ptrdiff_t>(length)};
}

} // namespace

std::vector<Bytes> built_seeds(const Target& target) {
    const std::string_view name = target.name;
    const Image picture = test_picture(13, 7);
    if (name == "bsp" || name == "scene") return {write_level(small_level())};
    if (name == "pvs") return {small_level()[level_visibility]};
    if (name == "entities") return {small_level()[level_entities]};
    if (name == "pak") return archives(test::build_pak);
    if (name == "pkz") return archives(build_zip);
    if (name == "wal") return {write_wal(16, 16, 0), write_wal(8, 8, 0x2000000)};
    if (name == "pcx") return {write_pcx(16, 16)};
    if (name == "tga")
        return {write_tga(picture, {2, 32, 8}), write_tga(picture, {3, 8, 0}),
                write_tga(picture, {10, 24, 0x20}), write_tga(picture, {2, 24, 0x10})};
    if (name == "png") return {write_png(picture)};
    if (name == "png_rows") {
        Bytes rows = {12, 6, 6, 8, 0}; // 13 x 7, RGBA, 8 bits, not interlaced
        for (std::size_t y = 0; y < picture.height; ++y) {
            rows.push_back(static_cast<std::uint8_t>(y % 5)); // each filter
            const auto row = picture.rgba.begin() + static_cast<std::ptrdiff_t>(y * 52);
            rows.insert(rows.end(), row, row + 52);
        }
        return {rows};
    }
    if (name == "jpg") return {write_jpg(picture, 80), write_jpg(picture, 5)};
    if (name == "md2") return {small_md2()};
    if (name == "sp2") return {small_sp2()};
    if (name == "mesh")
        return {triangle_glb(R"("translation":[1,2,3],)"),
                triangle_glb(R"("scale":[-1,2,1],"rotation":[0,1,0,0],)",
                             R"({"pbrMetallicRoughness":{"roughnessFactor":0.5}})")};
    if (name == "cfg" || name == "packed_cfg") return scripts();
    if (name == "route")
        return texts({"0 0 0 10 0 0 0\n0.5 100 0 10 0 90 0 # halfway\n2 1 2 3 4 5 6\n"});
    if (name == "walk") // real ones are larger than the target's inputs
        return texts({"# a walk\n30 0 0 0 0 30 0 0\n3 306 257 0 0 20.5 0 0\n1 0 0 -8 89 -7 0 1\n"});
    if (name == "materials")
        return texts({R"({"Test/SAND": {"roughness": 0.3, "specular": 0.05}, "b": {}})"});
    if (name == "style") return texts({"mmnmmommommnonmmonqnmmo", "a", ""});
    if (name == "cache") {
        Bytes reference(8 + 15 * sizeof(double)); // three batches of six values
        reference[0] = 6;
        return {reference,
                bytes_of(seal("vigil reference 2\nkey", std::as_bytes(std::span(reference))))};
    }
    if (name == "names")
        return texts({"textures/e1u1/floor1_1.wal", "e1u1/+0lava", "+abutton", "../../x", "c:/x"});
    return {};
}

std::vector<Bytes> found_seeds(const Target& target, const fs::path& folder) {
    const std::size_t part = target.name == "entities" ? entities_entry
                             : target.name == "pvs"    ? visibility_entry
                                                       : 0;
    const std::string_view extension = part != 0 ? ".bsp" : target.extension;
    std::vector<Bytes> seeds;
    if (extension.empty() || !fs::is_directory(folder)) return seeds;

    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && ends_nocase(entry.path().filename().string(), extension))
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        const BinaryFile file(path);
        if (part == 0 && file.size() > target.max_bytes) continue;
        Bytes bytes = file.read(0, file.size());
        if (part != 0) bytes = lump_of(bytes, part);
        if (!bytes.empty() && bytes.size() <= target.max_bytes) seeds.push_back(std::move(bytes));
    }
    return seeds;
}

} // namespace vigil::fuzz
