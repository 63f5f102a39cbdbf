#include "hmi/player/alarm_sheet.h"

#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace plc::hmi {

AlarmSheet::AlarmSheet(const AlarmBook& book, size_t alarm, const OverlayLook& look, bool canExplain, QWidget* parent)
    : Overlay(look, parent), m_alarm(book.definitions()[alarm].id) {
    const AlarmDefinition& definition = book.definitions()[alarm];
    const AlarmEntry entry = book.entryOf(alarm);
    auto* layout = new QVBoxLayout(box());
    layout->setContentsMargins(18, 14, 18, 14);
    layout->setSpacing(10);
    const auto addText = [&](const QString& text, const char* name) {
        if (text.isEmpty()) return;
        auto* label = new QLabel(text, box());
        label->setObjectName(QString::fromLatin1(name));
        label->setWordWrap(true);
        label->setMinimumWidth(std::min(420, parent->width() - 80));
        layout->addWidget(label);
    };
    addText(AlarmBook::render(entry, *look.texts, look.tag), "title");
    addText(look.texts->text(definition.help, look.tag), "help");
    const SetAside* aside = book.suppression().find(m_alarm);
    if (aside) {
        const QLocale locale = localeOf(look.tag);
        const QString until =
            aside->until ? locale.toString(aside->until->toLocalTime(), QLocale::ShortFormat) : QString();
        addText(aside->until ? words(SystemText::ShelvedUntil).arg(until) : words(SystemText::OutOfService), "hint");
        addText(aside->user, "hint");
    }
    auto* grid = new QGridLayout;
    const AlarmState state = book.lifeCycle().state(alarm);
    if (!aside && (state == AlarmState::Unacknowledged || state == AlarmState::Returned))
        addKey(AlarmAction::Acknowledge, words(SystemText::Acknowledge), grid);
    if (!definition.show.isEmpty()) addKey(AlarmAction::Show, words(SystemText::ShowMe), grid);
    if (aside) {
        addKey(AlarmAction::PutBack, words(SystemText::PutBack), grid);
    } else {
        addKey(AlarmAction::ShelveShort, words(SystemText::ShelveFor).arg(QStringLiteral("30 min")), grid);
        addKey(AlarmAction::ShelveLong, words(SystemText::ShelveFor).arg(QStringLiteral("8 h")), grid);
        addKey(AlarmAction::OutOfService, words(SystemText::OutOfService), grid);
    }
    if (canExplain && !definition.condition.isEmpty()) addWhy(definition.condition, look.tag, grid);
    auto* close = key(words(SystemText::Close), true);
    connect(close, &QPushButton::clicked, this, [this] {
        emit cancelled();
        this->close();
    });
    layout->addLayout(grid);
    layout->addWidget(close);
    place();
}

/// Behind the others, asked of the condition.
void AlarmSheet::addWhy(const QString& condition, const QString& language, QGridLayout* grid) {
    m_why = key(kit::messageText(errors::AskWhy(), language));
    const int at = static_cast<int>(m_keys.size());
    grid->addWidget(m_why, at / 2, at % 2);
    connect(m_why, &QPushButton::clicked, this, [this, condition] {
        emit whyAsked(condition);
        close();
    });
}

void AlarmSheet::addKey(AlarmAction action, const QString& text, QGridLayout* grid) {
    auto* button = key(text);
    m_keys.insert(static_cast<int>(action), button);
    const int at = static_cast<int>(m_keys.size()) - 1;
    grid->addWidget(button, at / 2, at % 2);
    connect(button, &QPushButton::clicked, this, [this, action] {
        emit chosen(action, m_alarm);
        close();
    });
}

} // namespace plc::hmi
