#pragma once

#include <QObject>
#include <QStringList>
#include <optional>

#include "io/exports/provenance.h"
#include "widgets/render/basics/view.h"

namespace rubble {

class Computation;
class Document;
class Session;

/// The way back from an exported figure or movie: finds its case, opens it, shows its run and looks as the figure does.
class FigureReturn : public QObject {
    Q_OBJECT

public:
    explicit FigureReturn(Session& session);

    /// Whether a file carries what it was made from.
    static bool carriesSource(const QString& path);
    /// Looks for its case; goes on through openRequested() and viewRequested(), or failed().
    void begin(const QString& path);
    /// Another file was opened by the user, or what is open was not to be left: what was begun is forgotten.
    void forget() { m_going.reset(); }

signals:
    void openRequested(const QString& path);
    /// The case is open, and shows what it did.
    /// @param aspect  width over height of the picture in the figure; 0: not known
    void viewRequested(const rubble::render::View& view, double aspect);

private:
    struct Going {
        QString figure;
        io::ReadProvenance provenance;
        io::ExportSource source;
        bool opened = false;
        bool runAsked = false;
    };
    void found();
    void prepared();
    void show();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    std::optional<Going> m_going;
};

}  // namespace rubble
