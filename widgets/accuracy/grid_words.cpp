#include "widgets/accuracy/grid_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "widgets/basics/translated.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr double aBit = 1e-9;  // share by which a size may pass a bound unsaid

QString reasonByHand(QChar which, const AxisSizing& axis, bool byComponents, const QString& component) {
    if (axis.size < axis.accuracyMin * (1.0 - aBit)) {
        return tr("%1: smaller than the largest fragment, %2, which then joins no group of its width.")
            .arg(which)
            .arg(shownLength(axis.accuracyMin));
    }
    if (byComponents && axis.smallestComponent && axis.size > axis.accuracyMax * (1.0 + aBit)) {
        return tr("%1: larger than the smallest component (%2, %3); clusters are split between components all the same.")
            .arg(which)
            .arg(component, shownLength(axis.accuracyMax));
    }
    return {};
}

}  // namespace

QString axisReason(char name, const AxisSizing& axis, bool byHand, bool byComponents, const Components* components) {
    const QString component = axis.smallestComponent && components != nullptr
                                  ? QString::fromStdString(components->list[at(*axis.smallestComponent)].name)
                                  : tr("the smallest component");
    const QString least = shownLength(axis.accuracyMin);
    const QString most = shownLength(axis.accuracyMax);
    const QChar which = QLatin1Char(name);
    if (byHand) {
        return reasonByHand(which, axis, byComponents, component);
    }
    switch (axis.clampedBy) {
        case ClampedBy::FragmentSize:
            return axis.accuracyMin > axis.accuracyMax
                       ? tr("%1: the largest fragment (%2) exceeds the smallest component (%3, %4). Clusters stay within one "
                            "component all the same.")
                             .arg(which)
                             .arg(least, component, most)
                       : tr("%1: held at the largest fragment, %2.").arg(which).arg(least);
        case ClampedBy::ComponentSize:
            return tr("%1: held at the smallest component (%2, %3).").arg(which).arg(component, most);
        case ClampedBy::Spacing:
            return tr("%1: the mean distance (%2) exceeds the smallest component (%3, %4).")
                .arg(which)
                .arg(shownLength(axis.meanDistance), component, most);
        case ClampedBy::None:
            break;
    }
    return {};
}

QString multipleReason(const GridSettings& settings) {
    if (settings.oneBodyPerFragment) {
        return tr("Every fragment moves alone (One body per fragment): there is no grid.");
    }
    QStringList byHand;
    for (const auto& [size, name] :
         {std::pair(settings.length, "x"), std::pair(settings.width, "y"), std::pair(settings.height, "z")}) {
        if (size) {
            byHand << QLatin1String(name);
        }
    }
    if (byHand.size() == 3) {
        return tr("All three sizes are set by hand: the multiple decides nothing.");
    }
    return byHand.isEmpty() ? QString()
                            : tr("Set by hand along %1: the multiple decides the rest.").arg(byHand.join(QStringLiteral(", ")));
}

QString stopReason(const Sizing& sizing) {
    switch (sizing.stoppedBy) {
        case StoppedBy::Efficiency:
            return tr("The search stopped at the smallest multiple that keeps to the bodies allowed.");
        case StoppedBy::FpsUnreachable:
            return tr("%1 FPS is out of reach within the bounds of the sizes: about %2 FPS is. The run goes on at the upper "
                      "bounds.")
                .arg(shownNumber(sizing.fpsTarget), shownNumber(sizing.reachableFps, 2));
        case StoppedBy::User:
            break;
    }
    return tr("Set by hand.");
}

}  // namespace rubble::widgets
