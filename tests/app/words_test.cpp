// The studio in a language whose every letter has an accent: a plain letter on any window, menu or dialog is a text
// that nobody can translate.
#include "editor/kit/mnemonics.h"
#include "tests/app/all_windows.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTabBar>
#include <QTranslator>

#include <set>

namespace plc::app {
namespace {

/// Answers every text with its own letters accented, so that what did not pass here shows in plain ones. Places
/// (%1, %n, {0}), markup and the marks of choices stay.
class PseudoTranslator final : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        static const QRegularExpression kept(
            QStringLiteral("%L?\\d+|%n|\\{\\d(:|\\})|<[^>]*>|&\\w+;|\\*\\.\\w+(\\.\\w+)*|;;"));
        const QString text = QString::fromUtf8(source);
        QString out;
        qsizetype from = 0;
        for (auto hit = kept.globalMatch(text); hit.hasNext();) {
            const QRegularExpressionMatch match = hit.next();
            out += accented(text.mid(from, match.capturedStart() - from)) + match.captured();
            from = match.capturedEnd();
        }
        return out + accented(text.mid(from));
    }

private:
    static QString accented(QString text) {
        const QString plain = QStringLiteral("AEIOUaeiouBCDFGHJKLMNPQRSTVWXYZbcdfghjklmnpqrstvwxyz");
        const QString marked = QStringLiteral("ÀÉÎÕÛàéîõûƁÇÐƑĜĤĴĶĻṀŃƤǪŔŠŢṼŴẊÝŽƀçðƒĝĥĵķļṁńƥǫŕšţṽŵẋýž");
        for (QChar& c : text)
            if (const qsizetype at = plain.indexOf(c); at >= 0) c = marked[at];
        return text;
    }
};

void add(QStringList& out, const QString& text) {
    if (!text.isEmpty()) out << text;
}

QStringList cellsOf(const QAbstractItemModel& model, const QModelIndex& parent = {}) {
    QStringList out;
    for (int row = 0; row < std::min(model.rowCount(parent), 200); ++row)
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex index = model.index(row, column, parent);
            add(out, index.data(Qt::DisplayRole).toString());
            add(out, index.data(Qt::ToolTipRole).toString());
            if (column == 0) out << cellsOf(model, index);
        }
    return out;
}

/// Lists whose texts come from files: the comments of libraries, values, the panel's own texts.
bool isOfTheProject(const QWidget& widget) {
    for (const QWidget* each = &widget; each; each = each->parentWidget())
        if (each->inherits("plc::app::ProjectTree")) return true;
    return widget.inherits("plc::hmi::Outline");
}

/// What a widget shows or says of itself, without what was typed.
QStringList textsOf(const QWidget& widget) {
    QStringList out;
    if (widget.isWindow()) add(out, widget.windowTitle());
    for (const QString& text : {widget.toolTip(), widget.whatsThis(), widget.accessibleName()}) add(out, text);
    if (auto* label = qobject_cast<const QLabel*>(&widget)) add(out, label->text());
    if (auto* button = qobject_cast<const QAbstractButton*>(&widget)) add(out, button->text());
    if (auto* group = qobject_cast<const QGroupBox*>(&widget)) add(out, group->title());
    if (auto* line = qobject_cast<const QLineEdit*>(&widget)) add(out, line->placeholderText());
    if (auto* combo = qobject_cast<const QComboBox*>(&widget))
        for (int i = 0; i < combo->count(); ++i) add(out, combo->itemText(i));
    if (auto* bar = qobject_cast<const QTabBar*>(&widget))
        for (int i = 0; i < bar->count(); ++i) add(out, bar->tabText(i)), add(out, bar->tabToolTip(i));
    if (isOfTheProject(widget)) return out;
    if (auto* view = qobject_cast<const QAbstractItemView*>(&widget); view && view->model()) {
        out << cellsOf(*view->model());
        for (int i = 0; i < view->model()->columnCount(); ++i)
            add(out, view->model()->headerData(i, Qt::Horizontal).toString());
    }
    for (const QAction* action : widget.actions()) add(out, action->text()), add(out, action->toolTip());
    return out;
}

/// Names of the project, words of the languages, units and keys: the same in every language.
bool isData(const QString& word) {
    static const std::set<QString> words{
        "Windows",  "Stepwise", "English", "Deutsch", "Dansk",  "Main",     "Motor",  "Steps", "Rungs",   "counter",
        "limit",    "done",     "pulse",   "motor",   "run",    "turns",    "drive",  "Ready", "Work",    "Turn",
        "first",    "Test",     "main",    "steps",   "rungs",  "project",  "src",    "tests", "hmi",     "all",
        "Fault",    "Hot",      "State",   "fault",   "hot",    "standard", "st",     "rec",   "json",    "csv",
        "png",      "jpg",      "svg",     "pdf",     "trace",  "panel",    "xml",    "px",    "ms",      "ns",
        "MB",       "kB",       "bit",     "Ctrl",    "Shift",  "Alt",      "analog", "plant", "toolbox", "util",
        "workshop", "library",  "Aa",      "en",      "go",     "on",       "off",    "Off",   "begin",   "running",
        "text",     "pou",      "Button",  "Valve",   "Option", "Text",     "qps",    "ploc",  "red",     "yellow",
        "green",    "Broker",   "Count",   "Done",    "Line",   "anna",     "Latin"};
    if (words.contains(word)) return true;
    static const QRegularExpression capitals(QStringLiteral("^[A-Z]+[0-9]*$")); // TON, BOOL, RUN
    return capitals.match(word).hasMatch();
}

/// Quoted texts are the operators' or words of a file, a path holds names of folders, a place that of a file.
QString withoutData(QString text) {
    static const QRegularExpression data(
        QStringLiteral("\"[^\"]*\"|“[^”]*”|<[^>]*>|\\S*/\\S*|test_app\\S*|devices\\.json:\\S*"));
    return text.remove(data);
}

QStringList plainWordsIn(const QString& text) {
    static const QRegularExpression word(QStringLiteral("(?<![\\p{L}\\d_/.#@])[A-Za-z]{2,}(?![\\p{L}\\d_])"));
    QStringList out;
    for (auto hit = word.globalMatch(withoutData(kit::withoutMnemonic(text))); hit.hasNext();)
        if (const QString found = hit.next().captured(); !isData(found)) out << found;
    return out;
}

using WordsTest = AllWindowsTest;

TEST_F(WordsTest, EveryTextOfEveryWindowIsTranslated) {
    PseudoTranslator pseudo;
    QApplication::installTranslator(&pseudo);
    open();
    std::map<QString, QString> plain; // text → window
    size_t seen = 0;
    lookAtAll([&](QWidget& shown, const QString& name) {
        for (const QWidget* widget : widgetsOf(shown)) {
            const bool isList = widget->inherits("QComboBox") || widget->inherits("QComboBoxListView");
            if (isList && name == "add a language") continue; // each by its own name
            for (const QString& text : textsOf(*widget)) {
                ++seen;
                if (!plainWordsIn(text).isEmpty())
                    plain.emplace(text,
                                  name + " (" + widget->metaObject()->className() + ' ' + widget->objectName() + ')');
            }
        }
    });
    for (const auto& [text, name] : plain)
        ADD_FAILURE() << name.toStdString() << ": “" << text.toStdString()
                      << "” is not translated: " << plainWordsIn(text).join(", ").toStdString();
    EXPECT_GT(seen, 5000u);
    window.reset();
    QApplication::removeTranslator(&pseudo);
}

} // namespace
} // namespace plc::app
