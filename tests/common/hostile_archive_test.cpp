// SPDX-License-Identifier: GPL-2.0-or-later
// Damaged and hostile archives: each named fault gives one message, and random damage never gives
// anything but a message or a bounded read. The sanitizers watch.
#include "archive_builder.h"
#include "common/error.h"
#include "common/file_source.h"
#include "common/file_system.h"
#include "scratch_folder.h"

#include <functional>
#include <random>

namespace vigil {
namespace {

using test::ArchiveFile;
using test::build_pak;
using test::build_zip;
using test::Bytes;
using test::error_of;
using test::LogCapture;
using test::poke_u16;
using test::poke_u32;
using test::ScratchFolder;
using test::zip_directory;
using test::zip_end;

const std::vector<ArchiveFile> some_files = {
    {"maps/a.bsp", std::string(5000, 'a') + "end", true},
    {"textures/b.wal", "stored bytes", false},
    {"empty.cfg", "", true},
};

/// An archive with one thing wrong, and a part of the message it must give when it is mounted.
struct MountFault {
    const char* name;
    std::string file;
    Bytes bytes;
    std::string message;
};

template <typename Change> Bytes changed(Bytes bytes, Change change) {
    change(bytes);
    return bytes;
}

std::vector<MountFault> mount_faults() {
    const Bytes pak = build_pak(some_files);
    const Bytes zip = build_zip(some_files);
    const auto head = [](const Bytes& bytes, std::size_t size) {
        return Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    };
    const std::size_t pak_entry = pak.size() - 3 * 64;
    const std::string p = "pak0.pak";
    const std::string z = "a.pkz";
    return {
        {"PakEmpty", p, {}, "truncated"},
        {"PakHalfHeader", p, head(pak, 7), "truncated"},
        {"PakMagic", p, changed(pak, [](Bytes& b) { b[0] = 'Q'; }), "is not a pak file"},
        {"PakTruncated", p, head(pak, pak.size() - 1), "truncated"},
        {"PakOddDirectory", p, changed(pak, [](Bytes& b) { poke_u32(b, 8, 63); }),
         "64-byte entries"},
        {"PakHugeDirectory", p, changed(pak, [](Bytes& b) { poke_u32(b, 8, 0xffffffc0); }),
         "truncated"},
        {"PakNegativeOffset", p, changed(pak, [](Bytes& b) { poke_u32(b, 4, 0xffffffff); }),
         "truncated"},
        {"PakEntryOffset", p,
         changed(pak, [&](Bytes& b) { poke_u32(b, pak_entry + 56, 0x7fffffff); }),
         "entry 0 ends at byte"},
        {"PakEntryLength", p,
         changed(pak, [&](Bytes& b) { poke_u32(b, pak_entry + 64 + 60, 0xffffffff); }),
         "entry 1 ends at byte"},
        {"ZipEmpty", z, {}, "truncated or not a zip file"},
        {"ZipTruncated", z, head(zip, zip.size() - 1), "truncated or not a zip file"},
        {"ZipText", z, Bytes(1000, 'x'), "truncated or not a zip file"},
        {"ZipCount", z,
         changed(zip,
                 [](Bytes& b) {
                     poke_u16(b, zip_end(b) + 8, 4);
                     poke_u16(b, zip_end(b) + 10, 4);
                 }),
         "lacks entry 3"},
        {"ZipDisks", z, changed(zip, [](Bytes& b) { poke_u16(b, zip_end(b) + 4, 1); }),
         "several disks"},
        {"ZipDirectorySize", z,
         changed(zip, [](Bytes& b) { poke_u32(b, zip_end(b) + 12, 1 << 30); }),
         "behind its end record"},
        {"ZipDirectoryOffset", z,
         changed(zip, [](Bytes& b) { poke_u32(b, zip_end(b) + 16, 0xfffffffe); }),
         "behind its end record"},
        {"Zip64", z, changed(zip, [](Bytes& b) { poke_u32(b, zip_end(b) + 16, 0xffffffff); }),
         "zip64"},
        {"ZipEntrySignature", z, changed(zip, [](Bytes& b) { b[zip_directory(b)] ^= 1; }),
         "entry 0 of the directory is damaged"},
        {"ZipNameLength", z,
         changed(zip, [](Bytes& b) { poke_u16(b, zip_directory(b) + 28, 0xffff); }),
         "entry 0 leaves the directory"},
        {"ZipPackedSize", z,
         changed(zip, [](Bytes& b) { poke_u32(b, zip_directory(b) + 20, 0xfffffff0); }),
         "entry 0 leaves the archive"},
        {"ZipHeaderOffset", z,
         changed(zip, [](Bytes& b) { poke_u32(b, zip_directory(b) + 42, 0xfffffff0); }),
         "entry 0 leaves the archive"},
    };
}

class MountFaults : public testing::TestWithParam<MountFault> {};

TEST_P(MountFaults, GiveOneMessageAndTheRestIsMounted) {
    const ScratchFolder scratch;
    scratch.write("baseq2/" + GetParam().file, GetParam().bytes);
    scratch.write("baseq2/pak1.pak", build_pak({{"good.txt", "good"}}));
    FileSystem files;
    const LogCapture log;
    files.mount_game(scratch.path(), "baseq2");
    ASSERT_EQ(log.lines.size(), 1u) << log.all();
    EXPECT_EQ(log.lines[0].severity, Severity::Error);
    EXPECT_TRUE(log.contains(GetParam().file)) << log.all();
    EXPECT_TRUE(log.contains(GetParam().message)) << log.all();
    EXPECT_TRUE(files.exists("good.txt"));
    EXPECT_FALSE(files.exists("maps/a.bsp"));
}

INSTANTIATE_TEST_SUITE_P(Archive, MountFaults, testing::ValuesIn(mount_faults()),
                         [](const auto& fault) { return std::string(fault.param.name); });

/// A zip that mounts, but whose first file must give `message` when it is read.
struct ReadFault {
    const char* name;
    std::function<void(Bytes& zip, std::size_t entry)> change;
    std::string message;
};

class ReadFaults : public testing::TestWithParam<ReadFault> {};

TEST_P(ReadFaults, NameTheFileAndTheFault) {
    const ScratchFolder scratch;
    Bytes zip = build_zip(some_files);
    GetParam().change(zip, zip_directory(zip));
    scratch.write("baseq2/a.pkz", zip);
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    const std::string error = error_of([&] { files.read("maps/a.bsp"); });
    EXPECT_NE(error.find("maps/a.bsp in "), std::string::npos) << error;
    EXPECT_NE(error.find("a.pkz"), std::string::npos) << error;
    EXPECT_NE(error.find(GetParam().message), std::string::npos) << error;
    EXPECT_EQ(files.read("textures/b.wal").size(), 12u);
    EXPECT_TRUE(files.read("empty.cfg").empty());
}

INSTANTIATE_TEST_SUITE_P(
    Zip, ReadFaults,
    testing::Values(
        ReadFault{"Encrypted", [](Bytes& b, std::size_t e) { poke_u16(b, e + 8, 1); }, "encrypted"},
        ReadFault{"Method", [](Bytes& b, std::size_t e) { poke_u16(b, e + 10, 12); },
                  "neither stored nor deflated"},
        ReadFault{"OverLimit", [](Bytes& b, std::size_t e) { poke_u32(b, e + 24, 0xf0000000); },
                  "512 MiB"},
        ReadFault{"Bomb", [](Bytes& b, std::size_t e) { poke_u32(b, e + 24, 500 << 20); },
                  "impossible unpacked size"},
        ReadFault{"DeclaredLess", [](Bytes& b, std::size_t e) { poke_u32(b, e + 24, 4000); },
                  "not the declared one"},
        ReadFault{"DeclaredNothing", [](Bytes& b, std::size_t e) { poke_u32(b, e + 24, 0); },
                  "not the declared one"},
        ReadFault{"DeclaredMore", [](Bytes& b, std::size_t e) { poke_u32(b, e + 24, 5004); },
                  "not the declared one"},
        ReadFault{"StoredSizes", [](Bytes& b, std::size_t e) { poke_u16(b, e + 10, 0); },
                  "two sizes differ"},
        ReadFault{"Checksum", [](Bytes& b, std::size_t e) { b[e + 16] ^= 1; }, "checksum"},
        ReadFault{"LocalHeader", [](Bytes& b, std::size_t) { b[0] ^= 1; }, "local header"},
        ReadFault{"LocalLengths", [](Bytes& b, std::size_t) { poke_u16(b, 28, 0xffff); },
                  "leaves the archive"}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(Archives, UnsafeNamesAreSkippedWithOneMessage) {
    for (const bool pak : {false, true}) {
        const std::vector<ArchiveFile> entries = {{"../../evil", "x"}, {"/etc/evil", "x"},
                                                  {"..\\evil", "x"},   {"c:\\evil", "x"},
                                                  {"", "x"},           {"good.txt", "good"}};
        const ScratchFolder scratch;
        scratch.write(pak ? "baseq2/pak0.pak" : "baseq2/a.pkz",
                      pak ? build_pak(entries) : build_zip(entries));
        FileSystem files;
        const LogCapture log;
        files.mount_game(scratch.path(), "baseq2");
        EXPECT_EQ(log.lines.size(), 1u) << log.all();
        EXPECT_TRUE(log.contains("5 files skipped"));
        EXPECT_EQ(files.list("", "").size(), 2u); // the archive itself is a loose file
        EXPECT_EQ(files.read("good.txt").size(), 4u);
    }
}

TEST(Archives, OfTwoEntriesWithOneNameTheFirstIsRead) {
    const ScratchFolder scratch;
    scratch.write("baseq2/pak0.pak", build_pak({{"a", "one"}, {"A", "second"}, {"b", "three"}}));
    scratch.write("baseq2/a.pkz", build_zip({{"c", "one"}, {"C", "second"}, {"d", "three"}}));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_EQ(files.read("A").size(), 3u);
    EXPECT_EQ(files.read("b").size(), 5u);
    EXPECT_EQ(files.read("C").size(), 3u);
    EXPECT_EQ(files.read("d").size(), 5u);
}

TEST(Archives, NamesThatFillTheirFieldNeedNoNul) {
    const ScratchFolder scratch;
    const std::string name(56, 'n');
    scratch.write("baseq2/pak0.pak", build_pak({{name, "x"}}));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_TRUE(files.exists(name));
}

TEST(Archives, ZipCommentsMayHoldASignature) {
    const ScratchFolder scratch;
    scratch.write("baseq2/a.pkz",
                  build_zip(some_files, std::string("PK\5\6") + std::string(40, 'c')));
    FileSystem files;
    files.mount_game(scratch.path(), "baseq2");
    EXPECT_EQ(files.read("maps/a.bsp").size(), 5003u);
}

/// Opens `bytes` as an archive and reads all its files: errors that name the archive are fine,
/// anything else is not. Goes past the overlay, which would list the folder each time.
void open_and_read(const ScratchFolder& scratch, bool pak, const Bytes& bytes) {
    const std::filesystem::path path = scratch.write("archive", bytes);
    const auto tell = [&](const Error& error) {
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    };
    try {
        const auto source = pak ? open_pak(path) : open_zip(path);
        for (const std::string& entry : source->list("", "")) {
            try {
                EXPECT_EQ(source->read(entry)->size(), source->find(entry)->bytes);
            } catch (const Error& error) {
                tell(error);
            }
        }
    } catch (const Error& error) {
        tell(error);
    }
}

TEST(Archives, RandomDamageIsSurvived) {
    for (const bool pak : {false, true}) {
        const ScratchFolder scratch;
        const Bytes right = pak ? build_pak(some_files) : build_zip(some_files);
        const LogCapture log;
        std::mt19937 random(2020);
        // Damage the last bytes more often: there the directories are, and most bytes are plain
        // content.
        const std::size_t directory = right.size() - std::min<std::size_t>(right.size(), 260);
        for (int round = 0; round < 5000; ++round) {
            Bytes bytes = right;
            for (auto changes = 1 + random() % 4; changes > 0; --changes) {
                const bool in_directory = random() % 4 != 0;
                const std::size_t at = in_directory
                                           ? directory + random() % (bytes.size() - directory)
                                           : random() % bytes.size();
                const std::uint8_t values[] = {0, 0xff, 0x7f, 0x80,
                                               static_cast<std::uint8_t>(random())};
                bytes[at] = values[random() % 5];
            }
            if (random() % 8 == 0) bytes.resize(random() % bytes.size());
            open_and_read(scratch, pak, bytes);
        }
    }
}

TEST(Archives, EveryTruncationIsSurvived) {
    for (const bool pak : {false, true}) {
        const ScratchFolder scratch;
        const std::vector<ArchiveFile> files = {{"a/b", "content of b"}, {"c", "content of c"}};
        const Bytes right = pak ? build_pak(files) : build_zip(files);
        const LogCapture log;
        for (std::size_t size = 0; size <= right.size(); ++size)
            open_and_read(scratch, pak,
                          Bytes(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(size)));
    }
}

} // namespace
} // namespace vigil
