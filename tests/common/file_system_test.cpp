// SPDX-License-Identifier: GPL-2.0-or-later
// The overlay of folders and archives: order, case, listing, safe paths.
#include "common/file_system.h"

#include "archive_builder.h"
#include "common/error.h"
#include "common/game_path.h"
#include "scratch_folder.h"

#include <sys/stat.h>

namespace vigil {
namespace {

namespace fs = std::filesystem;
using test::build_pak;
using test::build_zip;
using test::error_of;
using test::LogCapture;
using test::ScratchFolder;

std::string text_of(const FileSystem& files, std::string_view path) {
    const auto bytes = files.read(path);
    return {bytes.begin(), bytes.end()};
}

TEST(FileSystem, LaterMountsHideEarlierOnes) {
    const ScratchFolder scratch;
    // Each source holds its own name under every file that it and all lower ones share.
    scratch.write("baseq2/f1", "loose");
    scratch.write("baseq2/f2", "loose");
    scratch.write("baseq2/pak1.pak", build_pak({{"f3", "pak1"}, {"f2", "pak1"}, {"f4", "pak1"}}));
    scratch.write("baseq2/PAK0.PAK", build_pak({{"f3", "pak0"}, {"f5", "pak0"}}));
    scratch.write("baseq2/B.pkz", build_zip({{"f4", "pkz b"}, {"f6", "pkz b"}}));
    scratch.write("baseq2/a.pkz", build_zip({{"f6", "pkz a"}, {"f7", "pkz a"}}));
    scratch.write("mod/f7", "mod");
    FileSystem files;
    files.mount_game(scratch.path(), "mod");

    EXPECT_EQ(text_of(files, "f1"), "loose");
    EXPECT_EQ(text_of(files, "f2"), "pak1");
    EXPECT_EQ(text_of(files, "f3"), "pak1");
    EXPECT_EQ(text_of(files, "f4"), "pkz b");
    EXPECT_EQ(text_of(files, "f5"), "pak0");
    EXPECT_EQ(text_of(files, "f6"), "pkz b");
    EXPECT_EQ(text_of(files, "f7"), "mod");

    EXPECT_TRUE(files.find("f7")->source.ends_with("mod"));
    EXPECT_TRUE(files.find("f6")->source.ends_with("B.pkz"));
    EXPECT_TRUE(files.find("f1")->source.ends_with("baseq2"));
}

TEST(FileSystem, CaseDoesNotMatter) {
    const ScratchFolder scratch;
    scratch.write("BaseQ2/Textures/E1U1/Metal.WAL", "wal");
    scratch.write("BaseQ2/pak0.pak", build_pak({{"MAPS\\Base1.BSP", "bsp"}}));
    scratch.write("BaseQ2/x.PKZ", build_zip({{"Env/Sky.TGA", "tga"}}));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_EQ(text_of(files, "textures/e1u1/metal.wal"), "wal");
    EXPECT_EQ(text_of(files, "TEXTURES/e1u1/metal.wal"), "wal");
    EXPECT_EQ(text_of(files, "maps/base1.bsp"), "bsp");
    EXPECT_EQ(text_of(files, "env/sky.tga"), "tga");

    const auto location = files.find("maps/BASE1.bsp");
    ASSERT_TRUE(location);
    EXPECT_EQ(location->path, "MAPS/Base1.BSP");
    EXPECT_EQ(location->bytes, 3u);
    EXPECT_TRUE(location->source.ends_with("pak0.pak"));
}

TEST(FileSystem, ListsSortedAndOnce) {
    const ScratchFolder scratch;
    scratch.write("baseq2/maps/mine.bsp", "1");
    scratch.write("baseq2/maps/mine.map", "1");
    scratch.write("baseq2/maps/deep/x.bsp", "1");
    scratch.write("baseq2/other/y.bsp", "1");
    scratch.write("baseq2/pak0.pak", build_pak({{"maps/MINE.bsp", "2"}, {"maps/Arena.bsp", "2"}}));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_EQ(files.list("maps/", ".bsp"),
              (std::vector<std::string>{"maps/Arena.bsp", "maps/deep/x.bsp", "maps/MINE.bsp"}));
    EXPECT_EQ(files.list("", ".map"), std::vector<std::string>{"maps/mine.map"});
    EXPECT_TRUE(files.list("none/", "").empty());
}

TEST(FileSystem, UnsafePathsAreRefusedByName) {
    const ScratchFolder scratch;
    scratch.write("baseq2/a.txt", "inside");
    scratch.write("secret.txt", "outside");
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    const std::string absolute = (scratch.path() / "secret.txt").string();
    for (const std::string_view path :
         {std::string_view("../secret.txt"), std::string_view("x/../../secret.txt"),
          std::string_view(absolute), std::string_view("..\\secret.txt"),
          std::string_view("c:a.txt"), std::string_view("a.txt\0x", 7), std::string_view(""),
          std::string_view("a.txt/"), std::string_view("./a.txt"), std::string_view(".//a.txt"),
          std::string_view("a\n.txt")}) {
        EXPECT_FALSE(game_path_fault(path).empty());
        EXPECT_FALSE(files.exists(path)) << path;
        EXPECT_NE(error_of([&] { files.read(path); }).find("not read, the path "),
                  std::string::npos);
    }
    for (const char* path : {"a.txt", "..a/b..", "*water/+0x.wal", "a b", "\xc3\xa4.tga", "ab:c"})
        EXPECT_TRUE(game_path_fault(path).empty()) << path;
}

TEST(FileSystem, MissingFilesAndFoldersSaySo) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "baseq2");
    FileSystem files;
    const LogCapture log;
    files.mount_game(scratch.path(), "xatrix");
    EXPECT_EQ(log.count(Severity::Error), 1u) << log.all();
    EXPECT_TRUE(log.contains("has no folder xatrix"));
    EXPECT_NE(error_of([&] { files.read("maps/none.bsp"); }).find("maps/none.bsp: no such file"),
              std::string::npos);

