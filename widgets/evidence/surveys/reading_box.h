#pragma once

#include <QDialog>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <utility>

#include "core/scenario/cloud_request.h"

class QLabel;
class QLineEdit;

namespace rubble::widgets {

class Notice;

/// How a cloud or a table of points is read, where its file does not say it: its coordinate system and its columns.
class ReadingBox : public QWidget {
    Q_OBJECT

public:
    explicit ReadingBox(QWidget* parent = nullptr);

    void setRequest(const CloudRequest& request);
    /// What the fields say.
    CloudRequest request() const;
    /// Why it cannot be read so; empty: it can.
    void setComplaint(const QString& complaint);

signals:
    /// Another reading was typed.
    void edited(const rubble::CloudRequest& request);

private:
    void take();

    CloudRequest m_request;
    QLineEdit* m_system;
    QLineEdit* m_columns;
    Notice* m_complaint;
};

/// Asks how a file is to be read that does not say it all itself.
class ReadingDialog : public QDialog {
    Q_OBJECT

public:
    /// @param open  what the file leaves open, for people
    ReadingDialog(const QString& name, const QStringList& open, const CloudRequest& request, QWidget* parent = nullptr);

    /// Tries what was typed; it complains where the file cannot be read so. Nothing typed is always taken.
    void setTrial(std::function<QString(const CloudRequest&)> trial) { m_trial = std::move(trial); }
    ReadingBox& box() { return *m_box; }
    void accept() override;

private:
    ReadingBox* m_box;
    std::function<QString(const CloudRequest&)> m_trial;
};

}  // namespace rubble::widgets
