#pragma once

#include <QCoreApplication>

#include "widgets/figures/report/report_text.h"

namespace rubble::figures {

/// Writes the sections of a report one by one.
class ReportSections {
    Q_DECLARE_TR_FUNCTIONS(rubble::figures::ReportSections)
public:
    ReportSections(const ReportFacts& facts, const ReportPictures& pictures);

    void addPlainSummary();
    void addSummary();
    void addEvidence();
    void addAlternatives();
    void addChange();
    void addSignature();
    void addMethod();
    void addCautions();
    void addInputs();
    void addResults();
    void addEnsemble();
    void addAccuracy();
    void addValidation();
    void addEffects();
    void addHealth();
    void addSelfTest();
    void addLimits();
    void addParameters();
    void addJournal();

    std::vector<ReportBlock> take() { return std::move(m_blocks); }
    /// "Run 1a2b..., trajectory 3c4d...": what every table stands on.
    QString source() const;

private:
    void heading(const QString& text, int level = 1) { m_blocks.push_back(ReportHeading{level, text, false}); }
    void text(const QString& html) { m_blocks.push_back(ReportText{html}); }
    /// What the author wrote, as it was written: paragraphs and lists.
    void ownWords(const std::string& words);
    void notice(const QString& html) { m_blocks.push_back(ReportNotice{html}); }
    QString said(const Message& message) const;
    void equation(const char* notation, const QString& words, const QString& where);
    void addFiles();
    void addPlace();
    void addControlPoints();
    void addPhotographs();
    void addPhotograph(const ReportPhoto& photo, const QImage& picture);
    void addEvidenceCautions(const std::string& name, const std::vector<Caution>& cautions);
    void addSurveys();
    void addSurveyRows(ReportTable& table, const QString& name, const SurveyComparison& made) const;
    void addFragmentMethod();
    void addGridMethod();
    void addMotionMethod();
    void addMeasureMethod();
    void addComponents();
    void addContacts();
    void addAssumptions();
    void addEnsembleSpread();
    /// What the members of the ensemble come to, for the summary, and how they lie on the ground.
    QString ensembleWords() const;
    QString ensembleSurface() const;
    /// "12 to 19", between which nine of ten members of the ensemble lie, or all where they are few; a dash with fewer than two.
    QString memberSpread(MemberMeasure measure) const;
    void addMeasures();
    void addComponentDebris();
    void addCourse();
    void addConservation();
    void addCarried();
    void addFloor(const RepeatFloor& floor, const QString& caption, const QString& from);
    void addReference();
    void addSweep();
    void addComparedCauses(const ReportCauses& causes);
    void addFurtherEvidence(const ReportCauses& causes);

    const ReportFacts& m_facts;
    const ReportPictures& m_pictures;
    std::vector<ReportBlock> m_blocks;
};

/// A number of so many significant digits with thousands grouped; a dash where it is none.
QString reportNumber(double value, int digits = 3);
/// Seconds to the hundredth, without unit.
QString reportSeconds(double seconds);
/// Of sums that are known to rounding, such as masses of the ledger.
inline constexpr int ledgerDigits = 4;
/// A unit as print has it: powers raised, a sign for times.
QString unitShown(QString unit);
/// Text in which a reader of HTML finds no tag.
QString escaped(const std::string& text);
/// With as many digits as its range deserves: "12.3 (11.9 to 12.6)"; the number alone where both ends are the same.
QString rangedNumber(double value, const FigureRange& range);
/// A digest of which the first sixteen figures tell it from others, as code.
QString shortDigest(const std::string& digest);

}  // namespace rubble::figures
