#include "editor/inside/why_view.h"

#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "runtime/inside/texts.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QTreeWidget>

namespace plc::editor {

using inside::Sentence;
using inside::SentenceKind;

namespace {

constexpr int kPlaceRole = Qt::UserRole, kScanRole = Qt::UserRole + 1, kPathRole = Qt::UserRole + 2,
              kMoreRole = Qt::UserRole + 3;
constexpr size_t kChangesAtOnce = 50;
constexpr int kUnfolded = 3; // levels

std::optional<kit::Icon> iconOf(SentenceKind kind) {
    switch (kind) {
    case SentenceKind::Head:
        return std::nullopt;
    case SentenceKind::Writer:
        return kit::Icon::Write;
    case SentenceKind::Trigger:
        return kit::Icon::Trigger;
    case SentenceKind::Enabler:
        return kit::Icon::Check;
    case SentenceKind::Holding:
        return kit::Icon::Link;
    case SentenceKind::Way:
        return kit::Icon::Lightbulb;
    case SentenceKind::Step:
        return kit::Icon::Step;
    case SentenceKind::Note:
        return kit::Icon::Information;
    }
    return std::nullopt;
}

} // namespace

WhyView::WhyView(InsideDesk& desk, RunControl& control, QWidget* parent)
    : QWidget(parent), m_desk(desk), m_control(control) {
    m_input = new kit::ExpressionEdit(this);
    m_input->setObjectName("whyExpression");
    m_input->setPlaceholderText(tr("For example Main.level > 80"));
    m_input->setAccessibleName(tr("Variable or expression to explain"));
    const auto button = [this](const QString& text, const QString& tip, const char* name, kit::AskWhy question) {
        auto* made = new QToolButton(this);
        made->setText(text);
        made->setToolTip(tip);
        made->setObjectName(name);
        connect(made, &QToolButton::clicked, this, [this, question] { askAgain(question); });
        return made;
    };
    m_why = button(tr("Why?"), tr("What changed it, and what had to hold"), "why", kit::AskWhy::Why);
    m_whyNot = button(tr("Why Not?"), tr("The smallest changes that would change the result of the condition"),
                      "whyNot", kit::AskWhy::WhyNot);
    m_who = button(tr("Who Set This?"), tr("All changes in the recording, and what made each of them"), "who",
                   kit::AskWhy::Who);
    m_cancel = new QToolButton(this);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Cancel (Esc)"));
    m_cancel->setObjectName("whyCancel");
    m_cancel->hide();
    connect(m_cancel, &QToolButton::clicked, this, &WhyView::cancel);
    connect(m_input, &QLineEdit::returnPressed, this, [this] { askAgain(kit::AskWhy::Why); });
    m_state = new QLabel(this);
    m_state->setWordWrap(true);
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_tree = new QTreeWidget(this);
    m_tree->setObjectName("whyTree");
    m_tree->setAccessibleName(tr("Explanation"));
    m_tree->setColumnCount(2);
    m_tree->setHeaderLabels({tr("Explanation"), tr("Scan")});
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree->setWordWrap(true);
    m_tree->setUniformRowHeights(false);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &WhyView::showMenu);
    connect(m_tree, &QTreeWidget::itemClicked, this, &WhyView::goTo);
    connect(m_tree, &QTreeWidget::itemActivated, this, &WhyView::goTo); // Enter
    auto* row = new QHBoxLayout;
    row->addWidget(m_input, 1);
    for (QToolButton* each : {m_why, m_whyNot, m_who}) row->addWidget(each);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 0);
    layout->setSpacing(4);
    auto* stateRow = new QHBoxLayout;
    stateRow->addWidget(m_state, 1);
    stateRow->addWidget(m_cancel, 0, Qt::AlignTop);
    layout->addLayout(row);
    layout->addLayout(stateRow);
    layout->addWidget(m_tree, 1);
    setMinimumSize(260, 120);
    showState(tr("Right-click a variable in the text, the watch, the tree, the trace or a panel and ask why it has its "
                 "value."),
              false);
    connect(&control, &RunControl::sessionChanged, this, &WhyView::clear);
}

void WhyView::clear() {
    ++m_number;
    m_tree->clear();
    m_places.clear();
    m_programs.clear();
    setWaiting(false);
    showState({}, false);
}

void WhyView::setWaiting(bool isWaiting) {
    m_isWaiting = isWaiting;
    m_cancel->setVisible(isWaiting);
}

