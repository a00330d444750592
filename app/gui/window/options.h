#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/gui/stage/actions.h"

namespace rubble {

/// What the command line of the workbench asks for.
struct Options {
    QString path;
    bool sample = false;
    bool simulate = false;
    bool accuracy = false;
    QString screenshot;
    bool measure = false;  ///< print how fast the window is as JSON and leave
    QString chart;         ///< file for the chart of what accuracy costs; implies accuracy
    std::optional<double> time;
    QString theme;
    QString language;                ///< en, zh_CN or system; empty: as in the preferences
    std::optional<int> panel;        ///< in the order of the rail; then the ensemble and the causes
    std::vector<ActionId> actions;   ///< triggered before a picture is taken
    QString view;                    ///< file of a view to look as
    std::optional<int> newCaseStep;  ///< a new case is made from the file; the step of the wizard that is shown
    std::optional<int> photo;        ///< how the simulation lies over the photograph, as PhotoView::Show
    QStringList causes;              ///< cases and FE results to compare causes with
    QStringList against;             ///< KIND=FILE of what was found
    QSize size;
    QString text;        ///< for --help and --version, or why the arguments are wrong
    bool wrong = false;  ///< text is a complaint

    /// Nothing is to be opened, made, measured or drawn: somebody has just started the program.
    bool asksForNothing() const;
};

Options parseOptions(const QStringList& arguments);

}  // namespace rubble
