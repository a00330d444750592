#include "widgets/figures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace rubble::figures {
namespace {

// Categories of Okabe and Ito (2008), "Color Universal Design"; vermilion first, black left out (it reads as shadow).
const std::vector<QColor> okabeIto{QColor("#d55e00"), QColor("#0072b2"), QColor("#e69f00"), QColor("#009e73"),
                                   QColor("#cc79a7"), QColor("#56b4e9"), QColor("#f0e442")};

Palette light() {
    Palette p;
    p.window = QColor("#ffffff");
    p.panel = QColor("#ffffff");
    p.field = QColor("#fbfbfb");
    p.hairline = QColor("#d9dbde");
    p.text = QColor("#1f2328");
    p.muted = QColor("#6b7280");
    p.accent = QColor("#1f6fb5");
    p.accentText = QColor("#ffffff");
    p.accentTint = QColor("#e1eef9");
    p.fragment = QColor("#d55e00");
    p.fragmentTint = QColor("#f3d6c0");
    p.structure = QColor("#a3988a");
    p.released = QColor("#6a3d7c");
    p.finding = QColor("#b57a00");
    p.findingTint = QColor("#fff3d6");
    p.error = QColor("#b3261e");
    p.good = QColor("#1d8a57");
    p.chip = QColor(255, 255, 255, 226);
    p.chipText = p.text;
    p.skyTop = QColor("#cfd6db");
    p.skyHorizon = QColor("#eceeed");
    p.ground = QColor("#cdcdc6");
    p.groundGrid = QColor("#bdbdb5");
    p.earth = QColor("#aaa590");
    p.water = QColor("#5f8fae");
    p.outline = QColor("#4d5a66");
    p.materials = {QColor("#b8aa90"), QColor("#a7a8a4"), QColor("#76828f"),
                   QColor("#a96b52"), QColor("#8b7556"), QColor("#66848b")};
    p.structureGreys = {QColor("#a89d8e"), QColor("#9a9ba1"), QColor("#b7a98f"), QColor("#8f877c"), QColor("#a5a89f")};
    p.categories = okabeIto;
    return p;
}

Palette dark() {
    Palette p = light();
    p.window = QColor("#2a2d31");
    p.panel = QColor("#2a2d31");
    p.field = QColor("#212428");
    p.hairline = QColor("#42464c");
    p.text = QColor("#e8eaed");
    p.muted = QColor("#9aa1a9");
    p.accent = QColor("#58a8ec");
    p.accentText = QColor("#0f1720");
    p.accentTint = QColor("#223a50");
    p.fragment = QColor("#f0843a");
    p.fragmentTint = QColor("#5c4333");
    p.structure = QColor("#b0a594");
    p.released = QColor("#9a5fc0");
    p.finding = QColor("#e3a43c");
    p.findingTint = QColor("#3f3522");
    p.error = QColor("#f07a70");
    p.good = QColor("#4cc38a");
    p.chip = QColor(28, 30, 33, 214);
    p.chipText = p.text;
    p.skyTop = QColor("#22262b");
    p.skyHorizon = QColor("#42474d");
    p.ground = QColor("#383b3d");
    p.groundGrid = QColor("#484b4d");
    p.earth = QColor("#45443c");
    p.water = QColor("#3f7396");
    p.outline = QColor("#aeb6bd");
    p.structureGreys = {QColor("#b3a897"), QColor("#a4a6ad"), QColor("#c1b398"), QColor("#9a9286"), QColor("#b0b3a9")};
    p.categories = okabeIto;
    p.categories[0] = p.fragment;
    p.categories[1] = QColor("#3d9be0");
    return p;
}

Palette print() {
    Palette p = light();
    p.window = p.panel = p.field = QColor("#ffffff");
    p.text = p.chipText = QColor("#111111");
    p.muted = QColor("#555555");
    p.chip = QColor(255, 255, 255, 235);
    p.skyTop = p.skyHorizon = p.ground = QColor("#ffffff");
    p.groundGrid = QColor("#d2d2ce");
    p.earth = QColor("#c2bdab");
    return p;
}

/// The same palette with yellow fragments on a dark grey structure.
Palette yellow(Palette p) {
    const bool dark = p.window.lightness() < 110;
    p.fragment = QColor("#e6b800");
    p.fragmentTint = dark ? QColor("#4d4526") : QColor("#f5ebc2");
    p.structure = QColor("#5c5f66");
    p.structureGreys = {QColor("#5c5f66"), QColor("#4c5058"), QColor("#696660"), QColor("#55534f"), QColor("#63666b")};
    p.categories[0] = p.fragment;
    p.categories[2] = QColor("#d55e00");
    return p;
}

ColourSet& chosenColourSet() {
    static ColourSet set = ColourSet::Vermilion;
    return set;
}

struct Stop {
    double place;
    QColor colour;
};

template <std::size_t N>
QColor onStops(const std::array<Stop, N>& stops, double place) {
    place = std::isfinite(place) ? std::clamp(place, 0.0, 1.0) : 0.0;
    std::size_t i = 1;
    while (i + 1 < N && stops[i].place < place) {
        ++i;
    }
    const Stop& a = stops[i - 1];
    const Stop& b = stops[i];
    const double share = std::clamp((place - a.place) / (b.place - a.place), 0.0, 1.0);
    const auto mix = [share](int x, int y) { return static_cast<int>(std::lround((1 - share) * x + share * y)); };
    return {mix(a.colour.red(), b.colour.red()), mix(a.colour.green(), b.colour.green()), mix(a.colour.blue(), b.colour.blue())};
}

render::Rgb rgb(const QColor& c) {
    return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()), static_cast<std::uint8_t>(c.blue())};
}

