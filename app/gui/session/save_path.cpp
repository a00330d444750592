#include "app/gui/session/save_path.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

#include "app/gui/session/sample.h"

namespace rubble {

namespace {

/// ".tif", ".csv" of kinds of files.
QStringList endingsOf(const QString& kinds) {
    static const QRegularExpression ending(QStringLiteral("\\*(\\.[\\w.]+)"));
    QStringList list;
    for (QRegularExpressionMatchIterator each = ending.globalMatch(kinds); each.hasNext();) {
        list << each.next().captured(1);
    }
    return list;
}

}  // namespace

QString askSavePath(QWidget* parent, const QString& title, const QString& proposed, const QString& kinds) {
    QString chosen;
    QString path = QFileDialog::getSaveFileName(parent, title, outsideSamples(proposed), kinds, &chosen);
    const QStringList endings = endingsOf(kinds);
    const bool named = std::any_of(endings.begin(), endings.end(),
                                   [&](const QString& ending) { return path.endsWith(ending, Qt::CaseInsensitive); });
    if (path.isEmpty() || named || endings.isEmpty()) {
        return path;
    }
    const QStringList ofChosen = endingsOf(chosen);
    path += ofChosen.isEmpty() ? endings.front() : ofChosen.front();
    if (QFileInfo::exists(path) &&
        QMessageBox::question(
            parent, title,
            QCoreApplication::translate("SavePath", "%1 is there already. Replace it?").arg(QFileInfo(path).fileName())) !=
            QMessageBox::Yes) {
        return {};
    }
    return path;
}

}  // namespace rubble
