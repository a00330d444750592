#pragma once

#include <QFrame>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace rubble::widgets {

/// A sentence above the centre that asks for a decision, with its choices as buttons. In place: the rest goes on meanwhile.
class NoticeBar : public QFrame {
    Q_OBJECT

public:
    struct Choice {
        QString id;
        QString text;
        QString tip;
        bool primary = false;
    };

    explicit NoticeBar(QWidget* parent = nullptr);

    /// @param sign  a warning sign stands before the sentence
    void setContent(const QString& what, const QString& more, const std::vector<Choice>& choices, bool sign = true);
    QString text() const;

signals:
    void chosen(const QString& id);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showSign();

    QLabel* m_sign;
    QLabel* m_words;
    QHBoxLayout* m_row;
    std::vector<QWidget*> m_buttons;
    bool m_warns = true;
    QString m_what;
    QString m_more;
};

}  // namespace rubble::widgets
