#pragma once

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace rubble::widgets {

/// The path of a file, typed or chosen.
class FileField : public QWidget {
    Q_OBJECT

public:
    /// @param name  object name of the line @param label  what the file is, for its dialog and for screen readers
    FileField(const char* name, const QString& label, QWidget* parent = nullptr);

    QString path() const;
    void setPath(const QString& path);

signals:
    void changed();

private:
    QLineEdit* m_line;
};

}  // namespace rubble::widgets
