#pragma once

#include <hdf5.h>

#include "io/base/hdf5_handle.h"

namespace rubble::io {

/// File driver of HDF5 for run files. It differs from the library's own in two ways that run files need:
/// - Once a write has failed (full disk), nothing more reaches the file: it stays as a killed writer would have left it, which
///   readers open at the last complete frame. Later writes are kept in memory, so that the library closes the file in an orderly
///   way and readers in this process go on. The caller asks runDriverError() after its calls.
/// - A file open for writing is shared with readers in this process, which so see every frame at once; readers of a file that
///   nobody here writes stand each for itself, as the library needs it to follow a writer in another process.
/// The caller holds an Hdf5Session.

/// File access list that uses the driver.
Hdf5Handle runFileAccess();

/// System error number of the first write that failed on a file opened with runFileAccess(), 0 if none did.
int runDriverError(hid_t file);

/// System error number of the last attempt to open that failed.
int runDriverOpenError();

}  // namespace rubble::io
