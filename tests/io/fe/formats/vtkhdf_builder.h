#pragma once

#include <hdf5.h>

#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "io/base/hdf5_handle.h"

namespace rubble::io {

/// Makes a file of HDF5 whose newest layout cannot be read at all where it is cut.
Hdf5Handle createTables(const std::string& path);
void putTable(hid_t file, const std::string& name, hid_t type, const void* values, hsize_t rows, hsize_t columns);
/// A table of rows, with the groups above it. @param values  [rows * columns]
template <class T>
void putTable(hid_t file, const std::string& name, const std::vector<T>& values, hsize_t columns = 1) {
    const hid_t type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : std::is_same_v<T, int> ? H5T_NATIVE_INT : H5T_NATIVE_UCHAR;
    putTable(file, name, type, values.data(), values.size() / columns, columns);
}

/// Unit bricks in a row along x, as one partition of a VTKHDF file has them.
struct VtkHdfPart {
    std::vector<int> bricks{};  ///< places by x; none: the partition is empty
    std::vector<int> ghosts{};  ///< vtkGhostType [bricks]; empty: all are its own
};

/// A VTKHDF file of partitions.
struct VtkHdfRows {
    std::vector<VtkHdfPart> parts{};
    std::vector<std::vector<int>> status{};          ///< STATUS [states][bricks of all partitions]; states are a second apart
    int states = 0;                                  ///< without STATUS
    bool meshAnew = false;                           ///< every state has partitions of its own
    std::map<int, std::vector<VtkHdfPart>> later{};  ///< other partitions from a state on
    bool partsCounted = true;                        ///< every state says how many partitions it has
    bool partsPlaced = true;                         ///< and with which it begins
    /// As the recorder of OpenSees 3.7 leaves it where its model changes: counts of a state's one partition for every state, and
    /// places of partitions, cells and connectivity that stay zero.
    bool recorded = false;
    std::vector<int> changes{};  ///< states before which the mesh was written once more for nobody
};
void writeVtkHdf(const std::string& path, const VtkHdfRows& rows);

}  // namespace rubble::io
