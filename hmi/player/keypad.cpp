#include "hmi/player/keypad.h"

#include "hmi/player/keypad_letters.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace plc::hmi {

Overlay::Overlay(const OverlayLook& look, QWidget* parent) : QWidget(parent), m_look(look), m_box(new QWidget(this)) {
    setGeometry(parent->rect());
    parent->installEventFilter(this);
    setAttribute(Qt::WA_DeleteOnClose);
    setFocusPolicy(Qt::StrongFocus);
    setLayoutDirection(hmi::isRightToLeft(look.tag) ? Qt::RightToLeft : Qt::LeftToRight);
    const PanelTheme& theme = look.theme;
    const auto name = [&](const char* role) { return theme.color(role).name(); };
    const QStringList families = look.texts->settings().fontFamilies(look.tag);
    QFont font;
    font.setFamilies(families);
    font.setPixelSize(18);
    setFont(font);
    m_box->setObjectName(QStringLiteral("box"));
    m_box->setAttribute(Qt::WA_StyledBackground);
    setStyleSheet(
        QStringLiteral("#box { background: %1; border: 2px solid %2; border-radius: 8px; }"
                       "QLabel { color: %3; } QLabel#hint { color: %4; font-size: 18px; }"
                       "QLineEdit { background: %5; color: %3; border: 1px solid %2; border-radius: 4px; padding: 6px; "
                       "font-size: 24px; }"
                       "QPushButton { background: %6; color: %3; border: 1px solid %2; border-radius: 5px; min-height: "
                       "44px; min-width: 44px; padding: 0 8px; }"
                       "QPushButton:pressed { background: %4; } QPushButton#main { background: %7; color: %8; }"
                       "QPushButton:focus { border: 3px solid %3; }"
                       "QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; border: none; }")
            .arg(name("surface"), name("line"), name("text"), name("muted"), name("inset"), name("button"),
                 name("accent"), PanelTheme::inkOn(theme.color("accent")).name()));
}

QPushButton* Overlay::key(const QString& text, bool isMain) const {
    auto* button = new QPushButton(text, m_box);
    button->setFocusPolicy(Qt::NoFocus);
    if (isMain) button->setObjectName(QStringLiteral("main"));
    return button;
}

QPushButton* Overlay::choice(const QString& text, bool isMain) const {
    QPushButton* button = key(text, isMain);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAutoDefault(true);
    return button;
}

void Overlay::place() {
    m_box->adjustSize();
    const QSize size = m_box->sizeHint().boundedTo(this->size() - QSize(8, 8));
    m_box->setGeometry(QRect(QPoint((width() - size.width()) / 2, (height() - size.height()) / 2), size));
    show();
    raise();
    setFocus();
}

void Overlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0, 0, 0, 110));
}

void Overlay::mousePressEvent(QMouseEvent* event) {
    if (m_box->geometry().contains(event->position().toPoint())) return; // between the keys
    emit cancelled();
    close();
}

void Overlay::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    emit cancelled();
    close();
}

bool Overlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize) {
        setGeometry(parentWidget()->rect());
        place();
    }
    return QWidget::eventFilter(watched, event);
}

// ---- keypad

Keypad::Keypad(const EntryRequest& request, const OverlayLook& look, QWidget* parent)
    : Overlay(look, parent), m_request(request) {
    auto* layout = new QVBoxLayout(box());
    layout->setContentsMargins(14, 12, 14, 14);
    layout->setSpacing(8);
    if (!request.title.isEmpty()) layout->addWidget(new QLabel(request.title, box()));
    m_edit = new QLineEdit(box());
    m_edit->setReadOnly(true); // keys come through this widget, so that no other keyboard opens
    m_edit->setFocusPolicy(Qt::NoFocus);
    m_edit->setAlignment(request.kind == EntryKind::Text ? Qt::AlignLeading : Qt::AlignCenter);
    if (request.isHidden) m_edit->setEchoMode(QLineEdit::Password);
    if (!request.present.isNone() && request.kind != EntryKind::Masked) {
        if (request.present.kind() == ValueKind::Text)
            m_edit->setText(request.present.text());
        else
            m_edit->setText(
                localeOf(look.tag).toString(request.present.toNumber() * request.factor + request.offset, 'g', 9));
    }
    m_edit->selectAll();
    layout->addWidget(m_edit);
    m_hint = new QLabel(limitsText(), box());
    m_hint->setObjectName(QStringLiteral("hint"));
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setMinimumHeight(22);
    layout->addWidget(m_hint);
    auto* keys = new QWidget(box());
    keys->setLayoutDirection(Qt::LeftToRight); // keypads are not mirrored where people read from right to left
    auto* grid = new QGridLayout(keys);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    const bool digitsOnly =
        request.kind == EntryKind::Number ||
        (request.kind == EntryKind::Masked && !request.mask.contains(u'A') && !request.mask.contains(u'*'));
    if (digitsOnly)
        addNumberKeys(grid);
    else
        addLetterKeys(grid);
    layout->addWidget(keys);
    place();
}

