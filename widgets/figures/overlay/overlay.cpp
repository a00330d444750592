#include "widgets/figures/overlay/overlay.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "widgets/figures/draw.h"
#include "widgets/figures/material_words.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/point_colours.h"
#include "widgets/figures/shown_units.h"
#include "widgets/figures/translated.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/colour_choice.h"

namespace rubble::figures {
namespace {

constexpr std::size_t longestLegend = 6;

QColor colourOf(const render::Rgb& c) {
    return {c.r, c.g, c.b};
}

/// One line for each component that has most fragments, the rest in one.
void addComponents(std::vector<LegendEntry>& legend, const render::View& view, const render::SceneData& data,
                   const render::PaneStatus& status, const render::SceneColours& colours) {
    const auto& components = data.components;
    if (!components || status.bornByComponent.size() != components->list.size()) {
        return;
    }
    std::vector<std::size_t> order(components->list.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return status.bornByComponent[a] > status.bornByComponent[b]; });
    std::erase_if(order, [&](std::size_t c) { return status.bornByComponent[c] == 0; });
    const std::size_t shown = order.size() > longestLegend ? longestLegend - 1 : order.size();
    std::size_t rest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t c = order[i];
        if (i >= shown) {
            rest += status.bornByComponent[c];
            continue;
        }
        const auto chosen = view.componentColours.find(components->list[c].name);
        legend.push_back(
            {colourOf(chosen != view.componentColours.end() ? chosen->second : render::colour_choice::category(colours, c)),
             QString::fromStdString(components->list[c].name) + QStringLiteral(" · ") + countText(status.bornByComponent[c])});
    }
    if (rest > 0) {
        legend.push_back({QColor(), tr("%1 more components · %2").arg(order.size() - shown).arg(countText(rest))});
    }
}

/// What stands, and one line for each of the largest islands with its number, the rest in one.
void addIslands(std::vector<LegendEntry>& legend, const Palette& p, const render::PaneStatus& status,
                const render::SceneColours& colours) {
    if (!status.islandsKnown) {
        legend.push_back({QColor(), tr("loose islands are not known yet")});
        return;
    }
    const auto& islands = status.islands;
    const std::size_t shown = islands.size() > longestLegend ? longestLegend - 1 : islands.size();
    const std::size_t loose =
        std::accumulate(islands.begin(), islands.end(), std::size_t{0},
                        [](std::size_t sum, const render::ShownIsland& island) { return sum + island.elements; });
    legend.push_back({p.structure, tr("not loose")});
    legend.push_back({QColor(), tr("in loose islands %1").arg(countText(loose))});
    for (std::size_t i = 0; i < shown; ++i) {
        // Counted from 1, as rubble-cli inspect does.
        legend.push_back({colourOf(render::colour_choice::category(colours, islands[i].category)),
                          tr("island %1 · %2").arg(countText(islands[i].island + 1), countText(islands[i].elements))});
    }
    if (shown < islands.size()) {
        legend.push_back({QColor(), tr("smaller islands: %1").arg(countText(islands.size() - shown))});
    }
}

/// The next number with two digits, for what need not be told more finely.
double twoDigitsUp(double value) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::ceil(value / step) * step;
}

/// One entry for each material that a component has.
void addMaterials(std::vector<LegendEntry>& legend, const render::SceneData& data, const render::SceneColours& colours) {
    std::array<bool, materialCount> present{};
    std::array<bool, materialCount> assumed{};
    std::array<bool, materialCount> fits{};
    for (std::size_t c = 0; data.components && c < data.components->list.size(); ++c) {
        const Component& component = data.components->list[c];
        present[static_cast<std::size_t>(component.material)] = true;
        const bool guessed = data.materialAssumed(component.name);
        assumed[static_cast<std::size_t>(component.material)] |= guessed;
        fits[static_cast<std::size_t>(component.material)] |= !guessed || someMaterialFits(component.density);
    }
    const std::array<QString, materialCount> names{tr("stone"),   tr("concrete"), tr("steel"),
                                                   tr("masonry"), tr("soil"),     tr("water bed")};
    for (std::size_t m = 0; m < materialCount; ++m) {
        if (present[m]) {
            legend.push_back({colourOf(colours.materials[m]), assumed[m] ? guessedMaterial(names[m], fits[m]) : names[m]});
        }
    }
}

