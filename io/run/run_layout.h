#pragma once

#include <hdf5.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "io/base/hdf5_handle.h"

namespace rubble::io {

inline constexpr const char* runFormatName = "rubble-run";
inline constexpr int runVersion = 1;

/// Every dataset of a run file. All are lists of rows that only grow; all exist before the first frame, since nothing can be added
/// once readers may be there (HDF5, single writer with readers).
enum class RunDataset {
    Index,         ///< one row per committed frame; written last
    Positions,     ///< m, of the bodies of all frames, one frame after the other [rows, 3]
    Orientations,  ///< x, y, z, w [rows, 4]
    Speeds,        ///< m/s
    States,        ///< BodyState
    Bodies,
    Carriers,
    Ledger,
    Fragments,
    Vertices,       ///< m, solids of the fragments at hand-over [rows, 3]
    VertexOffsets,  ///< first vertex of each fragment [fragments + 1]
    Solids,         ///< ElementShape of each solid
    ElementIds,     ///< user's element number of each fragment
    Clusters,
    ClusterMembers,  ///< fragments, cluster by cluster
    ClusterOf,       ///< cluster of each fragment
    Outcomes,        ///< where each fragment went; double precision
    Origin,          ///< JSON text
    Description,     ///< JSON text: component names, sizing, findings; there once everything before the first step is
    Result,          ///< JSON text
    Digests,         ///< JSON text: row count and hash of every other dataset; there once the run is complete
    Islands,         ///< islands of live structure: body, and where its elements are; runs before these have none
    IslandElements,  ///< indices of elements, island by island
    IslandLedger,    ///< a row each time that islands came
    Breaches,        ///< JSON text, a line for each breach that began, or grew, while the run went on; runs before these have none
    IslandPlaces,    ///< of each island; runs before these released all at the last state
    IslandLosses,    ///< a row for each state at which islands lost elements
};
inline constexpr std::size_t runDatasetCount = 27;
/// Files that were written before a dataset came up lack it, and read as if it were empty.
constexpr bool mayBeMissing(RunDataset dataset) {
    return dataset == RunDataset::Islands || dataset == RunDataset::IslandElements || dataset == RunDataset::IslandLedger ||
           dataset == RunDataset::Breaches || dataset == RunDataset::IslandPlaces || dataset == RunDataset::IslandLosses;
}

/// One of the lists that every frame adds as many rows to as it has bodies.
constexpr bool growsWithFrames(RunDataset dataset) {
    return dataset == RunDataset::Positions || dataset == RunDataset::Orientations || dataset == RunDataset::Speeds ||
           dataset == RunDataset::States;
}

/// An island; its elements are a part of IslandElements.
struct IslandRow {
    std::uint32_t body = 0;
    std::uint32_t firstElement = 0;
    std::uint32_t elementCount = 0;
};

/// The FE state whose places the elements of an island have, and its body's frame among them.
struct IslandPlaceRow {
    std::uint32_t state = 0;
    Pose inFe;
};

/// One committed frame.
struct FrameRow {
    double time = 0.0;
    std::uint64_t offset = 0;    ///< of its first row in the frame datasets
    std::uint64_t checksum = 0;  ///< of the four arrays and of the time
    std::uint32_t bodies = 0;
    std::uint32_t kind = 0;
};

/// How a dataset lies in the file.
struct RunDatasetLayout {
    RunDataset dataset;
    const char* path;
    std::size_t width;      ///< numbers per row
    std::size_t chunkRows;  ///< rows compressed together
    std::size_t rowBytes;   ///< in memory
    std::vector<std::string> columns;
};

const RunDatasetLayout& layoutOf(RunDataset dataset);
/// Type of one number (or of one FrameRow) in memory and in the file. The caller holds an Hdf5Session.
Hdf5Handle memoryTypeOf(RunDataset dataset);
Hdf5Handle fileTypeOf(RunDataset dataset);

/// The datasets in file order.
const std::array<RunDataset, runDatasetCount>& runDatasets();

}  // namespace rubble::io