void WhyView::cancel() {
    if (!m_isWaiting) return;
    ++m_number;
    m_desk.cancel("why");
    setWaiting(false);
    showState(tr("Cancelled: there is no answer."), false);
}

void WhyView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_isWaiting) return cancel();
    QWidget::keyPressEvent(event);
}

void WhyView::showState(const QString& text, bool isError) {
    QPalette palette = this->palette();
    palette.setColor(QPalette::WindowText, isError ? kit::colors().bad : kit::colors().muted);
    m_state->setPalette(palette);
    m_state->setText(text);
    m_state->setVisible(!text.isEmpty());
}

void WhyView::askAgain(kit::AskWhy question) {
    const QString text = m_input->text().trimmed();
    if (text.isEmpty()) return;
    const bool isSame =
        text == (m_asked.scope.isEmpty() ? m_asked.expression : m_asked.scope + u'.' + m_asked.expression);
    if (isSame) return ask(question, m_asked.expression, m_asked.scope);
    ask(question, text);
}

void WhyView::ask(kit::AskWhy question, const QString& expression, const QString& scope,
                  std::optional<history::Position> at) {
    clear();
    m_asked = {question, expression, scope, at ? at : m_control.viewed()};
    m_input->setText(expression);
    const inside::Question wanted{expression.toStdString(), scope.toStdString()};
    const bool isAsked =
        m_desk.ask("why", [this, asked = m_asked, wanted, number = m_number](InsideDesk::Bench& bench) {
            return [this, number, answer = answerOf(bench, asked, wanted)] {
                if (number == m_number) show(answer, false);
            };
        });
    setWaiting(isAsked);
    if (isAsked)
        showState(tr("Searching the recorded scans…"), false);
    else
        showState(tr("There is no recording yet: run the program first."), true);
}

WhyView::Answer WhyView::answerOf(InsideDesk::Bench& bench, const Asked& asked, const inside::Question& question) {
    const history::Position at = asked.at.value_or(bench.history.statistics().end - 1);
    Answer answer;
    switch (asked.question) {
    case kit::AskWhy::Why: {
        const auto found = bench.reasoner.why(question, at);
        if (!found) return answer.error = found.error(), answer;
        answer.sentences = inside::sentencesOf(*found);
        answer.program = found->program;
        return answer;
    }
    case kit::AskWhy::WhyNot: {
        const auto found = bench.reasoner.whyNot(question, at);
        if (!found) return answer.error = found.error(), answer;
        answer.sentences = inside::sentencesOf(*found);
        answer.program = found->program;
        return answer;
    }
    case kit::AskWhy::Who:
        return writersOf(bench, question, at, true);
    }
    return answer;
}

WhyView::Answer WhyView::writersOf(InsideDesk::Bench& bench, const inside::Question& question, history::Position at,
                                   bool isFirst) {
    Answer answer;
    const auto found = bench.reasoner.writersBackFrom(question, at, kChangesAtOnce);
    if (!found) return answer.error = found.error(), answer;
    for (const inside::Writer& writer : *found) {
        answer.sentences.push_back(inside::sentenceOf(writer));
        answer.program = writer.program;
    }
    if (found->size() >= kChangesAtOnce && found->back().at.position > 0) answer.more = found->back().at.position - 1;
    if (answer.sentences.empty() && isFirst) answer.error = Error{inside::texts::NeverChanged(), question.text};
    return answer;
}

QTreeWidgetItem* WhyView::add(QTreeWidgetItem* parent, const Sentence& sentence, const Answer& answer) {
    auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(m_tree);
    const QString words = kit::messageText(sentence.text);
    item->setText(0, words);
    item->setToolTip(0, words);
    if (const auto icon = iconOf(sentence.kind)) item->setIcon(0, kit::icon(*icon));
    const bool isHead = !parent || sentence.kind == SentenceKind::Head;
    if (isHead && sentence.parts.empty() == (sentence.kind == SentenceKind::Head)) {
        QFont bold = item->font(0);
        bold.setBold(true);
        item->setFont(0, bold);
    }
    item->setData(0, kPathRole, QString::fromStdString(sentence.path));
    if (sentence.at) {
        item->setData(0, kScanRole, QVariant::fromValue<qulonglong>(sentence.at->position));
        item->setText(1, tr("%1 · scan %2", "time and number")
                             .arg(plot::momentText(sentence.at->time.count()))
                             .arg(sentence.at->scan));
    }
    if (sentence.range.file.isValid() && sentence.range.length() && answer.program) {
        item->setData(0, kPlaceRole, static_cast<int>(m_places.size()));
        m_places.emplace_back(sentence.range, answer.program.get());
    }
    for (const Sentence& part : sentence.parts) add(item, part, answer);
    return item;
}

