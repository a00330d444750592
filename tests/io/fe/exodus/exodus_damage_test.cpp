#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netcdf.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "core/base/error.h"
#include "io/fe/exodus/classic_header.h"
#include "io/fe/exodus/exodus_reader.h"
#include "io/fe/fe_reader.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/run_tests.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

ExodusBuilder soundBuilder(bool netcdf4) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.addCubes(2, "second", 4);
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return k > e ? 0.0 : 1.0; });
    builder.blocks[1].attributeCount = 1;
    builder.blocks[1].attributeNames = {"DENSITY"};
    builder.blocks[1].attributes = {2400, 2500};
    builder.netcdf4 = netcdf4;
    return builder;
}

// Reads everything there is. Any error of ours will do; what it must not do is crash or leave another exception.
bool readsWhole(const std::string& path) {
    try {
        const auto fe = openFe(path, {}, {}, Execution{});
        for (std::size_t k = 0; k < fe->stateCount(); ++k) {
            fe->state(k);
        }
        return true;
    } catch (const Error& error) {
        EXPECT_FALSE(error.message().empty());
        EXPECT_FALSE(error.remedy().empty()) << error.what();
        EXPECT_THAT(error.what(), HasSubstr(std::filesystem::path(path).filename().string()));
        return false;
    }
}

std::string errorOf(const std::string& path) {
    try {
        openFe(path, {}, {}, Execution{});
    } catch (const Error& error) {
        return englishText(error.message()) + " | " + englishText(error.remedy());
    }
    ADD_FAILURE() << "no error";
    return "";
}

TEST(ExodusDamage, MissingEmptyAndForeignFilesAreCalledByTheirName) {
    const TemporaryFolder folder;
    EXPECT_THROW(openFe(folder / "none.exo", {}, {}, Execution{}), WorldError);
    EXPECT_THROW(openFe(folder.path(), {}, {}, Execution{}), WorldError);
    writeContent(folder / "empty.exo", "");
    EXPECT_THAT(errorOf(folder / "empty.exo"), HasSubstr("is empty"));
    writeContent(folder / "case.exo", "{\"format\": \"rubble\"}");
    EXPECT_THAT(errorOf(folder / "case.exo"), HasSubstr("JSON"));
    writeContent(folder / "text.exo", "NODES\n1 2 3\n");
    EXPECT_THAT(errorOf(folder / "text.exo"), AllOf(HasSubstr("a text"), HasSubstr("Exodus II")));
    writeContent(folder / "binary.exo", std::string("\0\1\2\3", 4));
    EXPECT_THAT(errorOf(folder / "binary.exo"), HasSubstr("binary"));
    writeContent(folder / "vtk.exo", "# vtk DataFile Version 3.0\n");
    EXPECT_THAT(errorOf(folder / "vtk.exo"), HasSubstr("VTK"));
    writeContent(folder / "tiny.exo", "CDF\x02");
    EXPECT_THAT(errorOf(folder / "tiny.exo"), HasSubstr("cut off"));
    writeContent(folder / "tiny5.exo", "\x89HDF\r\n\x1a\n");
    EXPECT_THAT(errorOf(folder / "tiny5.exo"), HasSubstr("cut off"));
}

TEST(ExodusDamage, NetcdfAndHdf5ThatAreNoExodus) {
    const TemporaryFolder folder;
    for (const int mode : {NC_CLOBBER, NC_CLOBBER | NC_NETCDF4}) {
        int file = 0, dimension = 0;
        ASSERT_EQ(nc_create((folder / "weather.nc").c_str(), mode, &file), NC_NOERR);
        ASSERT_EQ(nc_def_dim(file, "latitude", 10, &dimension), NC_NOERR);
        nc_close(file);
        EXPECT_THAT(errorOf(folder / "weather.nc"), HasSubstr("no Exodus II file: it has no dimension"));
    }
    int file = 0, group = 0;
    ASSERT_EQ(nc_create((folder / "plain.h5").c_str(), NC_CLOBBER | NC_NETCDF4, &file), NC_NOERR);
    ASSERT_EQ(nc_def_grp(file, "frames", &group), NC_NOERR);
    nc_close(file);
    EXPECT_THAT(errorOf(folder / "plain.h5"), HasSubstr("no Exodus II file"));
}

