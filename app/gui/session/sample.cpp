#include "app/gui/session/sample.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "core/base/error.h"
#include "io/case/case_file.h"

namespace rubble {

namespace {

/// Beside the program, wherever that was installed; the build folder has a link there.
QString sampleFolder() {
    return QCoreApplication::applicationDirPath() + QStringLiteral("/../share/rubble/samples");
}

/// The case with its own title and note; a bare result by its name.
Sample sampleOf(const QFileInfo& file) {
    Sample sample;
    sample.path = file.canonicalFilePath();
    const QString picture = file.path() + u'/' + file.completeBaseName() + QStringLiteral(".png");
    sample.picture = QFileInfo::exists(picture) ? picture : QString();
    if (file.suffix() == QLatin1String("rubble")) {
        const Case theCase = io::loadCase(sample.path.toStdString());
        sample.name = QString::fromStdString(theCase.title);
        sample.words = theCase.scenarios.empty() ? QString() : QString::fromStdString(theCase.scenarios.front().note);
    } else {
        sample.name = file.fileName();
        sample.words = QCoreApplication::translate("samples", "An FE result as it comes from the analysis, without a case.");
    }
    return sample;
}

}  // namespace

QString samplePath() {
    for (const char* name : {"/stone-arch.rubble", "/stone-arch.exo"}) {
        if (const QFileInfo file(sampleFolder() + QLatin1String(name)); file.exists()) {
            return file.canonicalFilePath();
        }
    }
    return {};
}

bool isSample(const QString& path) {
    const QString folder = QFileInfo(sampleFolder()).canonicalFilePath();
    return !folder.isEmpty() && QFileInfo(path).canonicalFilePath().startsWith(folder + u'/');
}

QString outsideSamples(const QString& proposed) {
    const QFileInfo file(proposed);
    if (QFileInfo(file.absolutePath()).canonicalFilePath() != QFileInfo(sampleFolder()).canonicalFilePath()) {
        return proposed;
    }
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return (QFileInfo(documents).isDir() ? documents : QDir::homePath()) + u'/' + file.fileName();
}

std::vector<Sample> samples() {
    std::vector<Sample> found;
    const QString first = samplePath();
    if (first.isEmpty()) {
        return found;
    }
    const QDir folder = QFileInfo(first).dir();
    for (const QFileInfo& file :
         folder.entryInfoList({QStringLiteral("*.rubble"), QStringLiteral("*.exo")}, QDir::Files, QDir::Name)) {
        // A result with a case of its name is opened through that.
        if (file.suffix() == QLatin1String("exo") && folder.exists(file.completeBaseName() + QStringLiteral(".rubble"))) {
            continue;
        }
        try {
            found.push_back(sampleOf(file));
        } catch (const Error&) {
            continue;
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [&](const Sample& a, const Sample& b) { return (a.path == first) > (b.path == first); });
    return found;
}

}  // namespace rubble
