#include "widgets/evidence/surveys/place_pairs_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

#include "core/base/error.h"
#include "widgets/basics/fixed_number.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/model_marks.h"
#include "widgets/evidence/photo_view.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr int planPixels = 2500;  // longest side of the picture of a survey

QString pairMetres(double value) {
    return shownFixed(value, 3);
}

}  // namespace

PlacePairsDialog::PlacePairsDialog(SurveyHeights heights, const QString& name, const Aabb& around, QWidget* parent)
    : PickedPlacesDialog(tr("Place the survey by pairs"), tr("Model beside the survey"), parent),
      m_plan(std::move(heights)),
      m_name(name),
      m_picture(m_plan.picture(planPixels)),
      m_around(around),
      m_survey(new PhotoView),
      m_sum(new QLabel),
      m_deviation(new NumberField(tr("Accuracy of the places in the case"))),
      m_notice(new Notice),
      m_keep(new QPushButton(tr("Keep as table…"))) {
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_hint);
    column->addWidget(buildViews(), 1);
    column->addWidget(buildTable());
    column->addWidget(m_notice);
    QDialogButtonBox* buttons = endButtons(tr("Place survey"));
    m_place = buttons->button(QDialogButtonBox::Ok);
    column->addWidget(buttons);
    showPairs();
    m_survey->setFocus();
}

QWidget* PlacePairsDialog::buildViews() {
    auto* views = new QSplitter(Qt::Horizontal);
    views->setChildrenCollapsible(false);
    views->setHandleWidth(3);
    views->addWidget(m_survey);
    views->addWidget(m_model);
    views->setStretchFactor(0, 1);
    views->setStretchFactor(1, 1);
    m_survey->setAccessibleName(tr("Survey from above"));
    m_survey->setTool(PhotoView::Tool::Point);
    connect(m_survey, &PhotoView::pointPlaced, this, &PlacePairsDialog::placeSurveyed);
    connect(m_survey, &PhotoView::markChosen, this, [this](int mark) { m_table->selectRow(mark); });
    connect(m_survey, &PhotoView::toolLeft, this, &PlacePairsDialog::leave);
    return views;
}