    FileSystem empty;
    empty.mount_game(scratch.path() / "nowhere", "baseq2");
    EXPECT_EQ(log.count(Severity::Error), 2u) << log.all();
    for (const char* game : {"", "..", "../baseq2", "/tmp", "a/b", "a\\b"})
        EXPECT_THROW(empty.mount_game(scratch.path(), game), Error) << game;
}

TEST(FileSystem, LinksAreFollowedAndLoopsAreIgnored) {
    const ScratchFolder scratch;
    scratch.write("elsewhere/a.bsp", "linked");
    scratch.write("baseq2/maps/b.bsp", "here");
    fs::create_directory_symlink("../../elsewhere", scratch.path() / "baseq2/maps/linked");
    fs::create_directory_symlink("..", scratch.path() / "baseq2/maps/up");
    fs::create_directory_symlink(".", scratch.path() / "baseq2/self");
    fs::create_symlink("nowhere", scratch.path() / "baseq2/dangling");
    fs::create_symlink("circle", scratch.path() / "baseq2/circle");
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_EQ(text_of(files, "maps/linked/a.bsp"), "linked");
    EXPECT_EQ(files.list("", "").size(), 2u);
}

TEST(FileSystem, PipesAreNotFiles) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "baseq2");
    mkfifo((scratch.path() / "baseq2/pipe").c_str(), 0600);
    mkfifo((scratch.path() / "baseq2/pak0.pak").c_str(), 0600);
    FileSystem files;
    const LogCapture log;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_FALSE(files.exists("pipe"));
    EXPECT_TRUE(log.contains("not a regular file")) << log.all();
}

TEST(FileSystem, FilesThatVanishOrShrinkAreErrors) {
    const ScratchFolder scratch;
    const fs::path loose = scratch.write("baseq2/a.txt", "text");
    const fs::path pak =
        scratch.write("baseq2/pak0.pak", build_pak({{"b.txt", std::string(1000, 'b')}}));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    fs::remove(loose);
    EXPECT_NE(error_of([&] { files.read("a.txt"); }).find("a.txt"), std::string::npos);
    fs::resize_file(pak, 100);
    EXPECT_NE(error_of([&] { files.read("b.txt"); }).find("became shorter"), std::string::npos);
}

TEST(FileSystem, TextFilesAreText) {
    const ScratchFolder scratch;
    scratch.write("baseq2/good.cfg", "echo a\n");
    scratch.write("baseq2/binary.cfg", std::string_view("a\0b", 3));
    scratch.write("baseq2/long.cfg", std::string(2 << 20, 'a'));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_EQ(files.read_text("good.cfg"), "echo a\n");
    EXPECT_THROW(files.read_text("binary.cfg"), Error);
    EXPECT_THROW(files.read_text("long.cfg"), Error);
}

TEST(FileSystem, RealLevelsAreFound) {
    const char* shared = std::getenv("VIGIL_SHARED");
    const fs::path levels = fs::path(shared ? shared : VIGIL_SOURCE_DIR "/../shared") / "levels";
    if (!fs::is_directory(levels)) GTEST_SKIP() << "no test levels at " << levels;
    FileSystem files;
    files.mount_game(levels, "baseq2");
    const auto maps = files.list("maps/", ".bsp");
    EXPECT_EQ(maps.size(), 6u);
    for (const std::string& map : maps)
        EXPECT_EQ(text_of(files, map).substr(0, 4), "IBSP");
    EXPECT_TRUE(files.exists("textures/*LAVA1.tga"));
}

TEST(Basedir, NamedFolderWinsAndTheErrorSaysWhereItLooked) {
    EXPECT_EQ(find_basedir("/some/where"), "/some/where");
    try {
        EXPECT_TRUE(fs::is_directory(find_basedir("") / "baseq2"));
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("+set basedir"), std::string::npos);
    }
}

} // namespace
} // namespace vigil