/// One line for each step of the error, with its count.
void addErrors(Overlay& overlay, const render::View& view, const render::PaneStatus& status, const Palette& p) {
    if (view.errorSteps.empty() || status.errors.size() != view.errorSteps.size() + 1) {
        overlay.legend.push_back(
            {p.fragment, tr("fragments %1, no reference: errors are not known").arg(countText(status.fragments))});
        return;
    }
    overlay.legend.push_back({QColor(), tr("error against the reference:")});
    const std::size_t last = view.errorSteps.size();
    for (std::size_t i = 0; i <= last; ++i) {
        const QString bound = lengthText(view.errorSteps[std::min(i, last - 1)]);
        const QString range = i == last ? tr("over %1").arg(bound) : tr("≤ %1").arg(bound);
        overlay.legend.push_back({errorColour(static_cast<double>(i) / static_cast<double>(last)),
                                  range + QStringLiteral(" · ") + countText(status.errors[i])});
    }
    if (status.errorsUnknown > 0) {
        overlay.legend.push_back({p.muted, tr("not in the reference · %1").arg(countText(status.errorsUnknown))});
    }
}

/// What the points of a cloud are, and what their colours say.
void addPoints(std::vector<LegendEntry>& legend, const render::SitePoints& points, double timeOrigin) {
    using Scale = render::SitePoints::Scale;
    const QString name = QString::fromStdString(points.name);
    const bool distances = points.scale == Scale::Distance;
    const QString shown = countText(points.shown);
    const QString all = countText(points.all);
    legend.push_back(
        {QColor(),
         distances ? tr("from %1 to the site at t = %2: %3 of %4 places").arg(name, timeText(points.time - timeOrigin), shown, all)
                   : tr("%1: %2 of %3 points").arg(name, shown, all)});
    if (points.scale == Scale::Height || points.scale == Scale::Intensity) {
        for (const double share : {0.0, 0.5, 1.0}) {
            const double value = points.low + share * (points.high - points.low);
            legend.push_back({colourOf(scaleColour(points.scale, share)),
                              points.scale == Scale::Height ? tr("z = %1").arg(lengthText(std::round(100.0 * value) / 100.0 + 0.0))
                                                            : tr("intensity %1").arg(numberText(value))});
        }
    }
    for (std::size_t c = 0; points.scale == Scale::Class && c < std::min(points.classes.size(), longestLegend); ++c) {
        legend.push_back({colourOf(points.classes[c].second), tr("class %1").arg(points.classes[c].first)});
    }
    if (!distances) {
        return;
    }
    if (points.high > 0.0) {
        legend.push_back(
            {colourOf(distanceColour(1.0)), tr("simulated site above, up to %1").arg(lengthText(twoDigitsUp(points.high)))});
    }
    if (points.low < 0.0) {
        legend.push_back({colourOf(distanceColour(-1.0)), tr("below, up to %1").arg(lengthText(twoDigitsUp(-points.low)))});
    }
    if (std::isfinite(points.detection)) {
        const QString level = lengthText(points.detection > 0.0 ? twoDigitsUp(points.detection) : 0.0);
        legend.push_back({colourOf(withinDetection), tr("within the level of detection, %1 in the median").arg(level)});
        if (!points.registered) {
            legend.push_back({QColor(), tr("without the registration's error: not known")});
        }
    }
    if (points.unknown > 0) {
        legend.push_back({colourOf(detectionUnknown), tr("level of detection not known · %1").arg(countText(points.unknown))});
    }
}