TEST(ExodusDamage, EveryTruncationIsAnErrorAndSaysSo) {
    const TemporaryFolder folder;
    for (const bool netcdf4 : {false, true}) {
        soundBuilder(netcdf4).write(folder / "whole.exo");
        ASSERT_TRUE(readsWhole(folder / "whole.exo"));
        const std::string bytes = wholeFile(folder / "whole.exo");
        const std::size_t whole = readExodus(folder / "whole.exo", {}, Execution{}).times.size();
        ::testing::internal::CaptureStderr();
        writeContent(folder / "cut.exo", bytes);
        const std::size_t step = sizedTo<std::size_t>(5, 1, 1);
        for (std::size_t size = bytes.size() - 1; size > 0 && size < bytes.size(); size -= step) {
            std::filesystem::resize_file(folder / "cut.exo", size);
            try {
                // Of the classic format, states that are whole are read.
                const FeResult::Contents left = readExodus(folder / "cut.exo", {}, Execution{});
                ASSERT_FALSE(netcdf4) << size << " of " << bytes.size();
                ASSERT_LT(left.times.size(), whole) << size << " of " << bytes.size();
                ASSERT_GE(left.findings.count("fe.unfinished"), 1) << size << " of " << bytes.size();
            } catch (const ParseError&) {
                // What openFe() does besides takes most of the time.
                EXPECT_FALSE(size / step % 997 == 1 && readsWhole(folder / "cut.exo")) << size << " of " << bytes.size();
            }
        }
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "libraries do not speak to the user";
        writeContent(folder / "cut.exo", bytes.substr(0, bytes.size() / 2));
        EXPECT_THAT(errorOf(folder / "cut.exo"), AllOf(HasSubstr("is cut off: it ends after"), HasSubstr("Copy the file again")));
    }
}

TEST(ExodusDamage, FlippedBitsNeverCrash) {
    const TemporaryFolder folder;
    std::mt19937 random(7);
    for (const bool netcdf4 : {false, true}) {
        soundBuilder(netcdf4).write(folder / "whole.exo");
        const std::string bytes = wholeFile(folder / "whole.exo");
        int errors = 0;
        ::testing::internal::CaptureStderr();
        const int flips = netcdf4 ? sizedTo(50, 150, 150) : sizedTo(300, 1200, 1200);
        for (int i = 0; i < flips; ++i) {
            std::string damaged = bytes;
            const std::size_t where = random() % bytes.size();
            damaged[where] = static_cast<char>(damaged[where] ^ (1 << (random() % 8)));
            writeContent(folder / "flipped.exo", damaged);
            errors += !readsWhole(folder / "flipped.exo");
        }
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
        EXPECT_GT(errors, flips / (netcdf4 ? 50 : 60)) << "the flips met nothing that matters";
    }
}