QWidget* PlacePairsDialog::buildTable() {
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    prepareTable({tr("pair"), tr("Δx, m"), tr("Δy, m"), tr("Δz, m"), tr("apart, m")}, tr("What is left of each pair"),
                 tr("Where the place belongs less where the move of all pairs brings it, m"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    row->addWidget(m_table, 3);
    auto* side = new QVBoxLayout;
    side->addLayout(buildDeviation());
    m_sum->setWordWrap(true);
    m_sum->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    side->addWidget(m_sum, 1);
    QBoxLayout* buttons = changeButtons(tr("Take back the last click (Ctrl+Z)"), tr("Remove pair"));
    m_keep->setToolTip(tr("Write the pairs as a table that Pairs from a table… and the command line take"));
    m_keep->setAutoDefault(false);
    buttons->addWidget(m_keep);
    m_keep->hide();
    side->addLayout(buttons);
    row->addLayout(side, 2);
    connect(m_keep, &QPushButton::clicked, this, &PlacePairsDialog::keep);
    return box;
}

QLayout* PlacePairsDialog::buildDeviation() {
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Places in the case known to, m"));
    label->setBuddy(m_deviation);
    m_deviation->setRange(0.0, 1000.0);
    m_deviation->setEmptyMeans(tr("not known"));
    m_deviation->setToolTip(
        tr("Standard deviation along each axis of the places clicked in the model, as who measured or modelled "
           "them states it; it is part of the error of the registration"));
    connect(m_deviation, &NumberField::edited, this, &PlacePairsDialog::showPairs);
    row->addWidget(label);
    row->addWidget(m_deviation, 1);
    return row;
}

std::vector<PlacePair> PlacePairsDialog::pairs() const {
    std::vector<PlacePair> all = m_now.pairs;
    for (PlacePair& pair : all) {
        pair.deviation = m_deviation->number();
    }
    return all;
}

void PlacePairsDialog::take(Picked now) {
    if (now.surveyed && now.placed) {
        now.pairs.push_back({std::to_string(now.pairs.size() + 1), *now.surveyed, *now.placed});
        now.surveyed.reset();
        now.placed.reset();
    }
    if (!(now == m_now)) {
        m_past.push_back(std::exchange(m_now, std::move(now)));
    }
    m_said.clear();
    showPairs();
}

void PlacePairsDialog::placeSurveyed(const QPointF& pixel) {
    const std::optional<Vec3> place = m_plan.placeAt(pixel);
    if (!place) {
        m_said = tr("Nothing was surveyed there: click where the survey has heights.");
        showMarks();
        return;
    }
    Picked now = m_now;
    now.surveyed = place;
    take(std::move(now));
}

void PlacePairsDialog::placeModel(const Vec3& place) {
    Picked now = m_now;
    now.placed = place;
    take(std::move(now));
}

void PlacePairsDialog::undo() {
    if (!m_past.empty()) {
        m_now = std::move(m_past.back());
        m_past.pop_back();
        m_said.clear();
        showPairs();
    }
}

void PlacePairsDialog::clear() {
    take({});
}

bool PlacePairsDialog::dropPending() {
    const bool some = m_now.surveyed || m_now.placed;
    take({m_now.pairs, std::nullopt, std::nullopt});
    return some;
}

void PlacePairsDialog::removeChosen() {
    const int row = m_table->currentRow();
    if (row >= 0 && row < static_cast<int>(m_now.pairs.size())) {
        Picked now = m_now;
        now.pairs.erase(now.pairs.begin() + row);
        for (std::size_t p = 0; p < now.pairs.size(); ++p) {
            now.pairs[p].name = std::to_string(p + 1);
        }
        take(std::move(now));
    }
}

// Escape takes back what was begun; only then it closes, and pairs that were picked are left by Cancel alone.
void PlacePairsDialog::leave() {
    if (dropPending()) {
        return;
    }
    if (m_now.pairs.empty()) {
        reject();
        return;
    }
    m_said = tr("Cancel leaves without placing the survey.");
    showMarks();
}

void PlacePairsDialog::setKeeper(std::function<QString(const std::vector<PlacePair>&)> keep) {
    m_keeper = std::move(keep);
    m_keep->setVisible(m_keeper != nullptr);
}

void PlacePairsDialog::keep() {
    try {
        m_said = m_keeper(pairs());
    } catch (const Error& error) {
        m_said = worded(error.message()) + u' ' + worded(error.remedy());
    }
    showMarks();
}

bool PlacePairsDialog::bad(std::size_t pair) const {
    return m_fit && !m_fit->findings.empty() && m_fit->residuals[pair].norm() > 2.0 * m_fit->registration.pairsLeft;
}

void PlacePairsDialog::showPairs() {
    m_fit.reset();
    m_problem.clear();
    try {
        m_fit = fitPairs(pairs(), m_around);
    } catch (const UsageError& error) {
        // Until there are enough of them the hint says what to do.
        m_problem = m_now.pairs.size() < 3 ? QString() : worded(error.message()) + u' ' + worded(error.remedy());
    }
    showTable();
    showMarks();
    QString found;
    for (const Finding& finding : m_fit ? m_fit->findings.list() : std::vector<Finding>()) {
        found += (found.isEmpty() ? QString() : QStringLiteral("\n")) + worded(finding.what) + QStringLiteral(": ") +
                 worded(finding.remedy);
    }
    m_notice->set(m_fit ? Notice::Kind::Finding : Notice::Kind::Error, m_fit ? found : m_problem);
    m_undo->setEnabled(!m_past.empty());
    m_clear->setEnabled(!m_now.pairs.empty());
    m_keep->setEnabled(!m_now.pairs.empty());
    m_place->setEnabled(m_fit.has_value());
}

void PlacePairsDialog::showTable() {
    m_table->setRowCount(static_cast<int>(m_now.pairs.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const auto p = static_cast<std::size_t>(row);
        const QString none = QStringLiteral("–");
        QStringList cells{QString::fromStdString(m_now.pairs[p].name), none, none, none, none};
        if (m_fit) {
            const Vec3& left = m_fit->residuals[p];
            cells = {cells[0], pairMetres(left.x()), pairMetres(left.y()), pairMetres(left.z()), pairMetres(left.norm())};
        }
        for (int c = 0; c < cells.size(); ++c) {
            QTableWidgetItem* item = tableCell(cells[c], c == 0);
            if (bad(p)) {
                item->setForeground(tints().finding);
            }
            m_table->setItem(row, c, item);
        }
    }
    QStringList sum;
    if (m_fit) {
        const Registration& placed = m_fit->registration;
        sum << tr("Moved by %1 m, turned by %2°.").arg(shownNumber(placed.shift.norm()), shownDegrees(placed.turn.norm()));
        sum << tr("RMS of the pairs %1 m; places known to %2 m (standard deviation).")
                   .arg(shownNumber(placed.pairsLeft), shownNumber(placed.error.value_or(0.0)));
        if (!placed.control) {
            sum << tr("How accurate the places of the case are is not known, and not in it.");
        } else {
            sum << tr("The accuracy of the places of the case is in it.");
        }
    }
    sum << tr("The survey has a height every %1 m: a click is no better.").arg(shownNumber(m_plan.spacing()));
    m_sum->setText(sum.join(QLatin1Char('\n')));
}

QString PlacePairsDialog::hint() const {
    if (!m_said.isEmpty()) {
        return m_said;
    }
    if (m_now.surveyed) {
        return tr("Now click the same place in the model, at the right; nodes are caught. Esc takes the click back.");
    }
    if (m_now.placed) {
        return tr("Now click the same place in the survey, at the left. Esc takes the click back.");
    }
    const auto count = static_cast<int>(m_now.pairs.size());
    return count < 3
               ? tr("Click a place that did not move in the survey, then the same place in the model. Pairs: %1 of at least 3, far "
                    "apart and not on a line.")
                     .arg(count)
               : tr("Place the survey, or add pairs: more of them show better how well it lies.");
}

void PlacePairsDialog::showMarks() {
    const int chosen = m_table->currentRow();
    PhotoView::Content content;
    content.picture = m_picture;
    content.size = m_plan.size();
    content.title = m_name;
    content.chosenMark = chosen;
    content.pending = m_now.surveyed ? m_plan.pixelOf(*m_now.surveyed) : std::nullopt;
    ModelMarks::Content marks{{}, chosen, m_now.placed};
    for (std::size_t p = 0; p < m_now.pairs.size(); ++p) {
        const PlacePair& pair = m_now.pairs[p];
        const bool good = !bad(p);
        marks.marks.push_back({pair.placed, good});
        PhotoMark mark{QString::fromStdString(pair.name), m_plan.pixelOf(pair.surveyed).value_or(QPointF()), {}, good};
        if (m_fit) {
            mark.projected = m_plan.pixelOf(m_fit->registration.back(pair.placed));
        }
        content.marks.push_back(mark);
    }
    m_survey->setContent(content);
    m_marks->setContent(marks);
    m_hint->setText(hint());
    m_remove->setEnabled(chosen >= 0);
}

}  // namespace rubble::widgets
