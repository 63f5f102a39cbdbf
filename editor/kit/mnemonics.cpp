#include "editor/kit/mnemonics.h"

#include "editor/kit/kept_translator.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace plc::kit {

namespace {

constexpr int kLetters = 36; // A to Z, 0 to 9

std::optional<int> letterOf(QChar c) {
    const char16_t code = c.toUpper().unicode();
    if (code >= u'A' && code <= u'Z') return code - u'A';
    if (code >= u'0' && code <= u'9') return 26 + code - u'0';
    return std::nullopt;
}

char16_t characterOf(int letter) { return static_cast<char16_t>(letter < 26 ? u'A' + letter : u'0' + letter - 26); }

bool isChinese(const QString& text) {
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.script() == QChar::Script_Han; });
}

/// Where the letter of a text stands that is written with &; && is an ampersand.
qsizetype markOf(const QString& text) {
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != u'&') continue;
        if (text[i + 1] != u'&') return i;
        ++i;
    }
    return -1;
}

void append(std::vector<int>& letters, QChar c) {
    const std::optional<int> letter = letterOf(c);
    if (letter && std::find(letters.begin(), letters.end(), *letter) == letters.end()) letters.push_back(*letter);
}

/// The letters that a text can have, the best first: those that start its words, then the others.
std::vector<int> lettersIn(const QString& text) {
    std::vector<int> out;
    for (qsizetype i = 0; i < text.size(); ++i)
        if (i == 0 || !text[i - 1].isLetterOrNumber()) append(out, text[i]);
    for (const QChar c : text) append(out, c);
    return out;
}

std::vector<int> candidates(const QString& text, const QString& hint) {
    if (!isChinese(text)) return lettersIn(text);
    const QString english = KeptTranslator::sourceOf(text);
    std::vector<int> out = lettersIn(english.isEmpty() ? hint : withoutMnemonic(english));
    for (int letter = 0; letter < 26; ++letter) append(out, characterOf(letter));
    return out;
}

/// One letter for as many texts as possible: a text may push another to the next of its letters.
class Matching {
public:
    explicit Matching(const std::vector<std::vector<int>>& wanted) : m_wanted(wanted) { m_owner.fill(-1); }
    void block(int letter) { m_blocked[static_cast<size_t>(letter)] = true; }
    std::vector<int> find() {
        for (size_t text = 0; text < m_wanted.size(); ++text) {
            m_seen = m_blocked;
            (void)(takeFree(text) || push(text));
        }
        std::vector<int> out(m_wanted.size(), -1);
        for (int letter = 0; letter < kLetters; ++letter)
            if (const int owner = m_owner[static_cast<size_t>(letter)]; owner >= 0)
                out[static_cast<size_t>(owner)] = letter;
        return out;
    }

private:
    bool takeFree(size_t text) {
        for (const int letter : m_wanted[text]) {
            const auto at = static_cast<size_t>(letter);
            if (m_blocked[at] || m_owner[at] >= 0) continue;
            m_owner[at] = static_cast<int>(text);
            return true;
        }
        return false;
    }
    bool push(size_t text) {
        for (const int letter : m_wanted[text]) {
            const auto at = static_cast<size_t>(letter);
            if (m_seen[at]) continue;
            m_seen[at] = true;
            if (m_owner[at] >= 0 && !push(static_cast<size_t>(m_owner[at]))) continue;
            m_owner[at] = static_cast<int>(text);
            return true;
        }
        return false;
    }
    const std::vector<std::vector<int>>& m_wanted;
    std::array<int, kLetters> m_owner{};
    std::array<bool, kLetters> m_blocked{}, m_seen{};
};

QString marked(QString text, int letter) {
    if (letter < 0) return text;
    const QChar wanted(characterOf(letter));
    if (isChinese(text)) {
        const QString behind = QStringLiteral("…:："); // the letter: "名称(N)："
        const qsizetype end = !text.isEmpty() && behind.contains(text.back()) ? text.size() - 1 : text.size();
        return text.insert(end, QStringLiteral("(&%1)").arg(wanted));
    }
    qsizetype best = -1;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i].toUpper() != wanted) continue;
        const bool startsWord = i == 0 || !text[i - 1].isLetterOrNumber();
        if (best < 0 || startsWord) best = i;
        if (startsWord) break;
    }
    return best < 0 ? text : text.insert(best, u'&');
}

/// Something with a text that can have a letter.
struct Holder {
    QString text, hint;
    std::function<void(const QString&)> setText;
};

void give(const std::vector<Holder>& holders) {
    QStringList texts, hints;
    for (const Holder& holder : holders) texts << holder.text, hints << holder.hint;
    const QStringList marks = withMnemonics(texts, hints);
    for (size_t i = 0; i < holders.size(); ++i)
        if (const QString& text = marks[static_cast<qsizetype>(i)]; text != holders[i].text) holders[i].setText(text);
}

