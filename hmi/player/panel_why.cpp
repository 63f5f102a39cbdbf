#include "hmi/player/panel_why.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "runtime/inside/words.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::hmi {

using inside::Sentence;

struct PanelWhy::Answer {
    Error error;
    std::vector<Sentence> sentences;
};

namespace {

constexpr size_t kMostChanges = 50;

template <class Found> std::vector<Sentence> orError(const Result<Found>& found, Error& error) {
    if (found) return inside::sentencesOf(*found);
    error = found.error();
    return {};
}

std::vector<Sentence> changesOf(const Result<std::vector<inside::Writer>>& found, Error& error) {
    std::vector<Sentence> all;
    if (!found) return error = found.error(), all;
    for (const inside::Writer& writer : *found) all.push_back(inside::sentenceOf(writer));
    return all;
}

} // namespace

PanelWhy::PanelWhy(const history::History& history, kit::AskWhy question, const QString& expression,
                   std::optional<history::Position> at, const QString& language, OperatorNames names, QWidget* parent)
    : QWidget(parent), m_language(language), m_names(std::move(names)), m_state(new QLabel(expression, this)),
      m_tree(new QTreeWidget(this)) {
    setAutoFillBackground(true);
    setFocusPolicy(Qt::StrongFocus);
    auto* close = new QToolButton(this);
    close->setIcon(kit::icon(kit::Icon::Close));
    close->setMinimumSize(44, 44); // for fingers
    connect(close, &QToolButton::clicked, this, &QObject::deleteLater);
    m_state->setWordWrap(true);
    m_tree->setHeaderHidden(true);
    m_tree->setWordWrap(true);
    m_tree->setObjectName("panelWhy");
    auto* row = new QHBoxLayout;
    row->addWidget(m_state, 1);
    row->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(row);
    layout->addWidget(m_tree, 1);
    const history::Position when = at.value_or(history.statistics().end - 1);
    m_thread = std::thread([this, &history, question, when, asked = inside::Question{expression.toStdString(), {}}] {
        inside::Insight insight(history);
        insight.setCancel([isCancelled = m_isCancelled] { return isCancelled->load(); });
        inside::Reasoner reasoner(insight);
        Answer answer;
        switch (question) {
        case kit::AskWhy::Why:
            answer.sentences = orError(reasoner.why(asked, when), answer.error);
            break;
        case kit::AskWhy::WhyNot:
            answer.sentences = orError(reasoner.whyNot(asked, when), answer.error);
            break;
        case kit::AskWhy::Who:
            answer.sentences = changesOf(reasoner.writersBackFrom(asked, when, kMostChanges), answer.error);
            break;
        }
        kit::post(this, [this, answer = std::move(answer)] { show(answer); });
    });
}

PanelWhy::~PanelWhy() {
    *m_isCancelled = true;
    m_thread.join();
}

void PanelWhy::show(const Answer& answer) {
    m_isAnswered = true;
    if (!answer.error.message.isEmpty()) return m_state->setText(kit::messageText(answer.error, m_language));
    const auto add = [this](auto&& self, QTreeWidgetItem* parent, const Sentence& sentence) -> void {
        auto* item = parent ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(m_tree);
        item->setText(0, kit::messageText(inOperatorsWords(sentence.text, m_names), m_language));
        item->setToolTip(0, kit::messageText(sentence.text, m_language)); // with the program's names
        for (const Sentence& part : sentence.parts) self(self, item, part);
        item->setExpanded(sentence.kind != inside::SentenceKind::Step);
    };
    for (const Sentence& sentence : answer.sentences) add(add, nullptr, sentence);
}

QString PanelWhy::text() const {
    QString all = m_state->text() + u'\n';
    for (QTreeWidgetItemIterator it(m_tree); *it; ++it) all += (*it)->text(0) + u'\n';
    return all;
}

void PanelWhy::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return deleteLater();
    QWidget::keyPressEvent(event);
}

} // namespace plc::hmi
