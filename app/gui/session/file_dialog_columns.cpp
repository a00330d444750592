#include "app/gui/session/file_dialog_columns.h"

#include <QApplication>
#include <QCoreApplication>
#include <QEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QTreeView>
#include <algorithm>
#include <array>

namespace rubble {

namespace {

/// Kinds of files as Qt names them: its own catalogues lack them.
struct KindOfFile {
    const char* text;
    const char* comment;
};
[[maybe_unused]] constexpr std::array kindsOfFiles{
    KindOfFile QT_TRANSLATE_NOOP3("QAbstractFileIconProvider", "Folder", "All other platforms"),
    KindOfFile QT_TRANSLATE_NOOP3("QAbstractFileIconProvider", "Shortcut", "All other platforms")};

/// Wide enough for a name beside size, kind and date.
constexpr int leastWidth = 760;

void fitColumns(QFileDialog& dialog) {
    auto* tree = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
    // A dialog of the desktop has none.
    if (tree == nullptr) {
        return;
    }
    QHeaderView& header = *tree->header();
    header.setStretchLastSection(false);
    header.setSectionResizeMode(QHeaderView::ResizeToContents);
    header.setSectionResizeMode(0, QHeaderView::Stretch);
    dialog.resize(std::max(dialog.width(), leastWidth), dialog.height());
}

}  // namespace

FileDialogColumns::FileDialogColumns(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool FileDialogColumns::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Show) {
        if (auto* dialog = qobject_cast<QFileDialog*>(watched)) {
            fitColumns(*dialog);
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace rubble