void WhyView::show(const Answer& answer, bool isMore) {
    setWaiting(false);
    if (!answer.error.message.isEmpty()) {
        showState(kit::messageText(answer.error), true);
        return emit answered();
    }
    showState({}, false);
    if (answer.program) m_programs.push_back(answer.program);
    for (const Sentence& sentence : answer.sentences) {
        QTreeWidgetItem* item = add(nullptr, sentence, answer);
        const bool isLong = sentence.kind == SentenceKind::Step || sentence.kind == SentenceKind::Writer;
        const auto unfold = [](auto&& self, QTreeWidgetItem* each, int levels) -> void {
            each->setExpanded(true);
            for (int i = 0; levels > 1 && i < each->childCount(); ++i) self(self, each->child(i), levels - 1);
        };
        if (!isLong) unfold(unfold, item, kUnfolded);
    }
    if (answer.more) {
        auto* item = new QTreeWidgetItem(m_tree, {tr("Earlier changes…")});
        item->setIcon(0, kit::icon(kit::Icon::More));
        item->setData(0, kMoreRole, QVariant::fromValue<qulonglong>(*answer.more));
    }
    if (!isMore && m_tree->topLevelItemCount()) m_tree->scrollToTop();
    emit answered();
}

void WhyView::showMore(QTreeWidgetItem* item) {
    const history::Position before = item->data(0, kMoreRole).toULongLong();
    delete item;
    const inside::Question question{m_asked.expression.toStdString(), m_asked.scope.toStdString()};
    setWaiting(true);
    (void)m_desk.ask("why", [this, question, before, number = m_number](InsideDesk::Bench& bench) {
        return [this, number, answer = writersOf(bench, question, before, false)] {
            if (number == m_number) show(answer, true);
        };
    });
}

/// To the place in the text and to the scan.
void WhyView::goTo(QTreeWidgetItem* item) {
    if (item->data(0, kMoreRole).isValid()) return showMore(item);
    if (const QVariant scan = item->data(0, kScanRole); scan.isValid()) emit scanRequested(scan.toULongLong());
    const QVariant place = item->data(0, kPlaceRole);
    if (!place.isValid()) return;
    const auto& [range, program] = m_places[static_cast<size_t>(place.toInt())];
    if (const auto found = m_control.placeInText(range, *program))
        emit placeRequested(found->file, found->offset, found->length);
}

void WhyView::showMenu(const QPoint& position) {
    QTreeWidgetItem* item = m_tree->itemAt(position);
    QMenu menu(this);
    if (const QString path = item ? item->data(0, kPathRole).toString() : QString(); !path.isEmpty()) {
        const QVariant scan = item->data(0, kScanRole);
        const auto at = scan.isValid() ? std::optional<history::Position>(scan.toULongLong()) : std::nullopt;
        menu.addAction(kit::icon(kit::Icon::Question), tr("Why Is %1 So?").arg(path), this,
                       [this, path, at] { ask(kit::AskWhy::Why, path, {}, at); });
        menu.addAction(kit::icon(kit::Icon::Write), tr("Who Set %1?").arg(path), this,
                       [this, path, at] { ask(kit::AskWhy::Who, path, {}, at); });
        menu.addSeparator();
    }
    menu.addAction(kit::icon(kit::Icon::Copy), tr("Copy the Answer"), this,
                   [this] { QApplication::clipboard()->setText(text()); });
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

QString WhyView::focusedPath() const {
    const QTreeWidgetItem* item = m_tree->hasFocus() ? m_tree->currentItem() : nullptr;
    return item ? item->data(0, kPathRole).toString() : QString();
}

QString WhyView::text() const {
    QString all;
    const auto add = [&](auto&& self, const QTreeWidgetItem* item, int depth) -> void {
        all += QString(2 * depth, u' ') + item->text(0) + u'\n';
        for (int i = 0; i < item->childCount(); ++i) self(self, item->child(i), depth + 1);
    };
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) add(add, m_tree->topLevelItem(i), 0);
    return all;
}

} // namespace plc::editor
