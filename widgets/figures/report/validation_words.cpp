#include "widgets/figures/report/validation_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <string_view>

namespace rubble::figures {

namespace {

/// As core/validation/scene_sets.cpp and resources/validation have them; ids of sets are keys of the command line. In a context of
/// their own: elsewhere "arch" is the name of a component.
constexpr std::array<std::string_view, 44> shippedWords{
    QT_TRANSLATE_NOOP("validation", "Tosses of an acrylic cube on a wooden board"),
    QT_TRANSLATE_NOOP("validation", "Rockfall runs at Tschamut"),
    QT_TRANSLATE_NOOP("validation", "Dice poured into a vessel"),
    QT_TRANSLATE_NOOP("validation", "Round columns of cubes, rods and plates collapse"),
    QT_TRANSLATE_NOOP("validation", "Blocks and walls on a tilting table, and an arch"),
    QT_TRANSLATE_NOOP("validation", "limit analysis of rigid blocks, closed form: a verification, no measurement"),
    QT_TRANSLATE_NOOP("validation", "blind"),
    QT_TRANSLATE_NOOP("validation", "published"),
    QT_TRANSLATE_NOOP("validation", "fitted"),
    QT_TRANSLATE_NOOP("validation", "blind, one value each"),
    QT_TRANSLATE_NOOP("validation", "blind, obstacles of 0.03 m"),
    QT_TRANSLATE_NOOP("validation", "blind, obstacles of 0.05 m"),
    QT_TRANSLATE_NOOP("validation", "blind, obstacles of 0.1 m"),
    QT_TRANSLATE_NOOP("validation", "cubes, friction 0.3"),
    QT_TRANSLATE_NOOP("validation", "cubes, friction 0.5"),
    QT_TRANSLATE_NOOP("validation", "cubes, friction 0.8"),
    QT_TRANSLATE_NOOP("validation", "tetrahedra"),
    QT_TRANSLATE_NOOP("validation", "octahedra"),
    QT_TRANSLATE_NOOP("validation", "dodecahedra"),
    QT_TRANSLATE_NOOP("validation", "icosahedra"),
    QT_TRANSLATE_NOOP("validation", "columns of cubes"),
    QT_TRANSLATE_NOOP("validation", "columns of rods"),
    QT_TRANSLATE_NOOP("validation", "columns of plates"),
    QT_TRANSLATE_NOOP("validation", "cube slides"),
    QT_TRANSLATE_NOOP("validation", "cube topples"),
    QT_TRANSLATE_NOOP("validation", "pillar topples"),
    QT_TRANSLATE_NOOP("validation", "wall across"),
    QT_TRANSLATE_NOOP("validation", "wall across, 120 steps"),
    QT_TRANSLATE_NOOP("validation", "arch"),
    QT_TRANSLATE_NOOP("validation", "arch, 240 steps"),
    QT_TRANSLATE_NOOP("validation", "assumed"),
    QT_TRANSLATE_NOOP("validation", "assumed: the source measured none; varied for cubes"),
    QT_TRANSLATE_NOOP("validation", "assumed: the sources find that it matters little"),
    QT_TRANSLATE_NOOP("validation", "assumed: less than a block"),
    QT_TRANSLATE_NOOP("validation", "given"),
    QT_TRANSLATE_NOOP("validation", "given: nothing slides"),
    QT_TRANSLATE_NOOP("validation", "stands in for wood: the table of materials has none"),
    QT_TRANSLATE_NOOP("validation", "a meadow: the table's stone on soil"),
    QT_TRANSLATE_NOOP("validation", "0.30 to 0.60, range of the table's stone on soil, as ensembles draw it"),
    QT_TRANSLATE_NOOP("validation", "0.05 to 0.3, range of the table's stone on soil, as ensembles draw it"),
    QT_TRANSLATE_NOOP("validation", "fitted on one half, judged on the other"),
    QT_TRANSLATE_NOOP("validation", "fitted on the other half, judged on the one"),
    QT_TRANSLATE_NOOP("validation",
                      "assumed: nobody measured it here; the low end of the mean obstacle heights that rockfall models ask for "
                      "(Rockyfor3D, Dorren 2016)"),
    QT_TRANSLATE_NOOP("validation",
                      "assumed: nobody measured it here; of the mean obstacle heights that rockfall models ask for (Rockyfor3D, "
                      "Dorren 2016)"),
};

}  // namespace

QString validationWords(const std::string& english) {
    const bool shipped = std::ranges::find(shippedWords, english) != shippedWords.end();
    return shipped ? QCoreApplication::translate("validation", english.c_str()) : QString::fromStdString(english);
}

}  // namespace rubble::figures
