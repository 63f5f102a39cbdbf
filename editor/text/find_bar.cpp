#include "editor/text/find_bar.h"

#include "editor/kit/icons.h"
#include "editor/kit/theme.h"
#include "editor/text/st_editor.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::editor {

FindBar::FindBar(StEditor& editor, QWidget* parent) : QWidget(parent), m_editor(&editor) {
    m_find = new QLineEdit(this);
    m_find->setPlaceholderText(tr("Find"));
    m_find->setClearButtonEnabled(true);
    m_find->setAccessibleName(tr("Text to find"));
    m_replace = new QLineEdit(this);
    m_replace->setPlaceholderText(tr("Replace with"));
    m_replace->setAccessibleName(tr("Replacement"));
    const auto toggle = [&](const QString& text, const QString& tip) {
        auto* button = new QToolButton(this);
        button->setText(text);
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setCheckable(true);
        button->setAutoRaise(true);
        connect(button, &QToolButton::toggled, this, [this] { countMatches(); });
        return button;
    };
    m_case = toggle("Aa", tr("Match case"));
    m_word = toggle("W", tr("Whole words"));
    m_regex = toggle(".*", tr("Regular expression"));
    m_count = new QLabel(this);
    m_count->setMinimumWidth(90);
    const auto button = [&](kit::Icon icon, const QString& tip, auto run) {
        auto* b = new QToolButton(this);
        b->setIcon(kit::icon(icon));
        b->setToolTip(tip);
        b->setAccessibleName(tip);
        b->setAutoRaise(true);
        connect(b, &QToolButton::clicked, this, run);
        return b;
    };
    auto* findRow = new QHBoxLayout;
    findRow->setContentsMargins(6, 3, 6, 3);
    findRow->addWidget(m_find, 1);
    findRow->addWidget(m_case);
    findRow->addWidget(m_word);
    findRow->addWidget(m_regex);
    findRow->addWidget(m_count);
    findRow->addWidget(button(kit::Icon::Up, tr("Previous (Shift+Enter)"), &FindBar::findPrevious));
    findRow->addWidget(button(kit::Icon::Down, tr("Next (Enter)"), &FindBar::findNext));
    findRow->addWidget(button(kit::Icon::Close, tr("Close (Esc)"), &FindBar::close));
    m_replaceRow = new QWidget(this);
    auto* replaceRow = new QHBoxLayout(m_replaceRow);
    replaceRow->setContentsMargins(6, 0, 6, 3);
    replaceRow->addWidget(m_replace, 1);
    auto* one = new QToolButton(this);
    one->setText(tr("Replace"));
    connect(one, &QToolButton::clicked, this, &FindBar::replaceOne);
    auto* all = new QToolButton(this);
    all->setText(tr("Replace All"));
    connect(all, &QToolButton::clicked, this, &FindBar::replaceAll);
    replaceRow->addWidget(one);
    replaceRow->addWidget(all);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(findRow);
    layout->addWidget(m_replaceRow);
    connect(m_find, &QLineEdit::textEdited, this, [this] {
        find(true, true);
        countMatches();
    });
    hide();
}

void FindBar::setEditor(StEditor& editor) { m_editor = &editor; } // both sides show one document: its marks stay

void FindBar::close() {
    hide();
    m_editor->highlightAll({}, false, false);
    m_editor->setFocus();
}

void FindBar::open(bool withReplace) {
    show();
    m_replaceRow->setVisible(withReplace && !m_editor->isReadOnly());
    if (m_editor->hasSelectedText() && !m_editor->selectedText().contains('\n'))
        m_find->setText(m_editor->selectedText());
    m_find->setFocus();
    m_find->selectAll();
    countMatches();
}

bool FindBar::find(bool forward, bool fromStart) {
    if (m_find->text().isEmpty()) return false;
    int line = 0, column = 0, endLine = 0, endColumn = 0;
    if (m_editor->hasSelectedText())
        m_editor->getSelection(&line, &column, &endLine, &endColumn);
    else
        m_editor->getCursorPosition(&line, &column), endLine = line, endColumn = column;
    const bool useBegin = !forward || fromStart;
    return m_editor->findFirst(m_find->text(), m_regex->isChecked(), m_case->isChecked(), m_word->isChecked(), true,
                               forward, useBegin ? line : endLine, useBegin ? column : endColumn, true, false, true);
}

void FindBar::findNext() { find(true, false); }
void FindBar::findPrevious() { find(false, false); }

void FindBar::replaceOne() {
    if (m_editor->isReadOnly()) return;
    if (m_editor->hasSelectedText() &&
        m_editor->selectedText().compare(m_find->text(),
                                         m_case->isChecked() ? Qt::CaseSensitive : Qt::CaseInsensitive) == 0 &&
        !m_regex->isChecked())
        m_editor->replaceSelectedText(m_replace->text());
    else if (m_regex->isChecked() && find(true, true))
        m_editor->replace(m_replace->text());
    find(true, false);
    countMatches();
}

int FindBar::replaceAll() {
    QString pattern = m_regex->isChecked() ? m_find->text() : QRegularExpression::escape(m_find->text());
    if (m_word->isChecked()) pattern = "\\b(?:" + pattern + ")\\b";
    const QRegularExpression regex(pattern, m_case->isChecked() ? QRegularExpression::MultilineOption
                                                                : QRegularExpression::MultilineOption |
                                                                      QRegularExpression::CaseInsensitiveOption);
    if (!regex.isValid() || m_find->text().isEmpty() || m_editor->isReadOnly()) return 0;
    const QString text = QString::fromStdString(m_editor->utf8());
    QString replacement = m_replace->text();
    if (!m_regex->isChecked()) replacement.replace('\\', "\\\\");
    int count = 0;
    for (auto matches = regex.globalMatch(text); matches.hasNext(); matches.next()) ++count;
    if (count == 0) return 0;
    QString replaced = text;
    replaced.replace(regex, replacement);
    m_editor->applyEdits({{{FileId(), 0, static_cast<uint32_t>(text.toUtf8().size())}, replaced.toStdString()}});
    m_count->setText(tr("%n replaced", nullptr, count));
    return count;
}

void FindBar::countMatches() {
    QString pattern = m_regex->isChecked() ? m_find->text() : QRegularExpression::escape(m_find->text());
    if (m_word->isChecked()) pattern = "\\b(?:" + pattern + ")\\b";
    const QRegularExpression regex(pattern, m_case->isChecked() ? QRegularExpression::MultilineOption
                                                                : QRegularExpression::MultilineOption |
                                                                      QRegularExpression::CaseInsensitiveOption);
    QPalette palette = m_find->palette();
    palette.setColor(QPalette::Text, regex.isValid() ? kit::colors().text : kit::colors().bad);
    m_find->setPalette(palette);
    m_editor->highlightAll(m_find->text().isEmpty() ? QString() : pattern, true, m_case->isChecked());
    if (m_find->text().isEmpty() || !regex.isValid())
        return m_count->setText(regex.isValid() ? QString() : tr("invalid regular expression"));
    int count = 0;
    for (auto matches = regex.globalMatch(QString::fromStdString(m_editor->utf8())); matches.hasNext() && count < 10000;
         matches.next())
        ++count;
    m_count->setText(count ? tr("%n found", nullptr, count) : tr("not found"));
}

void FindBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        return close();
    }
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (m_replace->hasFocus()) return replaceOne();
        return event->modifiers() & Qt::ShiftModifier ? findPrevious() : findNext();
    }
    QWidget::keyPressEvent(event);
}

} // namespace plc::editor
