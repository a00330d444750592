#pragma once

#include <string>

namespace rubble::io {

/// This machine in words, as far as it decides figures of time: "AMD EPYC 7R13, 2 threads, 7.6 GiB".
std::string machineText();

/// Folder for what can be made again: $RUBBLE_CACHE, else $XDG_CACHE_HOME/rubble, else $HOME/.cache/rubble (XDG base directories).
/// Throws WorldError if none of them is set to an absolute path.
std::string cacheFolder();

/// s of wall time between two checkpoints of a simulation: $RUBBLE_CHECKPOINT_SECONDS, else checkpointInterval. Throws UsageError
/// if that is no number above zero.
double checkpointSeconds();

/// Folder for what a program leaves for its next start (unsaved work, small pictures): $RUBBLE_STATE, else $XDG_STATE_HOME/rubble,
/// else $HOME/.local/state/rubble. Throws WorldError if none of them is set to an absolute path.
std::string stateFolder();

}  // namespace rubble::io
