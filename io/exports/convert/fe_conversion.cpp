#include "io/exports/convert/fe_conversion.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/fe/frame_transform.h"
#include "core/fe/loose_bodies.h"
#include "io/base/files.h"
#include "io/exports/convert/exodus_writer.h"
#include "io/exports/convert/grid_writer.h"
#include "io/fe/fe_copy/copy_writer.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

ConversionTarget requireTarget(const std::string& path) {
    if (const auto target = conversionTarget(path)) {
        return *target;
    }
    throw UsageError({"convert.ending", "{0} does not say what to convert to", {path}},
                     {"convert.ending.remedy",
                      "Let the name end in .exo (Exodus II), .pvd (a series of VTU files) or .h5 (a copy that opens at once).",
                      {}});
}

// Files of the result itself, and the folder that a series would replace.
void requireNoInput(const FeResult& fe, const std::string& path, ConversionTarget target) {
    std::error_code ignored;
    const std::string folder = gridFolder(path);
    for (const std::string& input : fe.contents().files) {
        const bool inside =
            target == ConversionTarget::GridSeries && fs::equivalent(fs::absolute(input).parent_path(), folder, ignored);
        if (inside || fs::equivalent(input, path, ignored)) {
            throw UsageError({"convert.input", "{0} would be written over {1}, which is read", {path, input}},
                             {"convert.input.remedy", "Give the output another name.", {}});
        }
    }
}

void requireFree(const std::string& path, ConversionTarget target) {
    std::error_code ignored;
    const std::string folder = gridFolder(path);
    for (const std::string& there : {path, folder}) {
        if ((there == path || target == ConversionTarget::GridSeries) && fs::exists(there, ignored)) {
            throw UsageError({"convert.exists", "{0} is there already", {there}},
                             {"convert.exists.remedy", "Give another name, or replace it: rubble-cli convert --force.", {}});
        }
    }
}

std::uint64_t bytesIn(const std::string& path) {
    std::error_code ignored;
    std::uint64_t bytes = 0;
    if (!fs::is_directory(path, ignored)) {
        const std::uintmax_t size = fs::file_size(path, ignored);
        return ignored ? 0 : size;
    }
    for (fs::directory_iterator entry(path, ignored), end; entry != end; entry.increment(ignored)) {
        bytes += bytesIn(entry->path().string());
    }
    return bytes;
}

/// A copy would be taken for a structure, and the tetrahedra of a body for bodies of their own.
void requireNoBodies(const FeResult& fe, const std::string& path, ConversionTarget target) {
    if (fe.contents().looseBodies && (target == ConversionTarget::Copy || !bodiesOfTable(fe).empty())) {
        throw UsageError(
            {"convert.bodies", "A table of bodies cannot be kept as {0}: it would no longer say which bodies it has", {path}},
            {"convert.bodies.remedy", "Open the table itself wherever the copy was to be opened.", {}});
    }
}

}  // namespace

std::optional<ConversionTarget> conversionTarget(std::string_view path) {
    std::string ending = fs::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (ending == ".exo" || ending == ".e" || ending == ".ex2") {
        return ConversionTarget::Exodus;
    }
    if (ending == ".pvd") {
        return ConversionTarget::GridSeries;
    }
    return ending == ".h5" ? std::optional(ConversionTarget::Copy) : std::nullopt;
}

std::string_view conversionName(ConversionTarget target) {
    return target == ConversionTarget::Exodus       ? "Exodus II"
           : target == ConversionTarget::GridSeries ? "series of VTU files"
                                                    : "Rubble copy";
}

Conversion convertFe(const FeResult& fe, const Frame& frame, const std::string& path, bool replace, const Execution& execution) {
    Conversion made{requireTarget(path), fe.stateCount(), {path}, 0};
    requireNoBodies(fe, path, made.target);
    requireNoInput(fe, path, made.target);
    if (!replace) {
        requireFree(path, made.target);
    }
    const Vec3 offset = FrameTransform(frame).localZero();
    if (made.target == ConversionTarget::GridSeries) {
        writeGridSeries(path, fe, offset, replace, execution);
        made.files.push_back(gridFolder(path));
    } else {
        writeFileAtomically(path, [&](const std::string& file) {
            if (made.target == ConversionTarget::Exodus) {
                writeExodus(file, fe, offset, execution);
            } else {
                writeFeCopy(file, fe, offset, execution);
            }
        });
    }
    for (const std::string& file : made.files) {
        made.bytes += bytesIn(file);
    }
    return made;
}

}  // namespace rubble::io
