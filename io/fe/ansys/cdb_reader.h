#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Coded databases of Ansys MAPDL (.cdb).
bool recognisesCdb(const FileHead& head);
/// The files of a number series, one a state; beside a single one the macro or log with its kills (.mac); and a list of deaths.
std::vector<std::string> cdbMembers(const std::string& path);
/// The same of a single file, whether or not others have numbers.
std::vector<std::string> cdbFilesAlone(const std::string& path);
/// Reads databases: deaths from the birth/death field of a series, else from EKILL and EALIVE of the macro, else from a list of
/// deaths, whose times then are the states. See FeFormat::read.
FeResult::Contents readCdbs(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