std::vector<Holder> entriesOf(const QWidget& menu) {
    std::vector<Holder> out;
    for (QAction* action : menu.actions())
        if (!action->isSeparator() && !action->text().isEmpty())
            out.push_back({action->text(), action->objectName().section(u'.', -1),
                           [action](const QString& text) { action->setText(text); }});
    return out;
}

std::vector<Holder> tabsOf(QTabBar& bar) {
    std::vector<Holder> out;
    for (int tab = 0; tab < bar.count(); ++tab)
        out.push_back({bar.tabText(tab), {}, [&bar, tab](const QString& text) { bar.setTabText(tab, text); }});
    return out;
}

std::vector<Holder> partsOf(QWidget& dialog) {
    std::vector<Holder> out;
    for (QWidget* part : dialog.findChildren<QWidget*>()) {
        if (auto* bar = qobject_cast<QTabBar*>(part))
            for (Holder& tab : tabsOf(*bar)) out.push_back(std::move(tab));
        if (auto* button = qobject_cast<QAbstractButton*>(part);
            button && !button->text().isEmpty() && !qobject_cast<QToolButton*>(part))
            out.push_back({button->text(), button->objectName(), [button](const QString& t) { button->setText(t); }});
        if (auto* label = qobject_cast<QLabel*>(part); label && label->buddy() && !label->text().isEmpty())
            out.push_back(
                {label->text(), label->buddy()->objectName(), [label](const QString& t) { label->setText(t); }});
    }
    return out;
}

/// Tab goes to the next field also from a table or a text in a dialog, else nobody without a mouse gets out of it.
void letTabLeave(QDialog& dialog) {
    for (QTableView* table : dialog.findChildren<QTableView*>()) table->setTabKeyNavigation(false);
    for (QPlainTextEdit* text : dialog.findChildren<QPlainTextEdit*>()) text->setTabChangesFocus(true);
}

class Keeper : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() == QEvent::ActionAdded && !object->property(kKnown).toBool())
            if (auto* menu = qobject_cast<QMenu*>(object)) keep(*menu);
        if (event->type() == QEvent::Show)
            if (auto* dialog = qobject_cast<QDialog*>(object)) {
                giveMnemonics(*dialog);
                letTabLeave(*dialog);
            }
        return false;
    }

private:
    static constexpr const char* kKnown = "plc_mnemonics";
    static void keep(QMenu& menu) {
        menu.setProperty(kKnown, true);
        connect(&menu, &QMenu::aboutToShow, &menu, [&menu] { giveMnemonics(menu); });
    }
};

} // namespace

QStringList withMnemonics(const QStringList& texts, const QStringList& hints) {
    std::vector<std::vector<int>> wanted(static_cast<size_t>(texts.size()));
    std::vector<std::optional<int>> written(wanted.size());
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const auto at = static_cast<size_t>(i);
        if (const qsizetype mark = markOf(texts[i]); mark >= 0) written[at] = letterOf(texts[i][mark + 1]);
        const bool isFirst = std::find(written.begin(), written.begin() + i, written[at]) == written.begin() + i;
        if (written[at] && !isFirst) written[at].reset(); // another letter for the second
        if (!written[at]) wanted[at] = candidates(withoutMnemonic(texts[i]), hints.value(i));
    }
    Matching matching(wanted);
    for (const std::optional<int>& letter : written)
        if (letter) matching.block(*letter);
    const std::vector<int> letters = matching.find();
    QStringList out;
    for (qsizetype i = 0; i < texts.size(); ++i) {
        const auto at = static_cast<size_t>(i);
        out << (written[at] ? texts[i] : marked(withoutMnemonic(texts[i]), letters[at]));
    }
    return out;
}

QString withoutMnemonic(const QString& text) {
    static const QRegularExpression appended(QStringLiteral("\\(&\\w\\)"));
    QString out = text;
    out.remove(appended);
    for (qsizetype at = 0; (at = out.indexOf(u'&', at)) >= 0; ++at)
        if (at + 1 < out.size() && out[at + 1] != u'&')
            out.remove(at--, 1);
        else
            ++at;
    return out;
}

void giveMnemonics(QWidget& of) {
    const bool isMenu = qobject_cast<QMenu*>(&of) || qobject_cast<QMenuBar*>(&of);
    give(isMenu ? entriesOf(of) : partsOf(of));
}

void keepMnemonics(QApplication& application) {
    if (application.findChild<QObject*>(QStringLiteral("mnemonics"))) return;
    auto* keeper = new Keeper(&application);
    keeper->setObjectName(QStringLiteral("mnemonics"));
    application.installEventFilter(keeper);
}

} // namespace plc::kit
