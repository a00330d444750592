#include "widgets/evidence/surveys/scanner_field.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/panel.h"

namespace rubble::widgets {

namespace {

QString listed(const std::vector<Vec3>& places) {
    QStringList words;
    for (const Vec3& place : places) {
        words << QStringLiteral("%1,%2,%3").arg(place.x(), 0, 'g', 12).arg(place.y(), 0, 'g', 12).arg(place.z(), 0, 'g', 12);
    }
    return words.join(QStringLiteral("; "));
}

}  // namespace

ScannerField::ScannerField(const QString& otherwise, QWidget* parent)
    : QWidget(parent),
      m_text(new QLineEdit),
      m_pick(new QPushButton(tr("Pick…"))),
      m_table(new QPushButton(tr("From a table…"))),
      m_complaint(new Notice) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->addWidget(m_pick);
    row->addWidget(m_table);
    column->addWidget(m_text);
    column->addLayout(row);
    column->addWidget(m_complaint);
    m_text->setAccessibleName(tr("Places of the scanners"));
    m_text->setPlaceholderText(otherwise);
    m_text->setToolTip(
        tr("Easting, northing and height of each scanner in the system of the case, m: 12.5,-3,1.8; 40,7,2.1. Points are held "
           "against what was to be seen from there"));
    m_table->setToolTip(tr("Take them from a table whose heading names easting, northing and height"));
    m_pick->setToolTip(tr("Click them in the model, list them, and change or remove them"));
    for (QPushButton* button : {m_pick, m_table}) {
        button->setAutoDefault(false);
    }
    connect(m_text, &QLineEdit::editingFinished, this, &ScannerField::take);
    connect(m_pick, &QPushButton::clicked, this, &ScannerField::pickRequested);
    connect(m_table, &QPushButton::clicked, this, &ScannerField::tableRequested);
}

void ScannerField::setPlaces(const std::vector<Vec3>& places) {
    if (places == m_places && m_text->isModified()) {
        return;  // what is being typed stays
    }
    m_places = places;
    m_text->setText(listed(places));
    m_text->setCursorPosition(0);
    m_complaint->set(Notice::Kind::Error, {});
}

void ScannerField::takePlaces(const std::vector<Vec3>& places) {
    m_text->selectAll();
    m_text->insert(listed(places));
    take();
}

std::optional<std::vector<Vec3>> ScannerField::places() const {
    std::vector<Vec3> all;
    for (const QString& part : m_text->text().split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        const QStringList numbers = part.trimmed().split(QLatin1Char(','));
        Vec3 place;
        bool sound = numbers.size() == 3;
        for (int axis = 0; sound && axis < 3; ++axis) {
            place[axis] = numbers[axis].trimmed().toDouble(&sound);
            sound = sound && std::isfinite(place[axis]);
        }
        if (sound) {
            all.push_back(place);
        } else if (!part.trimmed().isEmpty()) {
            return std::nullopt;
        }
    }
    return all;
}

void ScannerField::ask() {
    askIn(*m_text);
}

void ScannerField::take() {
    const std::optional<std::vector<Vec3>> said = places();
    m_complaint->set(Notice::Kind::Error, said ? QString()
                                               : tr("Write easting, northing and height of each scanner, such as 12.5,-3,1.8; "
                                                    "40,7,2.1"));
    if (said && *said != m_places) {
        m_places = *said;
        m_text->setModified(false);
        emit edited(*said);
    }
}

}  // namespace rubble::widgets