void addFragments(Overlay& overlay, const render::View& view, const render::Scene& scene, const render::SceneData& data,
                  const render::PaneStatus& status, const render::SceneColours& colours) {
    const Palette& p = palette(view.theme);
    const QString count = countText(status.fragments);
    switch (view.colourBy) {
        case render::ColourBy::Highlight:
        case render::ColourBy::Island:
            overlay.legend.push_back(
                {view.style == render::Style::Presentation ? QColor() : p.fragment, tr("fragments %1").arg(count)});
            break;
        case render::ColourBy::Component:
            addComponents(overlay.legend, view, data, status, colours);
            if (overlay.legend.empty()) {
                overlay.legend.push_back({p.fragment, tr("fragments %1").arg(count)});
            }
            break;
        case render::ColourBy::Cluster:
            overlay.legend.push_back({QColor(), tr("fragments %1 in %2 clusters").arg(count, countText(status.clusters))});
            break;
        case render::ColourBy::BirthTime: {
            const auto [first, last] = scene.birthSpan();
            overlay.legend.push_back({QColor(), tr("fragments %1").arg(count)});
            overlay.bars.push_back({true, timeText(first), timeText(last), tr("birth time"), view.colourMap});
            break;
        }
        case render::ColourBy::Error:
            addErrors(overlay, view, status, p);
            break;
        case render::ColourBy::Speed:
            overlay.legend.push_back({QColor(), tr("fragments %1").arg(count)});
            overlay.bars.push_back({false, speedText(0.0), speedText(scene.speedTop()), tr("speed"), view.colourMap});
            break;
    }
}

}  // namespace

QString captionText(render::PaneContent content, const render::PaneStatus& status) {
    const bool fe = content == render::PaneContent::Fe;
    const QString name = fe && status.looseBodies                  ? tr("Bodies that are not let go yet")
                         : fe                                      ? tr("Conventional FE result")
                         : content == render::PaneContent::Overlay ? tr("Fragments and intact outline")
                         : content == render::PaneContent::Plan    ? tr("Fragments in plan")
                                                                   : tr("Fragments");
    if (status.states == 0) {
        return content == render::PaneContent::Other ? tr("No run of another scenario is chosen") : name;
    }
    QString how;
    if (fe) {
        how = status.interpolated ? tr("interpolated after state %1 of 0–%2")
              : status.afterFeEnd ? tr("last state, %1 of 0–%2")
                                  : tr("state %1 of 0–%2");
        // Counted from 0, as on the command line and in messages.
        how = how.arg(status.state).arg(status.states - 1);
    } else if (!status.simulated) {
        how = tr("not simulated, at their birth places");
    } else if (status.waitsForRun) {
        how = tr("simulated so far");
    } else {
        how = status.kind == FrameKind::Interpolated ? tr("simulated, interpolated") : tr("simulated");
    }
    return tr("%1 · t = %2, %3").arg(name, timeText(status.time), how);
}

namespace {

Overlay overlayOf(const render::View& view, const render::Scene& scene, const render::Pane& pane,
                  const render::PaneStatus& status) {
    Overlay overlay;
    const render::SceneData& data = scene.dataOf(pane.content);
    if (view.captions) {
        render::PaneStatus counted = status;
        counted.time -= view.timeOrigin;
        overlay.caption = captionText(pane.content, counted);
        if (pane.content == render::PaneContent::Other && !scene.otherScenario().empty()) {
            overlay.caption = tr("Scenario %1 · %2").arg(QString::fromStdString(scene.otherScenario()), overlay.caption);
        }
    }
    if (view.legends && status.states > 0) {
        const Palette& p = palette(view.theme);
        const bool byIsland = view.colourBy == render::ColourBy::Island;
        if (pane.content != render::PaneContent::Fe && data.fragments) {
            addFragments(overlay, view, scene, data, status, sceneColours(view.theme, view.colourMap));
            if (status.ahead > 0) {
                overlay.legend.push_back({QColor(), tr("born before the FE result deletes them: %1").arg(countText(status.ahead))});
            }
            const bool plain = view.style == render::Style::Presentation || byIsland;
            overlay.legend.push_back({plain ? QColor() : p.structure, tr("active structure %1").arg(countText(status.active))});
            if (pane.content == render::PaneContent::Overlay) {
                overlay.legend.push_back({p.outline, tr("intact structure"), true});
            }
            if (status.released > 0) {
                overlay.legend.push_back({plain ? QColor() : p.released, tr("loose structure %1").arg(countText(status.released))});
            }
            if (data.waterLevel) {
                overlay.legend.push_back({p.water, tr("water, surface at z = %1").arg(lengthText(*data.waterLevel))});
            }
            if (view.style == render::Style::Presentation) {
                addMaterials(overlay.legend, data, sceneColours(view.theme));
            }
        } else {
            const bool material = view.style == render::Style::Presentation;
            overlay.legend.push_back({material || byIsland ? QColor() : p.structure,
                                      tr("active %1 of %2 elements").arg(countText(status.active), countText(status.elements))});
            if (material) {
                addMaterials(overlay.legend, data, sceneColours(view.theme));
            }
        }
        if (byIsland) {
            addIslands(overlay.legend, p, status, sceneColours(view.theme));
        }
        if (data.points != nullptr && !view.cloud.empty()) {
            addPoints(overlay.legend, *data.points, view.timeOrigin);
        }
        if (view.clip) {
            overlay.legend.push_back({QColor(), tr("cut open")});
        }
        if (status.hidden > 0) {
            overlay.legend.push_back({QColor(), tr("hidden %1").arg(countText(status.hidden))});
        }
        if (status.meeting && pane.content != render::PaneContent::Fe) {
            overlay.legend.push_back(
                {QColor(), tr("filter: %1 of %2 shown").arg(countText(*status.meeting), countText(status.fragments))});
        }
        if (!view.selection.empty()) {
            overlay.legend.push_back({p.accent, tr("selected %1").arg(countText(view.selection.size())), true});
        }
    }
    // Apart from the legend, which stays where it is at rest.
    QStringList simplified;
    if (status.simplifiedTo > 0.0) {
        simplified.push_back(tr("to within %1").arg(lengthText(twoDigitsUp(status.simplifiedTo))));
    }
    if (status.resolution < 1.0) {
        simplified.push_back(tr("resolution %1 %").arg(std::lround(100.0 * status.resolution)));
    }
    if (status.statesApart > 1) {
        simplified.push_back(tr("over %1 FE intervals").arg(status.statesApart));
    }
    if (!simplified.isEmpty()) {
        overlay.moving = tr("simplified while moving: %1").arg(simplified.join(QStringLiteral(", ")));
    }
    if (view.scaleBar && status.states > 0) {
        overlay.metresPerPixel = render::metresPerPixel(render::cameraOf(view, pane.content), pane.height);
    }
    return overlay;
}

}  // namespace

