#pragma once

#include <QObject>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "io/exports/provenance.h"
#include "io/run/run_file.h"
#include "widgets/evidence/figure_dialog.h"
#include "widgets/evidence/movie_dialog.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"

namespace rubble {

class Computation;
class Document;
class Session;

namespace io {
class RunReader;
}

/// Figures, movies and pages of what the views show: asks what they are to be, draws them on the worker, says what came of it.
class PictureExport : public QObject {
    Q_OBJECT

public:
    PictureExport(Session& session, QWidget& window);

    void exportFigure(const render::View& view, const render::SceneData& data);
    void exportMovie(const render::View& view, const render::SceneData& data);
    /// A page of the run that is shown; nothing while it is not finished.
    void sharePage(const render::SceneData& data);
    /// The same without asking.
    void sharePageAt(const QString& path, const render::SceneData& data);
    void exportFigureTo(const QString& path, const widgets::FigureChoice& choice, const render::View& view,
                        const render::SceneData& data);
    void exportMovieTo(const QString& path, const widgets::MovieChoice& choice, const render::View& view,
                       const render::SceneData& data);

    /// What a figure or movie is made of, kept alive while that takes.
    struct Made {
        io::RunOrigin origin;
        std::shared_ptr<io::RunReader> run;
        std::string casePath;
        std::vector<io::ShownFile> around;
        QString cautions;  ///< what must be known beside it; empty: nothing
    };

private:
    /// What was chosen last.
    struct LastFigure {
        widgets::FigureChoice choice;
    };
    QString proposed(const QString& suffix) const;
    Made madeNow(const render::SceneData& data) const;
    void writeFigure(const QString& path, const widgets::FigureChoice& choice, const render::View& view,
                     const render::SceneData& data, const Made& made);
    void writeMovie(const QString& path, const widgets::MovieChoice& choice, const render::View& view,
                    const render::SceneData& data, const Made& made);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    QWidget& m_window;
};

}  // namespace rubble