QString Keypad::limitsText() const {
    const QLocale locale = localeOf(m_look.tag);
    const auto text = [&](double value) {
        return locale.toString(value, 'g', 9) + (m_request.unit.isEmpty() ? QString() : QChar(0x00A0) + m_request.unit);
    };
    if (m_request.kind != EntryKind::Number) return {};
    if (m_request.minimum && m_request.maximum)
        return words(SystemText::Between).arg(text(*m_request.minimum), text(*m_request.maximum));
    if (m_request.minimum) return words(SystemText::AtLeast).arg(text(*m_request.minimum));
    if (m_request.maximum) return words(SystemText::AtMost).arg(text(*m_request.maximum));
    return m_request.unit;
}

void Keypad::addCommands(QGridLayout* grid, int row, int columns) {
    auto* cancel = key(words(SystemText::Cancel));
    auto* ok = key(words(SystemText::Ok), true);
    connect(cancel, &QPushButton::clicked, this, [this] {
        emit cancelled();
        close();
    });
    connect(ok, &QPushButton::clicked, this, &Keypad::accept);
    const bool mirrored = hmi::isRightToLeft(m_look.tag);
    grid->addWidget(mirrored ? ok : cancel, row, 0, 1, columns / 2);
    grid->addWidget(mirrored ? cancel : ok, row, columns / 2, 1, columns - columns / 2);
}

void Keypad::addNumberKeys(QGridLayout* grid) {
    const QLocale locale = localeOf(m_look.tag);
    const auto add = [&](const QString& text, int row, int column, int width = 1) {
        auto* button = key(text);
        button->setMinimumSize(64, 52);
        connect(button, &QPushButton::clicked, this, [this, text] { type(text); });
        grid->addWidget(button, row, column, 1, width);
    };
    for (int digit = 1; digit <= 9; ++digit) add(locale.toString(digit), 2 - (digit - 1) / 3, (digit - 1) % 3);
    add(locale.zeroDigit(), 3, 1);
    if (m_request.kind == EntryKind::Number) {
        add(QStringLiteral("±"), 3, 0);
        add(QString(locale.decimalPoint()), 3, 2);
    }
    add(QStringLiteral("⌫"), 0, 3);
    add(QStringLiteral("C"), 1, 3);
    addCommands(grid, 4, 4);
}

void Keypad::addLetterKeys(QGridLayout* grid) {
    // Letters of the language that the Latin rows do not have come below them.
    const QStringList latin{QStringLiteral("1234567890"), QStringLiteral("qwertyuiop"), QStringLiteral("asdfghjkl-"),
                            QStringLiteral("zxcvbnm_./"), moreLetters(m_look.tag)};
    const QStringList own = letterRows(m_look.tag);
    for (int row = 0; row < latin.size(); ++row) addKeys(grid, row, latin[row], own.isEmpty() || row == 0);
    for (int row = 0; row < own.size(); ++row) addKeys(grid, row + 1, own[row], true);
    constexpr int below = 5;
    auto* shift = key(QStringLiteral("⇧"));
    connect(shift, &QPushButton::clicked, this, [this] {
        m_shift = !m_shift;
        for (QPushButton* letter : m_letters)
            if (letter->text() != QStringLiteral("ß"))
                letter->setText(m_shift ? letter->text().toUpper() : letter->text().toLower());
    });
    auto* space = key(QStringLiteral("␣"));
    connect(space, &QPushButton::clicked, this, [this] { type(QStringLiteral(" ")); });
    auto* back = key(QStringLiteral("⌫"));
    connect(back, &QPushButton::clicked, this, [this] { type(QStringLiteral("⌫")); });
    grid->addWidget(shift, below, 0, 1, 2);
    grid->addWidget(space, below, 2, 1, own.isEmpty() ? 6 : 4);
    if (!own.isEmpty()) {
        auto* script = key(QStringLiteral("ABC"));
        script->setObjectName(QStringLiteral("script"));
        connect(script, &QPushButton::clicked, this, [this, script, name = own[1].left(3)] {
            for (QPushButton* letter : m_letters) letter->setVisible(letter->isHidden());
            script->setText(script->text() == QStringLiteral("ABC") ? name : QStringLiteral("ABC"));
        });
        grid->addWidget(script, below, 6, 1, 2);
    }
    grid->addWidget(back, below, 8, 1, 2);
    addCommands(grid, below + 1, 10);
}