std::vector<render::Rgb> rgbs(const std::vector<QColor>& colours) {
    std::vector<render::Rgb> list;
    for (const QColor& c : colours) {
        list.push_back(rgb(c));
    }
    return list;
}

}  // namespace

const Palette& palette(render::Theme theme) {
    static const std::array<std::array<Palette, 3>, 2> palettes{
        {{light(), dark(), print()}, {yellow(light()), yellow(dark()), yellow(print())}}};
    return palettes[static_cast<std::size_t>(chosenColourSet())][static_cast<std::size_t>(theme)];
}

void chooseColours(ColourSet set) {
    chosenColourSet() = set;
}

namespace {

/// Scales that the colour-blind can read, after the values published with them; nothing for the standard one.
std::optional<QColor> sharedColour(double place, render::ColourMap map) {
    static const std::array<Stop, 10> viridis{{{0.0, QColor("#440154")},
                                               {1.0 / 9, QColor("#482878")},
                                               {2.0 / 9, QColor("#3e4989")},
                                               {3.0 / 9, QColor("#31688e")},
                                               {4.0 / 9, QColor("#26828e")},
                                               {5.0 / 9, QColor("#1f9e89")},
                                               {6.0 / 9, QColor("#35b779")},
                                               {7.0 / 9, QColor("#6ece58")},
                                               {8.0 / 9, QColor("#b5de2b")},
                                               {1.0, QColor("#fde725")}}};
    static const std::array<Stop, 10> cividis{{{0.0, QColor("#00224e")},
                                               {1.0 / 9, QColor("#123570")},
                                               {2.0 / 9, QColor("#3b496c")},
                                               {3.0 / 9, QColor("#575d6d")},
                                               {4.0 / 9, QColor("#707173")},
                                               {5.0 / 9, QColor("#8a8678")},
                                               {6.0 / 9, QColor("#a59c74")},
                                               {7.0 / 9, QColor("#c3b369")},
                                               {8.0 / 9, QColor("#e1cc55")},
                                               {1.0, QColor("#fee838")}}};
    static const std::array<Stop, 2> grey{{{0.0, QColor("#1c1c1c")}, {1.0, QColor("#f4f4f4")}}};
    switch (map) {
        case render::ColourMap::Viridis:
            return onStops(viridis, place);
        case render::ColourMap::Cividis:
            return onStops(cividis, place);
        case render::ColourMap::Grey:
            return onStops(grey, place);
        case render::ColourMap::Standard:
            break;
    }
    return std::nullopt;
}

}  // namespace

QColor birthColour(double place, render::ColourMap map) {
    if (const auto shared = sharedColour(place, map)) {
        return *shared;
    }
    static const std::array<Stop, 5> stops{{{0.0, QColor("#3a1247")},
                                            {0.25, QColor("#8c2450")},
                                            {0.55, QColor("#d55e00")},
                                            {0.8, QColor("#f2a93b")},
                                            {1.0, QColor("#faeeb4")}}};
    return onStops(stops, place);
}

QColor speedColour(double place, render::ColourMap map) {
    if (const auto shared = sharedColour(place, map)) {
        return *shared;
    }
    static const std::array<Stop, 5> stops{{{0.0, QColor("#14304f")},
                                            {0.25, QColor("#0b6a9c")},
                                            {0.55, QColor("#33a7b5")},
                                            {0.8, QColor("#a5d98c")},
                                            {1.0, QColor("#fdf7b8")}}};
    return onStops(stops, place);
}

QColor errorColour(double place) {
    static const std::array<Stop, 5> stops{{{0.0, QColor("#f4f1cf")},
                                            {0.25, QColor("#a3d0a4")},
                                            {0.5, QColor("#4aa3a8")},
                                            {0.75, QColor("#3b629f")},
                                            {1.0, QColor("#35205f")}}};
    return onStops(stops, place);
}

render::SceneColours sceneColours(render::Theme theme, render::ColourMap map) {
    const Palette& p = palette(theme);
    render::SceneColours c;
    c.skyTop = rgb(p.skyTop);
    c.skyHorizon = rgb(p.skyHorizon);
    c.ground = rgb(p.ground);
    c.grid = rgb(p.groundGrid);
    c.earth = rgb(p.earth);
    c.water = rgb(p.water);
    c.divider = rgb(p.hairline);
    c.fragment = rgb(p.fragment);
    c.selection = rgb(p.accent);
    c.released = rgb(p.released);
    c.unknown = rgb(p.muted);
    c.outline = rgb(p.outline);
    for (std::size_t i = 0; i < c.materials.size(); ++i) {
        c.materials[i] = rgb(p.materials[i]);
    }
    c.structure = rgbs(p.structureGreys);
    c.categories = rgbs(p.categories);
    for (std::size_t i = 0; i < c.birthRamp.size(); ++i) {
        c.birthRamp[i] = rgb(birthColour(static_cast<double>(i) / 255.0, map));
        c.speedRamp[i] = rgb(speedColour(static_cast<double>(i) / 255.0, map));
        c.errorRamp[i] = rgb(errorColour(static_cast<double>(i) / 255.0));
    }
    // Paper stays white in the analysis style; nothing glares on a dark screen.
    c.groundTexture = theme == render::Theme::Print ? 0.0 : theme == render::Theme::Dark ? 0.14 : 0.07;
    c.brightest = theme == render::Theme::Dark ? 0.6 : 0.85;
    c.ambient = theme == render::Theme::Dark ? 0.42 : 0.48;
    return c;
}

}  // namespace rubble::figures
