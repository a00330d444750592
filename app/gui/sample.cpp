#include "app/gui/sample.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace rubble {

QString samplePath() {
    const QString beside = QCoreApplication::applicationDirPath() + QStringLiteral("/../share/rubble/samples");
    for (const QString& folder : {beside, QStringLiteral(RUBBLE_RESOURCE_DIR "/samples")}) {
        for (const char* name : {"/stone-arch.rubble", "/stone-arch.exo"}) {
            if (const QFileInfo file(folder + QLatin1String(name)); file.exists()) {
                return file.canonicalFilePath();
            }
        }
    }
    return {};
}

}  // namespace rubble