void Keypad::addKeys(QGridLayout* grid, int row, const QString& letters, bool isShown) {
    for (int column = 0; column < letters.size(); ++column) {
        auto* button = key(QString(letters[column]));
        if (row > 0) {
            m_letters.push_back(button);
            button->setVisible(isShown);
        }
        connect(button, &QPushButton::clicked, this, [this, button] { type(button->text()); });
        grid->addWidget(button, row, column);
    }
}

QString Keypad::entered() const { return m_edit->text(); }

QString Keypad::complaint() const { return m_hint->text(); }

void Keypad::complain(const QString& text) {
    m_wasRefused = m_request.kind == EntryKind::Number; // a mask that is not full is filled
    m_hint->setText(text);
    m_hint->setStyleSheet(QStringLiteral("color: %1; font-weight: bold;").arg(m_look.theme.color("alarm").name()));
}

void Keypad::type(const QString& text) {
    QString now = m_edit->text();
    const bool isFirst = std::exchange(m_untouched, false);
    const bool replaces = std::exchange(m_wasRefused, false) || isFirst;
    if (text == QStringLiteral("⌫"))
        now = isFirst ? QString() : now.chopped(std::min<qsizetype>(1, now.size()));
    else if (text == QStringLiteral("C")) {
        // On the letters' keyboard C is a letter.
        now = m_letters.empty() ? QString() : (replaces ? text : now + text);
    } else if (text == QStringLiteral("±"))
        now = now.startsWith(u'-') ? now.mid(1) : u'-' + now;
    else
        now = replaces ? text : now + text;
    if (m_request.maxLength > 0) now = now.left(m_request.maxLength);
    if (m_request.kind == EntryKind::Masked && !m_request.mask.isEmpty()) now = now.left(m_request.mask.size());
    m_edit->setText(now);
    m_hint->setStyleSheet({});
    m_hint->setText(limitsText());
}

std::optional<double> Keypad::number() const {
    // Digits of any script and either decimal sign: a keyboard may give other ones than the keys here.
    const QString point = localeOf(m_look.tag).decimalPoint();
    QString plain;
    for (const QChar c : m_edit->text().trimmed()) {
        if (c.isDigit())
            plain += QChar(u'0' + c.digitValue());
        else if (c == point)
            plain += u'.';
        else if (!c.isPrint() || c.isSpace())
            continue; // marks of direction
        else
            plain += c;
    }
    bool ok = false;
    const double value = QLocale::c().toDouble(plain, &ok);
    if (!ok) return {};
    return value;
}