TEST(ExodusDamage, CountsThatDisagreeWithTheirDataAreNoticed) {
    const TemporaryFolder folder;
    const std::string path = folder / "shape.exo";
    const auto broken = [&](const std::function<void(int)>& change) {
        soundBuilder(false).write(path);
        int file = 0;
        EXPECT_EQ(nc_open(path.c_str(), NC_WRITE, &file), NC_NOERR);
        EXPECT_EQ(nc_redef(file), NC_NOERR);
        change(file);
        nc_enddef(file);
        nc_close(file);
        return errorOf(path);
    };
    const auto renameDimension = [](int file, const char* from, const char* to) {
        int id = 0;
        EXPECT_EQ(nc_inq_dimid(file, from, &id), NC_NOERR);
        EXPECT_EQ(nc_rename_dim(file, id, to), NC_NOERR);
    };
    // Two blocks of 3 and 2 elements change their counts: the connectivity no longer fits.
    EXPECT_THAT(broken([&](int file) {
                    renameDimension(file, "num_el_in_blk1", "other");
                    renameDimension(file, "num_el_in_blk2", "num_el_in_blk1");
                    renameDimension(file, "other", "num_el_in_blk2");
                }),
                HasSubstr("does not have the shape"));
    EXPECT_THAT(broken([&](int file) {
                    renameDimension(file, "num_nodes", "nodes");
                    int id = 0;
                    EXPECT_EQ(nc_def_dim(file, "num_nodes", 5, &id), NC_NOERR);
                }),
                HasSubstr("does not have the shape"));
    EXPECT_THAT(broken([&](int file) {
                    renameDimension(file, "num_nodes", "nodes");
                    int id = 0;
                    EXPECT_EQ(nc_def_dim(file, "num_nodes", 2'000'000'000, &id), NC_NOERR);
                }),
                HasSubstr("num_nodes is 2,000,000,000, more than the file can hold"));
    EXPECT_THAT(broken([&](int file) {
                    int id = 0;
                    EXPECT_EQ(nc_inq_varid(file, "connect1", &id), NC_NOERR);
                    const std::string longWord(500, 'H');
                    EXPECT_EQ(nc_put_att_text(file, id, "elem_type", longWord.size(), longWord.data()), NC_NOERR);
                }),
                HasSubstr("does not say of which type"));
    EXPECT_THAT(broken([&](int file) {
                    const int sizes[] = {8, 8, 8};
                    EXPECT_EQ(nc_put_att_int(file, NC_GLOBAL, "floating_point_word_size", NC_INT, 3, sizes), NC_NOERR);
                }),
                HasSubstr("floating_point_word_size is not a number"));
    EXPECT_THAT(broken([&](int file) { EXPECT_EQ(nc_del_att(file, NC_GLOBAL, "version"), NC_NOERR); }),
                HasSubstr("no attribute version"));
}

TEST(ExodusDamage, ALongTitleIsNoDamage) {
    const TemporaryFolder folder;
    soundBuilder(false).write(folder / "title.exo");
    int file = 0;
    ASSERT_EQ(nc_open((folder / "title.exo").c_str(), NC_WRITE, &file), NC_NOERR);
    ASSERT_EQ(nc_redef(file), NC_NOERR);
    const std::string title(5000, 't');
    ASSERT_EQ(nc_put_att_text(file, NC_GLOBAL, "title", title.size(), title.data()), NC_NOERR);
    nc_close(file);
    EXPECT_TRUE(readsWhole(folder / "title.exo"));
}

TEST(ClassicHeader, SaysWhereTheFileEndsInEveryVersion) {
    const TemporaryFolder folder;
    for (const int mode : {NC_CLOBBER, NC_CLOBBER | NC_64BIT_OFFSET, NC_CLOBBER | NC_64BIT_DATA}) {
        for (const int recordVariables : {0, 1, 3}) {
            int file = 0, records = 0, width = 0, variable = 0;
            ASSERT_EQ(nc_create((folder / "c.nc").c_str(), mode, &file), NC_NOERR);
            nc_def_dim(file, "time", NC_UNLIMITED, &records);
            nc_def_dim(file, "width", 5, &width);
            nc_put_att_text(file, NC_GLOBAL, "note", 7, "odd len");
            nc_def_var(file, "fixed", NC_BYTE, 1, &width, &variable);
            const int dimensions[] = {records, width};
            std::vector<int> ids(static_cast<std::size_t>(recordVariables));
            for (int v = 0; v < recordVariables; ++v) {
                nc_def_var(file, ("r" + std::to_string(v)).c_str(), NC_SHORT, 2, dimensions, &ids[static_cast<std::size_t>(v)]);
            }
            nc_enddef(file);
            const signed char bytes[5] = {1, 2, 3, 4, 5};
            nc_put_var_schar(file, variable, bytes);
            const short shorts[15] = {};
            const std::size_t start[] = {0, 0}, count[] = {3, 5};
            for (const int id : ids) {
                nc_put_vara_short(file, id, start, count, shorts);
            }
            nc_close(file);
            const auto extent = classicExtent(folder / "c.nc");
            ASSERT_TRUE(extent);
            const auto size = static_cast<std::int64_t>(std::filesystem::file_size(folder / "c.nc"));
            EXPECT_LE(extent->bytes, size);
            EXPECT_GE(extent->bytes, size - 3) << "at most the padding of the last variable is not counted";
            EXPECT_TRUE(extent->wholeHeader);
        }
    }
}

}  // namespace
}  // namespace rubble::io
