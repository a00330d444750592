#include "widgets/run/caution_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "widgets/basics/wording.h"

namespace rubble::widgets {

QString cautionWords(const std::vector<Caution>& cautions) {
    QStringList parts;
    for (const Caution& caution : cautions) {
        if (caution.inPictures()) {
            parts << worded(caution.what);
        }
    }
    return inOneLine(parts);
}

void showCautions(Notice& line, const QString& cautions) {
    line.setObjectName(QStringLiteral("pictureCautions"));
    line.set(Notice::Kind::Finding,
             cautions.isEmpty() ? QString() : QCoreApplication::translate("Cautions", "Below the picture: %1").arg(cautions));
}

}  // namespace rubble::widgets
