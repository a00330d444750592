#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/scenario/case.h"

namespace rubble::io {

/// What names the content of an input, hex.
struct InputDigest {
    std::string sha256;      ///< of its one file, or of the list of its files as sha256OfSeries() makes it; empty: not read
    std::string fileSha256;  ///< of the one file that the case names; of an FE result the same as `sha256`

    /// Whether a digest that a case, a run or a bundle keeps is of this content. Older ones are of the file alone that the case
    /// names: what lies beside it was not part of them then, and counts as unchanged.
    bool is(const std::string& kept) const { return kept == sha256 || kept == fileSha256; }
    /// The digest to be held against one that was kept: the kept one itself if it is of this content.
    const std::string& against(const std::string& kept) const { return is(kept) ? kept : sha256; }
};

/// The files that can change what is read of an input. The one that the case names comes first, the others in the order of their
/// names: world file, projection, header, mask and GDAL's notes of a raster, the parts of a Shapefile, materials, buffers and the
/// offset of a mesh, the whole series of an FE result. Notes that hold nothing but statistics are none, nor are pyramids.
/// A photograph is one file. Throws WorldError for an FE result.
std::vector<std::string> filesOfInput(const std::string& path, InputRole role);

/// The same, and behind them what programs keep beside an input without changing what is read of it: what travels with it.
std::vector<std::string> filesWithInput(const std::string& path, InputRole role);

/// Digest of a file in the role of an input, with all that filesOfInput() names. Throws WorldError, ParseError, Cancelled.
InputDigest digestOfInput(const std::string& path, InputRole role, const Execution& execution);

}  // namespace rubble::io
