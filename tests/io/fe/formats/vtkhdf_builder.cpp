#include "tests/io/fe/formats/vtkhdf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

namespace rubble::io {

namespace {

void putAttribute(hid_t group, const char* name, hid_t type, const std::vector<int>& values, const void* bytes) {
    const hsize_t count = values.size();
    const Hdf5Handle space(count > 1 ? H5Screate_simple(1, &count, nullptr) : H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle made(H5Acreate2(group, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    ASSERT_GE(H5Awrite(made.get(), type, bytes), 0);
}

/// The tables of all partitions, one behind the other.
struct Partitions {
    std::vector<int> points, cells, entries, offsets, connectivity, ghosts;
    std::vector<double> places;

    void add(const VtkHdfPart& part) {
        std::map<int, int> known;  // point by 4 x + corner
        const auto first = connectivity.size();
        offsets.push_back(0);
        for (std::size_t b = 0; b < part.bricks.size(); ++b) {
            for (const int x : {part.bricks[b], part.bricks[b] + 1}) {
                for (int corner = 0; corner < 4; ++corner) {
                    const auto [found, isNew] = known.try_emplace(4 * x + corner, static_cast<int>(known.size()));
                    if (isNew) {
                        places.insert(places.end(), {double(x), double(corner == 1 || corner == 2), corner >= 2 ? 1.0 : 0.0});
                    }
                    connectivity.push_back(found->second);
                }
            }
            offsets.push_back(static_cast<int>(connectivity.size() - first));
            ghosts.push_back(b < part.ghosts.size() ? part.ghosts[b] : 0);
        }
        points.push_back(static_cast<int>(known.size()));
        cells.push_back(static_cast<int>(part.bricks.size()));
        entries.push_back(static_cast<int>(connectivity.size() - first));
    }
};

}  // namespace

Hdf5Handle createTables(const std::string& path) {
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose};
}

void putTable(hid_t file, const std::string& name, hid_t type, const void* values, hsize_t rows, hsize_t columns) {
    const std::vector<hsize_t> extent = columns > 1 ? std::vector<hsize_t>{rows, columns} : std::vector<hsize_t>{rows};
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose);
    const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.get(), 1);
    const Hdf5Handle set(H5Dcreate2(file, name.c_str(), type, space.get(), links.get(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    ASSERT_GE(H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
}

void writeVtkHdf(const std::string& path, const VtkHdfRows& rows) {
    const Hdf5Handle file = createTables(path);
    const Hdf5Handle grid(H5Gcreate2(file.get(), "VTKHDF", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    const Hdf5Handle steps(H5Gcreate2(file.get(), "VTKHDF/Steps", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    const int states = std::max(static_cast<int>(rows.status.size()), rows.states);
    const std::vector<int> version{2, rows.recorded ? 3 : 0}, count{states};
    putAttribute(grid.get(), "Version", H5T_NATIVE_INT, version, version.data());
    const Hdf5Handle word(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(word.get(), 16);
    putAttribute(grid.get(), "Type", word.get(), {0}, "UnstructuredGrid");
    putAttribute(steps.get(), "NSteps", H5T_NATIVE_INT, count, count.data());

    Partitions all;
    std::vector<int> status, partAt, pointAt, cellAt, entryAt, statusAt, parts;
    std::vector<double> times;
    std::vector<VtkHdfPart> now = rows.parts;
    const auto addAll = [&] {
        for (const VtkHdfPart& part : now) {
            all.add(part);
        }
    };
    for (int k = 0; k < states; ++k) {
        if (std::find(rows.changes.begin(), rows.changes.end(), k) != rows.changes.end()) {
            addAll();
        }
        const auto other = rows.later.find(k);
        if (other != rows.later.end()) {
            now = other->second;
        }
        if (k == 0 || rows.meshAnew || other != rows.later.end()) {
            partAt.push_back(static_cast<int>(all.points.size()));
            pointAt.push_back(static_cast<int>(all.places.size() / 3));
            cellAt.push_back(static_cast<int>(all.ghosts.size()));
            entryAt.push_back(static_cast<int>(all.connectivity.size()));
            addAll();
        } else {
            for (auto* at : {&partAt, &pointAt, &cellAt, &entryAt}) {
                at->push_back(at->back());
            }
        }
        if (!rows.status.empty()) {
            statusAt.push_back(static_cast<int>(status.size()));
            const std::vector<int>& flags = rows.status[static_cast<std::size_t>(k)];
            status.insert(status.end(), flags.begin(), flags.end());
        }
        parts.push_back(static_cast<int>(now.size()));
        times.push_back(k);
    }
    const auto put = [&](const std::string& name, const auto& values, hsize_t columns = 1) {
        putTable(file.get(), "/VTKHDF/" + name, values, columns);
    };
    if (rows.recorded) {
        for (std::vector<int>* counts : {&all.points, &all.cells, &all.entries}) {
            std::vector<int> ofStates;
            for (const int part : partAt) {
                ofStates.push_back((*counts)[static_cast<std::size_t>(part)]);
            }
            *counts = std::move(ofStates);
        }
        for (std::vector<int>* places : {&partAt, &cellAt, &entryAt}) {
            std::fill(places->begin(), places->end(), 0);
        }
    }
    put("NumberOfPoints", all.points);
    put("NumberOfCells", all.cells);
    put("NumberOfConnectivityIds", all.entries);
    put("Points", all.places, 3);
    put("Connectivity", all.connectivity);
    put("Offsets", all.offsets);
    put("Types", std::vector<unsigned char>(all.ghosts.size(), 12));
    if (!rows.status.empty()) {
        put("CellData/STATUS", status);
        put("Steps/CellDataOffsets/STATUS", statusAt);
    }
    if (!rows.recorded) {
        put("CellData/vtkGhostType", all.ghosts);
    }
    put("Steps/Values", times);
    put("Steps/PointOffsets", pointAt);
    put("Steps/CellOffsets", cellAt);
    put("Steps/ConnectivityIdOffsets", entryAt);
    if (rows.partsPlaced) {
        put("Steps/PartOffsets", partAt);
    }
    if (rows.partsCounted) {
        put("Steps/NumberOfParts", parts);
    }
}

}  // namespace rubble::io
