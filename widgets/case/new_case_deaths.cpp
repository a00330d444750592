#include "widgets/case/new_case_deaths.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>
#include <array>

#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

QString instant(const std::optional<double>& time) {
    return time ? figures::timeText(*time) : QString(QChar(0x2013));
}

}  // namespace

QString anomalyWords(const std::string& kind) {
    const std::array<std::pair<const char*, QString>, 13> words{{
        {"zero_volume", NewCaseDeaths::tr("elements without volume when they die: they become fragments of the least thickness")},
        {"inverted", NewCaseDeaths::tr("elements turned inside out when they die: their shape is taken by its size")},
        {"sliver", NewCaseDeaths::tr("elements as thin as paper when they die: they become fragments of the least thickness")},
        {"large_distortion", NewCaseDeaths::tr("elements whose volume is far from the one at rest when they die")},
        {"inactive_from_start", NewCaseDeaths::tr("elements inactive from the first state on: they are no debris")},
        {"activated_later", NewCaseDeaths::tr("elements that only come to life later")},
        {"revived", NewCaseDeaths::tr("elements that come back to life: “Revived elements” decides")},
        {"death_time_of_active", NewCaseDeaths::tr("elements with a time of death that stay active")},
        {"no_death_time", NewCaseDeaths::tr("dead elements without a time of death: the state decides")},
        {"death_outside_bracket", NewCaseDeaths::tr("elements whose time of death is not between the states that report it")},
        {"no_density", NewCaseDeaths::tr("elements without density: the assumed one is taken")},
        {"no_section", NewCaseDeaths::tr("shells and beams without thickness or section: the assumed one is taken")},
        {"zero_volume_at_rest", NewCaseDeaths::tr("elements without volume at rest: they have no mass")},
    }};
    for (const auto& [stable, text] : words) {
        if (kind == stable) {
            return text;
        }
    }
    return shownName(kind);
}

NewCaseDeaths::NewCaseDeaths(QWidget* parent)
    : Panel(tr("Deaths"), tr("What dies when, and how far that can be believed."), parent),
      m_table(new QTableWidget(0, ColumnCount)),
      m_anomalies(new QVBoxLayout) {
    PanelGroup* account = addGroup(tr("Account of every death"));
    m_summary = account->addNote({});
    buildTable();
    account->addWide(m_table);
    PanelGroup* odd = addGroup(tr("What is odd"));
    auto* list = new QWidget;
    list->setLayout(m_anomalies);
    m_anomalies->setContentsMargins(0, 0, 0, 0);
    odd->addWide(list);
    PanelGroup* flag = addGroup(tr("How the file says it"));
    for (const char* key : {"status_variable", "active_value", "dead_parts", "revival", "birth_time"}) {
        addParameter(flag, key);
    }
    setContent(nullptr);
}

void NewCaseDeaths::buildTable() {
    m_table->setHorizontalHeaderLabels({tr("component"), tr("dead"), tr("of it"), tr("first"), tr("last")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_table->horizontalHeader()->setFont(headingFont());
    for (int column = 0; column < ColumnCount; ++column) {
        m_table->horizontalHeaderItem(column)->setTextAlignment((column == Name ? Qt::AlignLeft : Qt::AlignRight) |
                                                                Qt::AlignVCenter);
    }
    m_table->horizontalHeaderItem(Share)->setToolTip(tr("Share of the component's mass in dead elements"));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 9);
    m_table->setFont(headingFont());
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setTabKeyNavigation(false);
    m_table->setAccessibleName(tr("Deaths by component"));
    m_table->setToolTip(tr("Deaths by component; the preview goes to the first one of the row chosen"));
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (m_content != nullptr && row >= 0 && static_cast<std::size_t>(row) < m_content->spans.size() &&
            m_content->spans[static_cast<std::size_t>(row)].first) {
            emit instantRequested(*m_content->spans[static_cast<std::size_t>(row)].first);
        }
    });
}

void NewCaseDeaths::setContent(const std::shared_ptr<const Content>& content) {
    m_content = content;
    if (content == nullptr) {
        m_summary->setText(tr("The account is being made."));
    } else {
        const Audit& audit = content->audit;
        std::int64_t all = 0;
        for (const ComponentAudit& component : audit.components) {
            all += component.elements;
        }
        m_summary->setText(
            audit.deadTotal == 0
                ? tr("No element dies: all %1 are active at the last state. Is the active flag the right one?").arg(shownCount(all))
                : tr("%1 of %2 elements are dead at the last state: %3 of %4.")
                      .arg(shownCount(audit.deadTotal), shownCount(all), shownMass(audit.deadMass, 4), shownMass(audit.mass, 4)));
    }
    showTable();
    showAnomalies();
}

// Kinds and places of what is odd are words of core: they are said anew.
void NewCaseDeaths::changeEvent(QEvent* event) {
    Panel::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        setContent(m_content);
    }
}

void NewCaseDeaths::showTable() {
    const QSignalBlocker quiet(m_table);
    const auto rows = m_content != nullptr ? m_content->audit.components.size() : 0;
    m_table->setRowCount(static_cast<int>(rows));
    for (std::size_t i = 0; i < rows; ++i) {
        const ComponentAudit& component = m_content->audit.components[i];
        const Span span = i < m_content->spans.size() ? m_content->spans[i] : Span{};
        const int row = static_cast<int>(i);
        m_table->setItem(row, Name, fixedCell(QString::fromStdString(component.name), true));
        m_table->setItem(row, Dead, fixedCell(shownCount(component.dead), false));
        m_table->setItem(row, Share,
                         fixedCell(shownShare(component.mass > 0.0 ? component.deadMass / component.mass : 0.0, 0), false));
        m_table->setItem(row, First, fixedCell(instant(span.first), false));
        m_table->setItem(row, Last, fixedCell(instant(span.last), false));
    }
    const int lines = std::min(12, std::max(1, m_table->rowCount()));
    m_table->setFixedHeight((lines + 1) * (m_table->fontMetrics().height() + 9) + 8);
}

void NewCaseDeaths::showAnomalies() {
    while (QLayoutItem* item = m_anomalies->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    if (m_content == nullptr) {
        return;
    }
    for (const Anomaly& anomaly : m_content->audit.anomalies) {
        auto* notice = new Notice;
        m_anomalies->addWidget(notice);
        notice->set(Notice::Kind::Finding, tr("%1×: %2").arg(shownCount(anomaly.count), anomalyWords(anomaly.kind)),
                    anomaly.example.empty() ? QString() : tr("first: %1").arg(figures::spokenText(anomaly.example)));
    }
    if (m_content->audit.anomalies.empty()) {
        auto* fine = new QLabel(tr("Nothing odd was found."));
        fine->setObjectName(QStringLiteral("muted"));
        m_anomalies->addWidget(fine);
    }
}

}  // namespace rubble::widgets
