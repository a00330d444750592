#pragma once

#include <QSize>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/accuracy/ensemble_request.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "io/exports/ensemble_origin.h"

namespace rubble::cli {

/// One row for each figure: its spread over the members.
TextTable spreadTable(const EnsembleReport& report);
/// One row for each member: what was drawn and what came of it.
TextTable memberTable(const EnsembleReport& report);
/// One row for each number of members: how far means and probabilities may be off.
TextTable convergenceTable(const EnsembleReport& report);

Json spreadJson(const FigureSpread& spread);
Json ensembleJson(const EnsembleReport& report, const DebrisMap* map);
void printEnsemble(std::ostream& out, const EnsembleReport& report);

/// Maps of ensembles: what --out and --layers ask for.
class EnsembleMaps {
public:
    static std::vector<Option> options();
    /// Throws UsageError for endings and layers that there are not.
    EnsembleMaps(const Arguments& arguments, std::vector<MapLayer> pictured);

    /// Writes every file asked for, and into a folder: NAME.tif, NAME.csv and a picture of each of the layers that matter most.
    /// @return  the files. Throws what the writers throw
    /// @param place  ringed on pictures; unset: none
    std::vector<std::string> write(const DebrisMap& map, const std::string& name, const io::MapOrigin& origin,
                                   const std::vector<Caution>& cautions, const std::optional<TellingPlace>& place,
                                   Session& session) const;
    /// Folders among what --out names.
    std::vector<std::string> folders() const;

private:
    void writeOne(const std::string& path, const DebrisMap& map, const std::vector<MapLayer>& layers, const io::MapOrigin& origin,
                  const std::vector<Caution>& cautions, const std::optional<TellingPlace>& place, Session& session) const;

    std::vector<std::string> m_paths;
    std::vector<MapLayer> m_layers;    ///< asked for; empty: all
    std::vector<MapLayer> m_pictured;  ///< in a folder
    std::optional<QSize> m_pixels;
};

}  // namespace rubble::cli
