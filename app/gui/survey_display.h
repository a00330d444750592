#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/gui/evidence_work.h"
#include "app/gui/worker.h"
#include "core/evidence/survey_comparison.h"
#include "core/scenario/case.h"
#include "io/geo/survey_file.h"

namespace rubble {

class Computation;
class Document;
class PanelDeck;
namespace widgets {
class EvidencePage;
}

/// Brings the surveys of the case together with their box in the Evidence panel, the difference map in the centre and the run.
/// Comparing runs in the background; adding and removing a survey are undoable commands.
class SurveyDisplay : public QObject {
    Q_OBJECT

public:
    SurveyDisplay(Document& document, Computation& computation, PanelDeck& deck, widgets::EvidencePage& page,
                  QObject* parent = nullptr);
    ~SurveyDisplay() override;

    void chooseFile();
    void add(const QString& path);
    void compare();
    void cancel();
    bool busy() const { return m_comparing; }
    const std::shared_ptr<const SurveyComparison>& comparison() const { return m_comparison; }
    /// Writes the difference map as GeoTIFF or PNG, by the ending.
    void saveTo(const QString& path);
    void refresh();

signals:
    void told(const QString& what);
    void failed(const QString& what, const QString& remedy);

private:
    std::vector<const CaseInput*> surveys() const;
    const CaseInput* current() const;
    QString whyNot() const;
    bool stale() const;
    void remove();
    void setShowsFallen(std::optional<bool> shows);
    void save();
    void take(const std::exception_ptr& thrown);

    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    widgets::EvidencePage& m_page;
    int m_chosen = 0;
    bool m_comparing = false;
    QString m_complaint;
    std::shared_ptr<const SurveyComparison> m_comparison;
    std::shared_ptr<const io::SurveyInput> m_input;
    std::shared_ptr<SurveyComparison> m_made;
    std::shared_ptr<io::SurveyInput> m_read;
    CaseInput m_comparedWith;
    SurveySettings m_comparedSettings;
    const void* m_comparedRun = nullptr;
    // Last, so that it has ended before anything it uses goes.
    Worker m_work;
};

}  // namespace rubble
