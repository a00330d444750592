#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/fe/vtk/hdf5_table.h"

namespace rubble::io {

/// Values of one DataItem of an XDMF file: in an HDF5 file, a binary file or the text itself. Every member may be called from any
/// thread.
class XdmfItems {
public:
    /// @param path  of the XDMF file; heavy files are sought beside it
    explicit XdmfItems(std::string path) : m_path(std::move(path)) {}

    /// All values, row by row. Throws ParseError, WorldError naming the file.
    std::vector<double> reals(pugi::xml_node item) const;
    std::vector<std::int64_t> integers(pugi::xml_node item) const;
    /// Dimensions of an item, as written; empty where it says none. Throws for numbers that make no sense.
    std::vector<std::uint64_t> dimensions(pugi::xml_node item) const;
    /// The node that another one stands for by its attribute Reference; itself without one. Throws where it leads nowhere.
    pugi::xml_node resolved(pugi::xml_node node) const;
    /// The item that a node holds, through Reference; an empty node if there is none.
    pugi::xml_node itemOf(pugi::xml_node owner) const;
    /// Where an item in HDF5 lies: file and table; both empty for other items.
    std::pair<std::string, std::string> placeOf(pugi::xml_node item) const;
    /// The HDF5 file, opened once.
    const Hdf5Table& file(const std::string& path) const;
    [[noreturn]] void fail(const std::string& what) const;

private:
    template <class T>
    std::vector<T> fromText(const std::string& text, std::uint64_t count) const;
    template <class T>
    std::vector<T> fromBinary(pugi::xml_node item, std::uint64_t count) const;
    template <class T>
    std::vector<T> read(pugi::xml_node item) const;
    std::uint64_t countOf(pugi::xml_node item) const;

    std::string m_path;
    mutable std::mutex m_mutex;
    mutable std::map<std::string, std::unique_ptr<const Hdf5Table>> m_files;
};

}  // namespace rubble::io
