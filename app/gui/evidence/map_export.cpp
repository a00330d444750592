#include "app/gui/evidence/map_export.h"

#include <QFileInfo>

#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "widgets/figures/figure_file.h"
#include "widgets/run/caution_words.h"

namespace rubble {

figures::MapPictureStyle pictureStyle(const io::MapOrigin& origin, const std::vector<Caution>& cautions) {
    figures::MapPictureStyle style;
    style.place = io::SitePlace(origin.frame, origin.site).transform();
    style.system = origin.frame.crs;
    style.shown = origin.facts.front().second;
    style.provenance = io::inputsLine(origin);
    style.cautions = widgets::cautionWords(cautions).toStdString();
    return style;
}

void writeMapFile(const QString& path, const DebrisMap& map, MapLayer layer, const io::MapOrigin& origin,
                  const std::vector<Caution>& cautions, const Execution& execution, const std::optional<figures::MapRing>& ring) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    const std::string file = path.toStdString();
    if (suffix == QLatin1String("csv")) {
        io::writeMapCsv(file, map, map.present(), origin, execution);
    } else if (suffix == QLatin1String("png")) {
        figures::MapPictureStyle style = pictureStyle(origin, cautions);
        style.subject = origin.subject;
        style.fitted = true;
        style.ring = ring;
        figures::writePng(file, figures::mapPicture(map, layer, style));
        io::writeMapProvenance(file, origin);
    } else {
        io::writeMapTiff(file, map, map.present(), origin, execution);
    }
}

}  // namespace rubble
