#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/fe/d3plot/d3plot_family.h"

namespace rubble::io {

/// Reads the titles of the parts, in internal order, from the sections that stand behind the end mark of the geometry; empty if
/// there are none or they are damaged. @param ids  gets the number beside each title, which may be the user's or the internal one
std::vector<std::string> readD3plotTitles(const D3plotFamily& family, std::int64_t word, std::vector<std::int64_t>& ids);

}  // namespace rubble::io
