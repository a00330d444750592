#include "app/gui/session/file_kinds.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>
#include <span>
#include <string_view>

#include "core/evidence/evidence_list.h"

namespace rubble {

namespace {

/// Texts of this file.
struct FileKinds {
    Q_DECLARE_TR_FUNCTIONS(rubble::FileKinds)
};

/// "*.las *.LAS"
QString patternsOf(std::span<const std::string_view> endings) {
    QStringList patterns;
    for (const std::string_view ending : endings) {
        const QString small = QString::fromLatin1(ending.data(), static_cast<qsizetype>(ending.size()));
        patterns << u'*' + small << u'*' + small.toUpper();
    }
    return patterns.join(QLatin1Char(' '));
}

QString patternsOf(EvidenceForm form) {
    return patternsOf(endingsOf(form));
}

QString kind(const QString& name, const QString& patterns) {
    return name + QStringLiteral(" (") + patterns + u')';
}

QString withAllFiles(QStringList kinds) {
    kinds << FileKinds::tr("All files (*)");
    return kinds.join(QStringLiteral(";;"));
}

QString clouds() {
    return kind(FileKinds::tr("Point clouds and tables"), patternsOf(EvidenceForm::Cloud));
}

QString rasters() {
    return kind(FileKinds::tr("Rasters of heights"), patternsOf(EvidenceForm::Heights));
}

}  // namespace

QString surveyFileKinds() {
    const QString all =
        patternsOf(EvidenceForm::Heights) + u' ' + patternsOf(EvidenceForm::Cloud) + u' ' + patternsOf(EvidenceForm::Outline);
    return withAllFiles({kind(FileKinds::tr("Surveys"), all), rasters(), clouds(),
                         kind(FileKinds::tr("Outlines"), patternsOf(EvidenceForm::Outline))});
}

QString terrainFileKinds() {
    constexpr std::array<std::string_view, 3> meshes{".stl", ".obj", ".ply"};
    const QString all = patternsOf(EvidenceForm::Heights) + u' ' + patternsOf(EvidenceForm::Cloud) + u' ' + patternsOf(meshes);
    return withAllFiles(
        {kind(FileKinds::tr("Terrains"), all), rasters(), clouds(), kind(FileKinds::tr("Meshes"), patternsOf(meshes))});
}

QString polygonFileKinds() {
    return withAllFiles({kind(FileKinds::tr("Polygons"), patternsOf(EvidenceForm::Outline))});
}

QString cloudFileKinds() {
    return withAllFiles({clouds()});
}

QString writtenCloudKinds() {
    return FileKinds::tr("Point clouds (*.las *.ply);;Tables (*.csv)");
}

}  // namespace rubble
