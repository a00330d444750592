#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/scenario/registration.h"
#include "core/trajectory/trajectory.h"
#include "io/case/terrain_reader.h"
#include "io/run/run_file.h"
#include "io/site/clouds/octree/octree_file.h"

namespace rubble::io {

/// What stands in one part of an export: a pane of a figure, a map, a table.
struct ShownPart {
    std::string name;             ///< "Conventional FE result"
    double time = 0.0;            ///< s, on the file's clock; where a movie begins
    std::optional<double> until;  ///< s, where it ends
    std::string shownAs;          ///< class of what is shown, as shownClass()
};

/// "FE", "simulated", "simulated, interpolated between two recorded instants", "illustrative".
std::string_view shownClass(FrameKind kind);

/// A file that a picture shows and no result rests on.
struct ShownFile {
    std::string role;  ///< "orthophoto", "surroundings"
    std::string path;  ///< absolute
    std::string sha256;
};

/// A point cloud whose points a picture shows.
struct ShownCloud {
    ShownFile file;
    std::optional<Registration> placed;    ///< unset: it lies by its coordinates alone
    std::uint64_t shown = 0;               ///< points, or places where distances were measured
    std::uint64_t all = 0;                 ///< of so many
    std::uint64_t far = 0;                 ///< points far from all others, which are not drawn
    std::optional<double> finest;          ///< m, width of the cells of which the finest level drawn has one point each
    bool whole = true;                     ///< no level was left out to keep their number
    std::string colours;                   ///< what they say: "own", "intensity", "height", "class", "distance"
    std::optional<double> detection;       ///< m, level of detection of distances in the median
    bool registrationInDetection = false;  ///< it holds the error of the registration
};

/// What an export was made from and how; everything that an exported file carries.
struct ExportRecord {
    std::string kind;  ///< "figure", "movie", "map", "table", "report"
    std::vector<ShownPart> shown;
    std::string settings;             ///< of the export, one JSON object; empty: none
    std::string view;                 ///< JSON of figures::toJson(); empty: none
    std::string casePath;             ///< of the case it was made in, absolute; empty: none
    std::vector<ShownFile> around{};  ///< drawn around the structure
    std::vector<ShownCloud> clouds{};
};

/// What stands at the foot of a picture: the first figures of the FE result and the run, and the program. @param simulated  false:
/// the FE result alone is shown
std::string footLine(const RunOrigin& origin, bool simulated = true);

/// Orthophoto and meshes as they were read.
std::vector<ShownFile> shownFiles(const TerrainInput& around);

/// The file of a cloud whose points are drawn, with its digest. @param then  the file when they were read
/// Throws WorldError (it is gone, or another one since), Cancelled.
ShownFile shownCloudFile(const std::string& path, const CloudStamp& then, const Execution& execution);

/// The record as one line of JSON in ASCII that begins with {"rubble_provenance":1. Inputs with SHA-256, scenario with all settings
/// that differ from the defaults, build, fingerprint and outcome of the run.
/// @param run  null: nothing was simulated
std::string exportProvenance(const ExportRecord& record, const RunOrigin& origin, const RunReader* run);

/// What an exported file says of itself.
struct ReadProvenance {
    std::string kind;
    std::string fePath;  ///< then
    std::string feSha256;
    std::string casePath;     ///< then; empty: none
    std::string runPath;      ///< then; empty: none
    std::string fingerprint;  ///< of the run, hex; empty: nothing was simulated
    std::string scenarioName;
    std::string view;     ///< JSON; empty: none
    double aspect = 0.0;  ///< width over height of the picture of that view; 0: not told
    std::string text;     ///< all of it, JSON
};

/// Reads what a figure (PNG, SVG, PDF), a movie (MP4) or a sidecar beside the file carries; nothing if it carries none.
/// Throws WorldError if the file cannot be read, ParseError if what it carries is damaged.
std::optional<ReadProvenance> readProvenance(const std::string& path);

/// The file that an export was made from, to be opened.
struct ExportSource {
    std::string path;  ///< a case or, where none was found, the FE result
    bool isCase = false;
    std::string scenarioId;  ///< of the case, by its name; empty: none has it
    std::string runPath;     ///< of the run, if it is still there and the same; empty: not
};

/// Finds the case of an export: where it says, beside the export, or among known ones, wherever the FE input has the same SHA-256;
/// failing that the FE result itself.
/// @param known  cases that may be it, such as recent ones
/// Throws WorldError naming what was looked for, and Cancelled.
ExportSource findSource(const ReadProvenance& provenance, const std::string& exportPath, std::span<const std::string> known,
                        const Execution& execution);

}  // namespace rubble::io
