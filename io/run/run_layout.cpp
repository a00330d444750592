#include "io/run/run_layout.h"

#include <cstddef>

#include "io/run/run_tables.h"

namespace rubble::io {

namespace {

// Rows of a frame dataset that are compressed together. Every flush writes the last, unfinished chunk anew at another place, and
// the old one is lost space while readers may be there; smaller chunks lose less, larger ones compress a little better.
constexpr std::size_t frameChunk = 2048;
constexpr std::size_t textChunk = 65536;
constexpr std::size_t tableChunk = 512;
constexpr std::size_t listChunk = 16384;

template <class T>
RunDatasetLayout tableOf(RunDataset dataset, const char* path) {
    return {dataset, path, columnCount<T>(), tableChunk, columnCount<T>() * sizeof(double), columnNames<T>()};
}

std::array<RunDatasetLayout, runDatasetCount> makeLayouts() {
    using D = RunDataset;
    return {{
        {D::Index, "/frames/index", 1, 1024, sizeof(FrameRow), {}},
        {D::Positions, "/frames/positions", 3, frameChunk, 12, {"x", "y", "z"}},
        {D::Orientations, "/frames/orientations", 4, frameChunk, 16, {"x", "y", "z", "w"}},
        {D::Speeds, "/frames/speeds", 1, frameChunk, 4, {"speed"}},
        {D::States, "/frames/states", 1, frameChunk, 1, {"state"}},
        tableOf<BodyRecord>(D::Bodies, "/bodies"),
        tableOf<Carrier>(D::Carriers, "/carriers"),
        tableOf<LedgerRow>(D::Ledger, "/ledger"),
        tableOf<Fragment>(D::Fragments, "/fragments/table"),
        {D::Vertices, "/fragments/vertices", 3, listChunk, 24, {"x", "y", "z"}},
        {D::VertexOffsets, "/fragments/vertex_offsets", 1, listChunk, 4, {"offset"}},
        {D::Solids, "/fragments/solids", 1, listChunk, 1, {"shape"}},
        {D::ElementIds, "/fragments/element_ids", 1, listChunk, 8, {"element"}},
        tableOf<Cluster>(D::Clusters, "/clusters/table"),
        {D::ClusterMembers, "/clusters/members", 1, listChunk, 4, {"fragment"}},
        {D::ClusterOf, "/clusters/of", 1, listChunk, 4, {"cluster"}},
        tableOf<FragmentOutcome>(D::Outcomes, "/result/fragments"),
        {D::Origin, "/origin", 1, textChunk, 1, {"json"}},
        {D::Description, "/description", 1, textChunk, 1, {"json"}},
        {D::Result, "/result/summary", 1, textChunk, 1, {"json"}},
        {D::Digests, "/digests", 1, textChunk, 1, {"json"}},
        tableOf<IslandRow>(D::Islands, "/islands/table"),
        {D::IslandElements, "/islands/elements", 1, listChunk, 4, {"element"}},
        tableOf<LedgerRow>(D::IslandLedger, "/islands/ledger"),
        {D::Breaches, "/breaches", 1, textChunk, 1, {"json"}},
        tableOf<IslandPlaceRow>(D::IslandPlaces, "/islands/places"),
        tableOf<IslandLoss>(D::IslandLosses, "/islands/losses"),
    }};
}

Hdf5Handle frameRowType(hid_t real, hid_t large, hid_t small, const std::array<std::size_t, 5>& offsets, std::size_t size) {
    Hdf5Handle type(H5Tcreate(H5T_COMPOUND, size), H5Tclose);
    H5Tinsert(type.get(), "time", offsets[0], real);
    H5Tinsert(type.get(), "offset", offsets[1], large);
    H5Tinsert(type.get(), "checksum", offsets[2], large);
    H5Tinsert(type.get(), "bodies", offsets[3], small);
    H5Tinsert(type.get(), "kind", offsets[4], small);
    return type;
}

enum class Number { Byte, Unsigned, Integer, Single, Double };

Number numberOf(RunDataset dataset) {
    switch (dataset) {
        case RunDataset::Positions:
        case RunDataset::Orientations:
        case RunDataset::Speeds:
            return Number::Single;
        case RunDataset::VertexOffsets:
        case RunDataset::ClusterMembers:
        case RunDataset::ClusterOf:
        case RunDataset::IslandElements:
            return Number::Unsigned;
        case RunDataset::ElementIds:
            return Number::Integer;
        case RunDataset::States:
        case RunDataset::Solids:
        case RunDataset::Origin:
        case RunDataset::Description:
        case RunDataset::Result:
        case RunDataset::Digests:
        case RunDataset::Breaches:
            return Number::Byte;
        default:
            return Number::Double;
    }
}

Hdf5Handle plainType(Number number, bool inFile) {
    hid_t type = inFile ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE;
    if (number == Number::Byte) {
        type = inFile ? H5T_STD_U8LE : H5T_NATIVE_UINT8;
    } else if (number == Number::Unsigned) {
        type = inFile ? H5T_STD_U32LE : H5T_NATIVE_UINT32;
    } else if (number == Number::Integer) {
        type = inFile ? H5T_STD_I64LE : H5T_NATIVE_INT64;
    } else if (number == Number::Single) {
        type = inFile ? H5T_IEEE_F32LE : H5T_NATIVE_FLOAT;
    }
    return Hdf5Handle(H5Tcopy(type), H5Tclose);
}

}  // namespace

const RunDatasetLayout& layoutOf(RunDataset dataset) {
    static const std::array<RunDatasetLayout, runDatasetCount> layouts = makeLayouts();
    return layouts[static_cast<std::size_t>(dataset)];
}

Hdf5Handle memoryTypeOf(RunDataset dataset) {
    if (dataset == RunDataset::Index) {
        return frameRowType(H5T_NATIVE_DOUBLE, H5T_NATIVE_UINT64, H5T_NATIVE_UINT32,
                            {offsetof(FrameRow, time), offsetof(FrameRow, offset), offsetof(FrameRow, checksum),
                             offsetof(FrameRow, bodies), offsetof(FrameRow, kind)},
                            sizeof(FrameRow));
    }
    return plainType(numberOf(dataset), false);
}

Hdf5Handle fileTypeOf(RunDataset dataset) {
    if (dataset == RunDataset::Index) {
        return frameRowType(H5T_IEEE_F64LE, H5T_STD_U64LE, H5T_STD_U32LE, {0, 8, 16, 24, 28}, 32);
    }
    return plainType(numberOf(dataset), true);
}

const std::array<RunDataset, runDatasetCount>& runDatasets() {
    static const auto all = [] {
        std::array<RunDataset, runDatasetCount> datasets{};
        for (std::size_t i = 0; i < datasets.size(); ++i) {
            datasets[i] = static_cast<RunDataset>(i);
        }
        return datasets;
    }();
    return all;
}

}  // namespace rubble::io
