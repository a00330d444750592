#pragma once

#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// Animation files of OpenRadioss (RUNA001, RUNA002, ..., plain or gzip-packed), one a state. The starter deck RUN_0000.rad, where
/// it lies beside them, is the last of the members.
bool recognisesAnim(const FileHead& head);
std::vector<std::string> animMembers(const std::string& path);
/// One state with the deck.
std::vector<std::string> animFilesAlone(const std::string& path);
FeResult::Contents readAnim(const std::string& path, const ImportSettings& settings, const Execution& execution);

/// The legacy VTK files that the solver's converter anim_to_vtk makes of them, one a state.
bool recognisesConvertedAnim(const FileHead& head);
std::vector<std::string> convertedAnimMembers(const std::string& path);
/// One state with the deck.
std::vector<std::string> convertedAnimFilesAlone(const std::string& path);
FeResult::Contents readConvertedAnim(const std::string& path, const ImportSettings& settings, const Execution& execution);

}  // namespace rubble::io
