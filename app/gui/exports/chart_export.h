#pragma once

#include <QString>
#include <memory>
#include <string>

#include "core/analysis/accuracy/accuracy_study.h"
#include "core/analysis/accuracy/calibration.h"
#include "widgets/basics/file_chart.h"

class QWidget;

namespace rubble {

class Session;
struct MadeComparison;

/// What a saved chart says of itself, and what stands in the file beside it.
struct ChartSource {
    widgets::ChartNote note;
    std::string provenance;  ///< JSON as of other exports; empty: nothing is written beside it
};

/// Writes charts as SVG or PNG, by the end of the path, with what must be known of them and where they came from.
class ChartExport {
public:
    ChartExport(Session& session, QWidget& window) : m_session(session), m_window(window) {}

    /// Of the run that is shown, or of the FE result alone.
    ChartSource history() const;
    /// Of settings that were compared. @param machine  in words
    ChartSource sweep(const AccuracyReport& report, const std::string& machine) const;
    static ChartSource calibration(const Calibration& calibration);
    static ChartSource causes(const MadeComparison& made);

    /// Asks where to. @param suffix  that the proposed name ends with: "-accuracy.svg"
    void save(const widgets::FileChart& chart, const QString& suffix, const ChartSource& source);
    /// Tells what came of it.
    void saveTo(const QString& path, const widgets::FileChart& chart, const ChartSource& source);
    /// Throws WorldError.
    static void write(const QString& path, const widgets::FileChart& chart, const ChartSource& source);

private:
    Session& m_session;
    QWidget& m_window;
};

}  // namespace rubble
