#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

namespace rubble {

/// What the command line of the workbench asks for.
struct Options {
    QString path;
    bool sample = false;
    bool simulate = false;
    bool accuracy = false;
    QString screenshot;
    std::optional<double> time;
    QString theme;
    QString language;          ///< en, zh_CN or system; empty: as in the preferences
    std::optional<int> panel;  ///< in the order of the rail
    QStringList actions;       ///< ids of the table of actions, triggered before a picture is taken
    QString view;              ///< file of a view to look as
    std::optional<int> photo;  ///< how the simulation lies over the photograph, as PhotoView::Show
    QSize size;
    QString text;        ///< for --help and --version, or why the arguments are wrong
    bool wrong = false;  ///< text is a complaint
};

Options parseOptions(const QStringList& arguments);

}  // namespace rubble
