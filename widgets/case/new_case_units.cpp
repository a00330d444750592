#include "widgets/case/new_case_units.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>

#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

constexpr int rowsShown = 6;  // of systems; those that fit worse are out of the question

QString nameOf(const UnitSystem& system) {
    return QString::fromUtf8(system.id.data(), static_cast<qsizetype>(system.id.size()));
}

QString reasonsOf(const UnitFit& fit) {
    QStringList reasons;
    for (const Message& reason : fit.reasons) {
        reasons << worded(reason);
    }
    return inOneLine(reasons);
}

}  // namespace

NewCaseUnits::NewCaseUnits(QWidget* parent)
    : Panel(tr("Units and axes"), tr("What the numbers of the file mean."), parent),
      m_unitsProposal(new Notice),
      m_axisProposal(new Notice),
      m_takeUnits(new QPushButton),
      m_takeAxis(new QPushButton),
      m_fits(new QTableWidget(0, 2)),
      m_findings(new FindingList) {
    PanelGroup* units = addGroup(tr("Units of the file"));
    addParameter(units, "units");
    // The first two are words of case files, not units.
    units
        ->addNote(tr("%1: kilograms, metres and seconds, unless the case names another unit of length.\n%2: the system that the "
                     "densities, size and free fall of the file fit, if only one does.")
                      .arg(shownName("frame"), shownName("auto")))
        ->setObjectName(QStringLiteral("unitsWords"));
    units->addWide(m_unitsProposal);
    m_takeUnits->setObjectName(QStringLiteral("takeUnits"));
    units->addWide(m_takeUnits);
    buildTable();
    units->addWide(m_fits);
    PanelGroup* axes = addGroup(tr("Which axis points up"));
    addParameter(axes, "up_axis");
    axes->addNote(
            tr("%1: the axis that the case names, z where it names none.\n%2: the one against which free nodes are seen to fall.")
                .arg(shownName("frame"), shownName("auto")))
        ->setObjectName(QStringLiteral("axisWords"));
    axes->addWide(m_axisProposal);
    m_takeAxis->setObjectName(QStringLiteral("takeAxis"));
    axes->addWide(m_takeAxis);
    PanelGroup* then = addGroup(tr("What follows from that"));
    m_size = then->addValue(tr("Structure"), tr("m"), tr("Length, width and height at rest, along x, y and z"));
    m_mass = then->addValue(tr("Mass"), {}, tr("Of all elements, by the densities of their components"));
    m_span = then->addValue(tr("Time"), {}, tr("First and last state"));
    m_states = then->addValue(tr("States"));
    m_elements = then->addValue(tr("Elements"));
    m_format = then->addValue(tr("Format"));
    addWide(m_findings);
    connect(m_takeUnits, &QPushButton::clicked, this, [this] { take("units", m_evidence.units.choice); });
    connect(m_takeAxis, &QPushButton::clicked, this, [this] { take("up_axis", m_evidence.upAxis.choice); });
    setContent(nullptr, std::nan(""));
}

void NewCaseUnits::buildTable() {
    m_fits->setHorizontalHeaderLabels({tr("units"), tr("what speaks for or against them")});
    m_fits->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_fits->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    for (int column = 0; column < 2; ++column) {
        m_fits->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }
    m_fits->horizontalHeader()->setFont(headingFont());
    m_fits->verticalHeader()->hide();
    m_fits->setFont(headingFont());
    m_fits->setShowGrid(false);
    m_fits->setWordWrap(true);
    m_fits->setSelectionMode(QAbstractItemView::NoSelection);
    m_fits->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_fits->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_fits->setFocusPolicy(Qt::TabFocus);
    m_fits->setTabKeyNavigation(false);
    m_fits->setAccessibleName(tr("Systems of units, the best fit first"));
    m_fits->setToolTip(tr("Systems of units, the best fit first: densities, size and free fall judge them. A click takes one"));
    const auto takeRow = [this](int row) {
        if (row >= 0 && row < static_cast<int>(m_evidence.fits.size())) {
            take("units", std::string(m_evidence.fits[static_cast<std::size_t>(row)].system->id));
        }
    };
    // Also where a scroll bar or a longer name takes room from the words.
    connect(m_fits->horizontalHeader(), &QHeaderView::sectionResized, this, [this](int column) {
        if (column == 1) {
            fitRows();
        }
    });
    connect(m_fits, &QTableWidget::cellClicked, this, takeRow);
    connect(m_fits, &QTableWidget::cellActivated, this, takeRow);
}

void NewCaseUnits::take(const char* key, const std::string& choice) {
    if (!choice.empty()) {
        emit edited(QLatin1String(key), ParameterValue(choice));
    }
}

