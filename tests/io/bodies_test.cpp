#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

#include "core/base/error.h"
#include "io/exports/exports.h"
#include "tests/io/sample_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

std::string textOf(const std::string& path) {
    std::ifstream stream(path);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Rows of a dataset as any program reads them, by the words of an XDMF file.
std::vector<float> slabOf(const std::string& file, const std::string& dataset, hsize_t first, hsize_t rows) {
    const hid_t handle = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(handle, dataset.c_str(), H5P_DEFAULT);
    const hid_t space = H5Dget_space(set);
    const std::array<hsize_t, 2> start{first, 0};
    const std::array<hsize_t, 2> count{rows, 3};
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    const hid_t memory = H5Screate_simple(2, count.data(), nullptr);
    std::vector<float> values(rows * 3);
    EXPECT_GE(H5Dread(set, H5T_NATIVE_FLOAT, memory, space, H5P_DEFAULT, values.data()), 0);
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(handle);
    return values;
}

TEST(BodiesExport, NamesThePlacesOfEveryFrameInTheRunFile) {
    TemporaryFolder folder;
    const SampleRun sample = makeSampleRun(3, 15, 9);
    sample.feed(*createRun(folder / "a.run.h5", sample.origin));
    std::filesystem::create_directory(folder / "out");
    auto run = openRun(folder / "a.run.h5");
    exportBodies(folder / "out/a.xdmf", *run, Execution());
    std::vector<std::shared_ptr<const TrajectoryFrame>> frames;
    for (std::size_t i = 0; i < run->frameCount(); ++i) {
        frames.push_back(run->frame(i));
    }
    run.reset();
    const std::string text = textOf(folder / "out/a.xdmf");
    const std::regex item(
        R"re(<Geometry[^>]*>\s*<DataItem[^>]*Dimensions="(\d+) 3">([^:<]+):([^|<]+)\|(\d+) 0:1 1:(\d+) 3:\d+ 3<)re");
    std::size_t i = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), item), end; it != end; ++it, ++i) {
        ASSERT_LT(i, frames.size());
        const std::size_t rows = std::stoul((*it)[1]);
        ASSERT_EQ(rows, frames[i]->bodies());
        EXPECT_EQ((*it)[1], (*it)[5]);
        const auto values =
            slabOf((std::filesystem::path(folder / "out") / (*it)[2].str()).string(), (*it)[3], std::stoul((*it)[4]), rows);
        for (std::size_t b = 0; b < rows; ++b) {
            EXPECT_EQ(values[3 * b], frames[i]->positions[b].x());
            EXPECT_EQ(values[3 * b + 2], frames[i]->positions[b].z());
        }
    }
    EXPECT_EQ(i, frames.size());
    EXPECT_THAT(text, testing::HasSubstr("CollectionType=\"Temporal\""));
    EXPECT_THAT(text, testing::HasSubstr("../a.run.h5:/frames/speeds"));
}

TEST(BodiesExport, ATopologyNamesItsPointsOnceForFramesOfAsManyBodies) {
    TemporaryFolder folder;
    const SampleRun sample = makeSampleRun(3, 15, 9);
    sample.feed(*createRun(folder / "a.run.h5", sample.origin));
    const auto run = openRun(folder / "a.run.h5");
    exportBodies(folder / "a.xdmf", *run, Execution());
    pugi::xml_document document;
    ASSERT_TRUE(document.load_file((folder / "a.xdmf").c_str()));
    std::map<std::size_t, std::string> first;  // of as many bodies: where the list stands
    std::size_t i = 0;
    for (const pugi::xml_node grid : document.child("Xdmf").child("Domain").child("Grid").children("Grid")) {
        const std::size_t bodies = run->frame(i)->bodies();
        const std::string place = "xpointer(/Xdmf/Domain/Grid/Grid[" + std::to_string(++i) + "]/Topology)";
        const auto [known, isNew] = first.emplace(bodies, place);
        if (!isNew) {
            EXPECT_EQ(grid.child("xi:include").attribute("xpointer").value(), known->second);
            continue;
        }
        std::istringstream points(grid.child("Topology").child_value("DataItem"));
        std::size_t count = 0;
        for (std::size_t point = 0; points >> point; ++count) {
            EXPECT_EQ(point, count);
        }
        EXPECT_EQ(count, bodies);
    }
    EXPECT_EQ(i, run->frameCount());
    EXPECT_LT(first.size(), i);
}

TEST(BodiesExport, ARunWithoutBodiesIsRefused) {
    TemporaryFolder folder;
    const SampleRun sample = makeSampleRun(3, 0, 2);
    sample.feed(*createRun(folder / "a.run.h5", sample.origin));
    EXPECT_THROW(exportBodies(folder / "a.xdmf", *openRun(folder / "a.run.h5"), Execution()), UsageError);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.xdmf"));
}

}  // namespace

}  // namespace rubble::io
