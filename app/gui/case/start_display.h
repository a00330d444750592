#pragma once

#include <QObject>

#include "app/gui/case/project_files.h"

namespace rubble {

class Computation;
class Document;
class Session;
class ViewArea;

/// Fills the start page: what was opened before, with pictures of it, and the samples.
class StartDisplay : public QObject {
    Q_OBJECT

public:
    StartDisplay(Session& session, ViewArea& area, QObject* parent = nullptr);

    /// Shows what is known now.
    void refresh();
    /// What is opened from here on is listed at the next start.
    void remember();
    /// A case that nobody has chosen is about to open: it is not listed until somebody does.
    void passOver(const QString& path) { m_passedOver = path; }
    RecentCases& recent() { return m_files.recent; }
    /// A recent case lies elsewhere now; it is opened there.
    void locate(const QString& from, const QString& to);

signals:
    void openRequested(const QString& path);
    void sampleRequested(const QString& path);
    void tourRequested();

private:
    void follow();
    void noteOpened();
    void takePicture();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    ViewArea& m_area;
    ProjectFiles& m_files;
    QString m_passedOver;
};

}  // namespace rubble
