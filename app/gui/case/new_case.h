#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/computation.h"
#include "app/gui/session/document.h"
#include "app/gui/session/worker.h"
#include "widgets/case/new_case_deaths.h"
#include "widgets/case/new_case_units.h"
#include "widgets/render/basics/view.h"

class QWidget;

namespace rubble {

class ComponentDisplay;
namespace widgets {
class CasePreview;
class NewCaseWizard;
}  // namespace widgets

/// A case that is being made from an FE result by the wizard. It has a document, an undo stack and a worker of its own: what is
/// open in the window stays as it is until the case is made, and leaving the wizard leaves nothing behind.
class NewCase : public QObject {
    Q_OBJECT

public:
    /// Reads the result on a worker and shows the wizard. @param keepCopies as Computation::keepCopies()
    NewCase(const QString& path, std::size_t memoryBytes, bool keepCopies, QWidget& window);
    ~NewCase() override;

    widgets::NewCaseWizard& wizard() { return *m_wizard; }
    widgets::CasePreview& preview() { return *m_preview; }
    Document& document() { return m_document; }
    Computation& computation() { return m_computation; }
    /// Nothing runs, and what is shown is up to date.
    bool settled() const;

signals:
    /// The case is made; `looks` has what was hidden and coloured.
    void created(const rubble::Opened& opened, const rubble::render::View& looks);
    /// The wizard was left, with or without a case.
    void finished();

private:
    void connectWizard();
    void connectWork();
    void takeOpened(const Opened& opened);
    void scenarioChanged();
    void showResults();
    void showSummary();
    void showUndo();
    void lookForEvidence();
    void takeBestUnits(const widgets::NewCaseUnits::Evidence& evidence);
    void audit();
    void chooseTerrain();
    void setTerrain(const QString& path);
    void edit(const QString& key, const ParameterValue& value);
    void showFailure(const Failure& failure);
    void make();

    QWidget& m_window;
    Document m_document;
    Computation m_computation;
    widgets::CasePreview* m_preview;
    std::unique_ptr<widgets::NewCaseWizard> m_wizard;
    ComponentDisplay* m_components;
    std::shared_ptr<const FeResult> m_judged;     // that evidence was looked for in
    bool m_makeOnceRead = false;                  // the case was asked for while its units are read anew
    bool m_unitsTaken = false;                    // the best that the file fits was looked for
    std::shared_ptr<const Components> m_audited;  // that the account of deaths is about
    // Last, so that it has ended before anything it uses goes.
    Worker m_examiner;
};

}  // namespace rubble
