#pragma once

#include <QObject>

namespace rubble {

/// Gives the columns of every file dialog the room that sizes and dates need; the names take the rest.
class FileDialogColumns : public QObject {
    Q_OBJECT

public:
    explicit FileDialogColumns(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace rubble
