#pragma once

#include <QObject>

#include "app/gui/recent_cases.h"

namespace rubble {

class Computation;
class Document;
class ViewArea;

/// Fills the start page: what was opened before, with pictures of it, and the samples.
class StartDisplay : public QObject {
    Q_OBJECT

public:
    /// @param folder  for pictures, in the state folder; empty: none are kept
    StartDisplay(Document& document, Computation& computation, ViewArea& area, const QString& folder, QObject* parent = nullptr);

    /// Shows what is known now.
    void refresh();
    /// What is opened from here on is listed at the next start.
    void remember();
    RecentCases& recent() { return m_recent; }
    /// A recent case lies elsewhere now; it is opened there.
    void locate(const QString& from, const QString& to);

signals:
    void openRequested(const QString& path);
    void sampleRequested(const QString& path);
    void tourRequested();

private:
    void noteOpened();
    void takePicture();
    /// The case, or the FE result that is open without one; empty if nothing is.
    QString openPath() const;

    Document& m_document;
    Computation& m_computation;
    ViewArea& m_area;
    RecentCases m_recent;
    bool m_remembers = false;
};

}  // namespace rubble
