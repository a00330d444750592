#include "app/gui/evidence/surveys/distance_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "widgets/basics/wording.h"

namespace rubble {

namespace {

/// Texts of this file.
struct DistanceWords {
    Q_DECLARE_TR_FUNCTIONS(rubble::DistanceWords)
};

QString errorText(double error, double cube) {
    return std::isfinite(error) ? widgets::shownNumber(cube * error) : DistanceWords::tr("not known");
}

QString volumeText(double volume, const CloudVolumeError& error, double cube) {
    return DistanceWords::tr("%1 m³ (± %2 random, ± %3 systematic)")
        .arg(widgets::shownNumber(cube * volume), errorText(error.random, cube), errorText(error.systematic, cube));
}

}  // namespace

QString detectionWords(double detection, bool registered) {
    if (!std::isfinite(detection)) {
        return DistanceWords::tr("The level of detection is not known.");
    }
    const QString number = widgets::shownNumber(detection);
    return registered ? DistanceWords::tr("Level of detection %1 m in the middle (95 %).").arg(number)
                      : DistanceWords::tr(
                            "Level of detection %1 m in the middle (95 %), of roughness alone: nobody stated the "
                            "registration error.")
                            .arg(number);
}

QString volumeWords(const CloudVolumes& volumes, double cube) {
    if (volumes.measured == 0) {
        return DistanceWords::tr("Volumes are not known: no cell was measured.");
    }
    QStringList words{DistanceWords::tr("Fill %1, cut %2, net %3, at 95 %.")
                          .arg(volumeText(volumes.fill, volumes.fillError, cube), volumeText(volumes.cut, volumes.cutError, cube),
                               volumeText(volumes.net(), volumes.netError, cube))};
    words << DistanceWords::tr("Below the level of detection also lie fill %1, cut %2 m³, which are not counted.")
                 .arg(widgets::shownNumber(cube * volumes.undetectedFill), widgets::shownNumber(cube * volumes.undetectedCut));
    words << DistanceWords::tr("Cells measured: %1 of %2.")
                 .arg(widgets::shownCount(volumes.measured), widgets::shownCount(volumes.cells));
    return words.join(QLatin1Char(' '));
}

QString sightWords(const io::RunDistance& made) {
    if (made.sights == io::SightsFrom::Above) {
        return DistanceWords::tr("Seen straight from above: where the scanners stood is not known.");
    }
    return made.sights == io::SightsFrom::Asked
               ? DistanceWords::tr("Seen from the scanners that were given: %1.").arg(made.scanners)
               : DistanceWords::tr("Seen from the scanners that the cloud names: %1.").arg(made.scanners);
}

QString pairWords(const io::CloudComparison& made) {
    std::int64_t measured = 0;
    std::int64_t significant = 0;
    for (const CoreDistance& core : made.distances) {
        measured += core.state == CoreState::Measured ? 1 : 0;
        significant += core.significant() ? 1 : 0;
    }
    QStringList words{DistanceWords::tr("%1 of %2 distances differ by more than the level of detection.")
                          .arg(widgets::shownCount(significant), widgets::shownCount(measured))};
    words << detectionWords(middleDetection(made.distances), made.settings.registrationError.has_value());
    if (made.volumes) {
        words << volumeWords(*made.volumes, made.cubicMetres)
              << DistanceWords::tr("Fill is where the second cloud lies above the first.");
    }
    return words.join(QLatin1Char(' '));
}

}  // namespace rubble
