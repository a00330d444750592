#include "app/gui/exports/folder_choice.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>

#include "widgets/basics/panel.h"

namespace rubble {

namespace {

QString told(const char* text) {
    return QCoreApplication::translate("FolderChoice", text);
}

/// Why a folder cannot be made; empty if it can.
QString whyNotMade(const QString& path) {
    if (QFileInfo::exists(path)) {
        return told(QT_TRANSLATE_NOOP("FolderChoice", "%1 is a file, and no folder can have its name.")).arg(path);
    }
    QFileInfo above(path);
    do {
        above.setFile(above.absolutePath());
    } while (!above.exists() && !above.isRoot());
    return above.isDir() && above.isWritable()
               ? QString()
               : told(QT_TRANSLATE_NOOP("FolderChoice", "%1 cannot be made: %2 is no folder that you may write to."))
                     .arg(path, above.filePath());
}

/// Qt's own dialog chooses folders that are there and nothing else.
class FolderDialog : public QFileDialog {
public:
    FolderDialog(QWidget& parent, const QString& title, const QString& beside)
        : QFileDialog(&parent, title, beside), m_notice(new widgets::Notice) {
        setOption(QFileDialog::DontUseNativeDialog);
        setOption(QFileDialog::ShowDirsOnly);
        setFileMode(QFileDialog::Directory);
        if (auto* grid = qobject_cast<QGridLayout*>(layout())) {
            grid->addWidget(m_notice, grid->rowCount(), 0, 1, grid->columnCount());
        }
        connect(findChild<QLineEdit*>(QStringLiteral("fileNameEdit")), &QLineEdit::textChanged, this,
                [this] { m_notice->set(widgets::Notice::Kind::Error, {}); });
        if (auto* choose = findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)) {
            choose->installEventFilter(this);
        }
    }

    /// The dialog locks its button whenever a name is no folder.
    bool eventFilter(QObject* watched, QEvent* event) override {
        auto* button = qobject_cast<QPushButton*>(watched);
        if (button != nullptr && event->type() == QEvent::EnabledChange && !button->isEnabled()) {
            button->setEnabled(true);
        }
        return QFileDialog::eventFilter(watched, event);
    }

    QString folder() const { return m_folder; }

    void accept() override {
        const QString path = selectedFiles().value(0);
        const QString why = QFileInfo(path).isDir() ? QString() : whyNotMade(path);
        if (!why.isEmpty()) {
            m_notice->set(widgets::Notice::Kind::Error, why,
                          told(QT_TRANSLATE_NOOP("FolderChoice", "Choose another place, or another name.")));
            return;
        }
        m_folder = QDir::cleanPath(path);
        done(QDialog::Accepted);
    }

private:
    widgets::Notice* m_notice;
    QString m_folder;
};

}  // namespace

QString chooseFolder(QWidget& parent, const QString& title, const QString& beside) {
    FolderDialog dialog(parent, title, beside);
    return dialog.exec() == QDialog::Accepted ? dialog.folder() : QString();
}

}  // namespace rubble
