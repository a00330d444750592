#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "io/fe/xdmf/xdmf_item.h"

namespace rubble::io {

/// One state: pieces of the structure, each as grids of one mesh. The first grid of a piece has the mesh, all may have arrays.
struct XdmfState {
    double time = 0.0;
    std::vector<std::vector<pugi::xml_node>> pieces;
};

/// The states of a file.
struct XdmfStates {
    std::vector<XdmfState> list;  ///< by time
    bool timed = true;            ///< false: some were counted, since nothing says their time
    std::size_t dropped = 0;      ///< times that some collections have and others lack
    Findings findings;            ///< branches that a restart abandoned
};

/// Finds the states. Where there are temporal collections, these alone are states, and a grid beside them is a mesh. Collections of
/// one time each give arrays or pieces to one state; one with the arrays of another goes on with it. Where a collection goes back
/// in time, what it abandons does not count; one whose grids are named in the order of their times is in disorder only. Without
/// temporal collections all grids of one time are one state. Throws ParseError.
XdmfStates findXdmfStates(const pugi::xml_document& document, const XdmfItems& items);

/// A child of a grid, its own, one that it refers to, or one taken in by XInclude with any prefix; an empty node if there is none.
pugi::xml_node xdmfPart(pugi::xml_node grid, const std::string& name, const XdmfItems& items);

/// Whether two nodes hold the same item, as far as can be told without reading it.
bool sameXdmfItem(pugi::xml_node a, pugi::xml_node b, const XdmfItems& items);

/// The value of a type of XDMF in small letters: the attribute of this name, or Type.
std::string xdmfType(pugi::xml_node node, const char* longName);
std::string xdmfLowerCase(std::string text);

}  // namespace rubble::io