void Keypad::accept() {
    if (m_request.kind == EntryKind::Number) {
        const std::optional<double> value = number();
        if (!value) return complain(words(SystemText::NotANumber));
        if ((m_request.minimum && *value < *m_request.minimum - 1e-9) ||
            (m_request.maximum && *value > *m_request.maximum + 1e-9))
            return complain(limitsText());
        const double raw = (*value - m_request.offset) / m_request.factor;
        const bool whole = m_request.valueKind == ValueKind::Integer || m_request.valueKind == ValueKind::Unsigned;
        emit accepted(m_request, m_request.valueKind == ValueKind::Time
                                     ? Value::ofInstant(ValueKind::Time, Value::ofReal(raw * 1e9).toInteger())
                                 : whole ? Value::ofInteger(Value::ofReal(raw).toInteger())
                                         : Value::ofReal(raw));
        close();
        return;
    }
    const QString text = m_edit->text();
    if (m_request.kind == EntryKind::Masked) {
        for (qsizetype i = 0; i < m_request.mask.size(); ++i) {
            const QChar want = m_request.mask[i], have = i < text.size() ? text[i] : QChar();
            if ((want == u'#' && !have.isDigit()) || (want == u'A' && !have.isLetter()) ||
                (want == u'*' && have.isNull()))
                return complain(m_request.mask);
        }
        const bool isText = m_request.valueKind == ValueKind::Text;
        emit accepted(m_request, isText ? Value::ofText(text) : Value::ofInteger(text.toLongLong()));
    } else {
        emit accepted(m_request, Value::ofText(text));
    }
    close();
}

void Keypad::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return accept();
    case Qt::Key_Backspace:
        return type(QStringLiteral("⌫"));
    case Qt::Key_Escape:
        return Overlay::keyPressEvent(event);
    default:
        break;
    }
    const QString text = event->text();
    if (text.isEmpty() || !text[0].isPrint()) return Overlay::keyPressEvent(event);
    if (m_request.kind == EntryKind::Number && text == QStringLiteral("-")) return type(QStringLiteral("±"));
    if (m_request.kind == EntryKind::Number && !text[0].isDigit() &&
        text != QString(localeOf(m_look.tag).decimalPoint()) && text != QStringLiteral(".") &&
        text != QStringLiteral("e"))
        return;
    type(text);
}

// ---- list

ChoiceList::ChoiceList(const ChoiceRequest& request, const OverlayLook& look, QWidget* parent) : Overlay(look, parent) {
    auto* layout = new QVBoxLayout(box());
    layout->setContentsMargins(10, 10, 10, 10);
    m_area = new QScrollArea(box());
    m_area->setWidgetResizable(true);
    m_area->setFocusPolicy(Qt::NoFocus);
    auto* list = new QWidget(m_area);
    auto* rows = new QVBoxLayout(list);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    for (int i = 0; i < request.texts.size(); ++i) {
        auto* row = choice(request.texts[i], i == request.present);
        row->installEventFilter(this);
        row->setMinimumWidth(220);
        connect(row, &QPushButton::clicked, this, [this, request, i] {
            emit chosen(request, i);
            close();
        });
        rows->addWidget(row);
    }
    m_area->setWidget(list);
    const int wanted = static_cast<int>(request.texts.size()) * 52 + 4;
    m_area->setMinimumHeight(std::min(wanted, parent->height() - 60));
    m_area->setMinimumWidth(std::max(list->sizeHint().width(), 220) + 16);
    layout->addWidget(m_area);
    place();
    const QLayoutItem* first = rows->itemAt(std::clamp(request.present, 0, std::max(0, rows->count() - 1)));
    if (first) first->widget()->setFocus();
}

bool ChoiceList::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn)
        if (auto* row = qobject_cast<QPushButton*>(watched)) m_area->ensureWidgetVisible(row);
    return Overlay::eventFilter(watched, event);
}

// ---- question

Question::Question(const ConfirmRequest& request, const OverlayLook& look, QWidget* parent) : Overlay(look, parent) {
    auto* layout = new QVBoxLayout(box());
    layout->setContentsMargins(20, 18, 20, 16);
    layout->setSpacing(16);
    auto* text = new QLabel(request.question, box());
    text->setWordWrap(true);
    text->setMinimumWidth(std::min(360, parent->width() - 80));
    layout->addWidget(text);
    auto* row = new QHBoxLayout;
    auto* no = choice(words(SystemText::No));
    auto* yes = choice(words(SystemText::Yes), true);
    connect(no, &QPushButton::clicked, this, [this] {
        emit cancelled();
        close();
    });
    connect(yes, &QPushButton::clicked, this, [this, write = request.write] {
        emit confirmed(write);
        close();
    });
    row->addWidget(no);
    row->addWidget(yes);
    layout->addLayout(row);
    place();
    no->setFocus(); // a key pressed too often confirms nothing
}

} // namespace plc::hmi