Overlay makeOverlay(const render::View& view, const render::Scene& scene, const render::Pane& pane) {
    return overlayOf(view, scene, pane, scene.status(pane.content));
}

Overlay longestOverlay(const render::View& view, const render::Scene& scene, const render::Pane& pane) {
    const render::SceneData& data = scene.dataOf(pane.content);
    // Of what is drawn right now only what has no longest: cameras fitted before the first picture are those fitted after it.
    const render::PaneStatus drawn = scene.status(pane.content);
    render::PaneStatus status;
    status.islandsKnown = drawn.islandsKnown;
    status.islands = drawn.islands;
    status.errors = drawn.errors;
    status.errorsUnknown = drawn.errorsUnknown;
    if (data.fe != nullptr) {
        status.states = static_cast<std::uint32_t>(data.fe->times().size());
        status.elements = status.active = data.fe->mesh().elementCount();
    }
    if (data.fragments != nullptr) {
        status.fragments = status.clusters = data.fragments->list.size();
        status.bornByComponent.assign(data.components != nullptr ? data.components->list.size() : 0, 0);
        for (const Fragment& fragment : data.fragments->list) {
            if (at(fragment.component) < status.bornByComponent.size()) {
                ++status.bornByComponent[at(fragment.component)];
            }
        }
    }
    const bool carries = data.trajectory != nullptr && pane.content != render::PaneContent::Fe;
    status.released = carries ? status.active : 0;
    return overlayOf(view, scene, pane, status);
}

std::vector<LegendEntry> commonLegend(const render::View& view, const render::SceneData& data, bool released) {
    const Palette& p = palette(view.theme);
    std::vector<LegendEntry> legend;
    const bool byIsland = view.colourBy == render::ColourBy::Island;
    if (view.style == render::Style::Analysis) {
        if (view.colourBy == render::ColourBy::Highlight || byIsland) {
            legend.push_back({p.fragment, tr("fragments")});
        }
        legend.push_back({p.structure, byIsland ? tr("not loose") : tr("active structure")});
    }
    if (byIsland) {
        legend.push_back({QColor(), tr("each loose island in a colour of its own")});
    } else if (released && view.style == render::Style::Analysis) {
        legend.push_back({p.released, tr("loose structure")});
    }
    if (view.style == render::Style::Presentation) {
        addMaterials(legend, data, sceneColours(view.theme));
    }
    return legend;
}

}  // namespace rubble::figures