void NewCaseUnits::setContent(const FeResult* fe, double mass) {
    const QString none(QChar(0x2013));
    if (fe == nullptr || fe->stateCount() == 0) {
        for (QLabel* label : {m_size, m_mass, m_span, m_states, m_elements, m_format}) {
            label->setText(none);
        }
        m_taken.clear();
        m_axis.clear();
        m_findings->set({});
        setEvidence({});
        return;
    }
    const FeResult::Contents& contents = fe->contents();
    Aabb box;
    for (const Vec3& node : fe->mesh().nodes) {
        box.extend(node);
    }
    const Vec3 size = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
    m_size->setText(
        QStringLiteral("%1 × %2 × %3").arg(shownIn(size.x(), "m", 4), shownIn(size.y(), "m", 4), shownIn(size.z(), "m", 4)));
    m_mass->setText(std::isnan(mass) ? none : shownMass(mass, 4));
    m_span->setText(QStringLiteral("%1 – %2").arg(figures::timeText(fe->times().front()), figures::timeText(fe->times().back())));
    m_states->setText(shownCount(static_cast<std::int64_t>(fe->stateCount())));
    m_elements->setText(shownCount(static_cast<std::int64_t>(fe->mesh().elementCount())));
    m_format->setText(figures::spokenText(contents.format));
    const UnitSystem* taken = systemOf(contents.units);
    m_taken = taken != nullptr ? std::string(taken->id) : std::string();
    m_axis = contents.frame.upAxis;
    m_findings->set(contents.findings);
    showProposals();
    showFits();
}

void NewCaseUnits::setEvidence(const Evidence& evidence) {
    m_evidence = evidence;
    showProposals();
    showFits();
}

QString NewCaseUnits::rivals() const {
    QStringList others;
    for (const std::string& id : rivalSystems(m_evidence.fits)) {
        if (id != m_taken) {
            others << QString::fromStdString(id);
        }
    }
    return m_taken.empty() ? QString() : others.join(QStringLiteral(", "));
}

// A proposal that was taken is said as such; one that was not asks for a decision.
void NewCaseUnits::showProposals() {
    const auto show = [](Notice& notice, QPushButton& button, const Proposal& proposal, const std::string& taken,
                         const QString& offer) {
        const bool open = !proposal.choice.empty() && proposal.choice != taken;
        const bool undecided = proposal.reason.id == "units.ambiguous" || proposal.reason.id == "units.none";
        notice.set(open || undecided ? Notice::Kind::Finding : Notice::Kind::Note,
                   proposal.reason.pattern.empty() ? QString() : worded(proposal.reason));
        button.setVisible(open);
        button.setText(offer.arg(QString::fromStdString(proposal.choice)));
    };
    Proposal units = m_evidence.units;
    if (!m_evidence.fits.empty() && units.reason.arguments.size() > 1) {
        // With units as in the table: the proposal carries the reasons of the best fit as one English text.
        units.reason.arguments[1] = reasonsOf(m_evidence.fits.front()).toStdString();
    }
    show(*m_unitsProposal, *m_takeUnits, units, m_taken, tr("Take %1"));
    show(*m_axisProposal, *m_takeAxis, m_evidence.upAxis, m_axis, tr("Let %1 point up"));
    m_takeUnits->setToolTip(tr("Read the file again in the units that it fits best"));
    m_takeAxis->setToolTip(tr("Read the file again with the axis against which free nodes fall pointing up"));
}

void NewCaseUnits::showFits() {
    const int rows = std::min<int>(rowsShown, static_cast<int>(m_evidence.fits.size()));
    m_fits->setVisible(rows > 0);
    m_fits->setRowCount(rows);
    for (int row = 0; row < rows; ++row) {
        const UnitFit& fit = m_evidence.fits[static_cast<std::size_t>(row)];
        const QString reasons = reasonsOf(fit);
        const bool taken = fit.system->id == m_taken;
        auto* name = new QTableWidgetItem(taken ? tr("%1 (taken)").arg(nameOf(*fit.system)) : nameOf(*fit.system));
        name->setToolTip(figures::spokenText(std::string(fit.system->words)));
        name->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
        QFont font = headingFont();
        font.setBold(taken);
        name->setFont(font);
        auto* why = new QTableWidgetItem(reasons.isEmpty() ? tr("nothing in the file speaks for or against them") : reasons);
        why->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
        why->setToolTip(why->text());
        m_fits->setItem(row, 0, name);
        m_fits->setItem(row, 1, why);
    }
    fitRows();
}

/// Each row is as high as its words need.
void NewCaseUnits::fitRows() {
    int height = m_fits->horizontalHeader()->sizeHint().height() + 4;
    m_fits->resizeRowsToContents();
    for (int row = 0; row < m_fits->rowCount(); ++row) {
        height += m_fits->rowHeight(row);
    }
    m_fits->setFixedHeight(std::min(height, 300));
}

}  // namespace rubble::widgets
