// SPDX-License-Identifier: GPL-2.0-or-later
// The one table of fuzz targets: every parser of bytes that come from outside, and what is built
// from them. CMake makes a
// libFuzzer program fuzz_NAME of each row (it reads this text), and a row needs a function
// fuzz_NAME in one of the files *_targets.cpp; nothing else lists them.
#ifndef VIGIL_FUZZ_TARGET_TABLE_H
#define VIGIL_FUZZ_TARGET_TABLE_H

// Columns: name (also the folder regressions/NAME and, where there is one, NAME.dict); extension of
// the real files that serve as seeds, "" for none; largest input in bytes; runs of the short test
// (about ten seconds on one core); what is parsed.
// clang-format off
#define VIGIL_FUZZ_TARGETS(ROW) \
    ROW(bsp,        ".bsp",      65536,   8000, "levels: IBSP 38, with everything that walks them") \
    ROW(scene,      ".bsp",      65536,   2000, "levels as scenes: materials, geometry, lights, light lists, hierarchies") \
    ROW(pvs,        "",          16384,  10000, "visibility rows of a level") \
    ROW(entities,   "",          16384,  20000, "entity text of a level") \
    ROW(pak,        ".pak",      16384,  60000, "PACK archives and the names in them") \
    ROW(pkz,        ".pkz",      16384,  40000, "ZIP archives and the names in them") \
    ROW(wal,        ".wal",      16384,  30000, "WAL pictures") \
    ROW(pcx,        ".pcx",      16384,  25000, "PCX pictures") \
    ROW(tga,        ".tga",      16384,  30000, "TGA pictures") \
    ROW(png,        ".png",      16384,  15000, "PNG pictures") \
    ROW(png_rows,   "",          16384,  40000, "PNG rows: packed by us, so that every input is right zlib data") \
    ROW(jpg,        ".jpg",      16384,  50000, "JPG pictures") \
    ROW(md2,        ".md2",      16384, 100000, "MD2 models") \
    ROW(sp2,        ".sp2",      16384, 100000, "SP2 sprites") \
    ROW(mesh,       ".glb",      16384,  30000, "binary glTF models") \
    ROW(dm2,        ".dm2",      65536,  20000, "demos of protocol 34") \
    ROW(cfg,        ".cfg",       4096,   4000, "scripts: splitting, running, completing") \
    ROW(packed_cfg, ".cfg",       4096,   4000, "the same from a game archive: guarded variables stay") \
    ROW(route,      ".route",     4096,  40000, "camera routes") \
    ROW(walk,       ".walk",      4096,  40000, "scripted walks") \
    ROW(materials,  ".json",      4096,  25000, "materials.json") \
    ROW(style,      "",            256,  60000, "light style patterns") \
    ROW(cache,      "",           4096,  60000, "cache files: seals, and references inside a right seal") \
    ROW(names,      "",           1024,  50000, "paths and texture names that files hold")
// clang-format on

#endif
