#include "hmi/designer/editors/theme_dialog.h"

#include "editor/kit/icons.h"
#include "editor/kit/inputs/complaint.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/message_text.h"
#include "editor/kit/trash.h"
#include "hmi/designer/editors/edit_bar.h"
#include "hmi/designer/sheet/choice_titles.h"
#include "runtime/base/messages.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::hmi {

namespace {

constexpr QLatin1String kBase("base");
constexpr int kShownWeaknesses = 3;

/// The roles in groups, each under the heading of its first one.
struct Group {
    const char* first; // role
    const char* heading;
};
constexpr Group kGroups[] = {
    {"background", QT_TRANSLATE_NOOP("plc::hmi::ThemeDialog", "Grounds, lines and texts")},
    {"off", QT_TRANSLATE_NOOP("plc::hmi::ThemeDialog", "Process")},
    {"alarm", QT_TRANSLATE_NOOP("plc::hmi::ThemeDialog", "Alarms")},
    {"red", QT_TRANSLATE_NOOP("plc::hmi::ThemeDialog", "Colours by name")},
    {"series1", QT_TRANSLATE_NOOP("plc::hmi::ThemeDialog", "Curves")},
};

std::vector<kit::PropertyDescriptor> rowsOf(const PanelTheme& base) {
    std::vector<kit::PropertyDescriptor> out;
    QString group;
    kit::PropertyDescriptor first;
    first.id = kBase;
    first.label = ThemeDialog::tr("Based on");
    first.toolTip = ThemeDialog::tr("Colours that this theme does not change are those of the base.");
    first.kind = kit::PropertyKind::Enumeration;
    for (const QString& name : PanelTheme::builtIn())
        first.choices.push_back({name, choiceTitle("theme", name.toStdString()), {}});
    for (const QString& role : PanelTheme::roles()) {
        for (const Group& each : kGroups)
            if (role == QLatin1String(each.first)) group = ThemeDialog::tr(each.heading);
        if (out.empty()) {
            first.group = group;
            out.push_back(first);
        }
        kit::PropertyDescriptor row;
        row.id = role;
        row.label = roleTitle(role);
        row.group = group;
        row.kind = kit::PropertyKind::Color;
        row.canBeNone = false;
        row.defaultValue = base.color(role);
        out.push_back(row);
    }
    return out;
}

bool isSameName(const QString& a, const QString& b) { return a.compare(b, Qt::CaseInsensitive) == 0; }

} // namespace

ThemeDialog::ThemeDialog(DesignContext& context, const QString& panel, const QString& theme, QWidget* parent)
    : QDialog(parent), m_context(context), m_choice(new QComboBox), m_grid(new kit::PropertyGrid),
      m_preview(new PanelView), m_weak(new QLabel), m_complaint(new kit::Complaint(this)) {
    setWindowTitle(tr("Panel Themes"));
    const PanelProject& project = context.project();
    PanelScene& scene = m_preview->scene();
    scene.setDesigning(true);
    scene.setTexts(&project.texts);
    scene.setFaceplates(project.panelLookup());
    scene.setLanguage(context.language());
    scene.setFolder(project.folder);
    scene.setPicturesOutside(project.picturesOutside);
    const Panel* seen = context.panelNow(panel.isEmpty() ? project.startOrFirst() : panel);
    m_preview->setVisible(seen);
    if (seen) scene.setPanel(*seen);
    m_preview->setAccessibleName(tr("Preview"));
    m_preview->setMinimumSize(280, 200);
    m_weak->setWordWrap(true);
    m_weak->setTextFormat(Qt::PlainText);

    auto* beside = new QWidget;
    auto* column = new QVBoxLayout(beside);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_preview, 1);
    if (!seen) column->addStretch(1);
    column->addWidget(m_weak);
    auto* splitter = new QSplitter;
    splitter->addWidget(m_grid);
    splitter->addWidget(beside);
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 3);
    splitter->setChildrenCollapsible(false);
    splitter->setSizes({340, 520}); // names and colours are read without a scroll bar
    m_grid->setAccessibleName(tr("Colours"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &ThemeDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ThemeDialog::reject);

    auto* layout = new QVBoxLayout(this);
    makeBar();
    layout->addWidget(splitter, 1);
    layout->addWidget(m_complaint);
    layout->addWidget(buttons);
    resize(860, 560);

    connect(m_grid, &kit::PropertyGrid::previewed, this,
            [this](const QString& id, const QVariant& value) { showInPreview(with(id, value)); });
    connect(m_grid, &kit::PropertyGrid::previewWithdrawn, this, [this] { showInPreview(shown()); });
    const auto commit = [this](const QString& id, const QVariant& value) {
        changeTheme(id == kBase ? tr("Base of the Theme") : roleTitle(id), with(id, value));
    };
    connect(m_grid, &kit::PropertyGrid::committed, this, commit);
    connect(m_grid, &kit::PropertyGrid::resetRequested, this, [commit](const QString& id) { commit(id, QColor()); });
    connect(m_choice, &QComboBox::activated, this, [this] { showState({m_state.themes, m_choice->currentText()}); });
    connect(&m_context, &DesignContext::themesTaken, this, &ThemeDialog::takeFromDisk);

    State begin;
    for (const auto& [name, own] : project.themes.own()) {
        m_onDisk.emplace(name, *own);
        begin.themes.emplace(name, Edited{name, *own});
    }
    const QString wanted = theme.isEmpty() && seen ? seen->text("theme") : theme;
    begin.shown = begin.themes.contains(wanted) ? wanted
                  : begin.themes.empty()        ? QString()
                                                : begin.themes.begin()->first;
    showState(std::move(begin));
}

void ThemeDialog::makeBar() {
    QToolBar* bar = makeEditBar(m_undo, this);
    m_choice->setAccessibleName(tr("Theme"));
    m_choice->setToolTip(tr("Theme"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_choice->setMinimumContentsLength(14);
    bar->addWidget(m_choice);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addAction(kit::icon(kit::Icon::Add), tr("New…"), this,
                   [this] { askForName(tr("New Theme"), QString(), &ThemeDialog::add); });
    m_rename = bar->addAction(kit::icon(kit::Icon::Rename), tr("Rename…"), this,
                              [this] { askForName(tr("Rename Theme"), m_state.shown, &ThemeDialog::rename); });
    m_remove = bar->addAction(kit::icon(kit::Icon::Delete), tr("Delete"), this, &ThemeDialog::removeShown);
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, bar);
}

QString ThemeDialog::complaint() const { return m_complaint->text(); }
QString ThemeDialog::weaknesses() const { return m_weak->text(); }

QStringList ThemeDialog::names() const {
    QStringList out;
    for (const auto& [name, one] : m_state.themes) out += name;
    return out;
}

// ------------------------------------------------------------------ what is edited

void ThemeDialog::askForName(const QString& title, const QString& present,
                             QString (ThemeDialog::*take)(const QString&)) {
    kit::TextQuestion(
        title, tr("Name of the theme:"), present, [this, take](const QString& text) { return (this->*take)(text); },
        this)
        .ask();
}

QString ThemeDialog::whyNot(const QString& name) const {
    for (const QChar c : QStringLiteral("/\\:*?\"<>|"))
        if (name.contains(c)) return tr("A theme's name cannot contain %1; choose another name").arg(c);
    if (name.isEmpty() || name.startsWith(u'.')) return tr("A theme's name begins with a letter or a digit");
    const auto isTaken = [&](const QString& other) { return isSameName(name, other); };
    const bool isThere = std::ranges::any_of(PanelTheme::builtIn(), isTaken) || std::ranges::any_of(names(), isTaken);
    if (isThere) return tr("There is a theme %1 already; choose another name").arg(name);
    const QString path = m_context.project().themePath(name);
    if (QFileInfo::exists(path) && !m_onDisk.contains(name)) // it could not be read
        return tr("There is a file %1 already; choose another name").arg(m_context.project().placeOf(path));
    return {};
}

QString ThemeDialog::add(const QString& name) {
    if (const QString why = whyNot(name); !why.isEmpty()) return why;
    State after{m_state.themes, name};
    after.themes.emplace(name, Edited{{}, shown()});
    change(tr("New Theme"), std::move(after));
    return {};
}

QString ThemeDialog::rename(const QString& name) {
    if (name == m_state.shown) return {};
    if (const QString why = whyNot(name); !why.isEmpty()) return why;
    State after{m_state.themes, name};
    auto moved = after.themes.extract(m_state.shown);
    moved.key() = name;
    after.themes.insert(std::move(moved));
    change(tr("Rename Theme"), std::move(after));
    return {};
}

void ThemeDialog::removeShown() {
    const auto at = m_state.themes.find(m_state.shown);
    if (at == m_state.themes.end()) return;
    const QString origin = at->second.origin;
    if (const QStringList users = origin.isEmpty() ? QStringList() : m_context.panelsWithTheme(origin);
        !users.isEmpty())
        return m_complaint->say(
            tr("%1 is used on %2; choose another theme there before it is deleted").arg(origin, users.join(", ")),
            nullptr);
    State after = m_state;
    after.themes.erase(m_state.shown);
    after.shown = after.themes.empty() ? QString() : after.themes.begin()->first;
    change(tr("Delete Theme"), std::move(after));
}

void ThemeDialog::change(const QString& title, State after) {
    m_undo.push(new kit::ClosureCommand(
        title, [this, after = std::move(after)] { showState(after); },
        [this, before = m_state] { showState(before); }));
}

void ThemeDialog::changeTheme(const QString& title, const PanelTheme& theme) {
    const auto at = m_state.themes.find(m_state.shown);
    if (at == m_state.themes.end() || at->second.theme == theme)
        return showState(m_state); // as it was before a preview
    State after = m_state;
    after.themes.at(m_state.shown).theme = theme;
    change(title, std::move(after));
}

PanelTheme ThemeDialog::with(const QString& id, const QVariant& value) const {
    PanelTheme out = shown();
    if (id == kBase)
        out.setBase(PanelTheme::named(value.toString()).kind());
    else
        out.setColor(id, value.value<QColor>());
    return out;
}

const PanelTheme& ThemeDialog::shown() const {
    const auto at = m_state.themes.find(m_state.shown);
    return at == m_state.themes.end() ? m_preview->scene().theme() : at->second.theme;
}

// ------------------------------------------------------------------ what is shown

void ThemeDialog::showState(State state) {
    m_state = std::move(state);
    m_complaint->say({}, nullptr);
    m_choice->clear();
    m_choice->addItems(names());
    m_choice->setCurrentText(m_state.shown);
    const bool isAny = !m_state.themes.empty();
    m_choice->setEnabled(isAny);
    m_rename->setEnabled(isAny);
    m_remove->setEnabled(isAny);
    m_grid->setEnabled(isAny);
    const PanelTheme theme = shown();
    m_grid->setDescriptors(rowsOf(PanelTheme::of(theme.kind())));
    std::map<QString, QVariant> values{{kBase, PanelTheme::builtIn()[static_cast<qsizetype>(theme.kind())]}};
    for (const QString& role : PanelTheme::roles()) values[role] = theme.color(role);
    m_grid->setValues(values);
    showInPreview(theme);
}

void ThemeDialog::showInPreview(const PanelTheme& theme) {
    if (m_state.themes.empty()) {
        m_preview->scene().setTheme({});
        m_weak->setText(
            tr("The project has no theme of its own yet. New… makes one that begins with the colours shown."));
        return;
    }
    PanelThemes themes = m_context.project().themes;
    themes.set(m_state.shown, theme);
    m_preview->scene().setThemes(themes);
    m_preview->scene().setTheme(m_state.shown);
    m_preview->update();
    QStringList lines;
    const std::vector<PanelTheme::Weak> found = theme.weaknesses();
    for (const PanelTheme::Weak& weak : found) {
        if (lines.size() == kShownWeaknesses) {
            lines += tr("and %n more", nullptr, static_cast<int>(found.size()) - kShownWeaknesses);
            break;
        }
        lines += tr("%1 on %2: contrast %L3, %L4 is needed")
                     .arg(roleTitle(weak.ink), roleTitle(weak.ground))
                     .arg(weak.contrast, 0, 'f', 1)
                     .arg(weak.needed);
    }
    m_weak->setText(lines.join(u'\n'));
}

// ------------------------------------------------------------------ disk

/// Another program wrote themes: what is not changed here follows.
void ThemeDialog::takeFromDisk() {
    if (m_isWriting) return;
    std::map<QString, PanelTheme> now;
    for (const auto& [name, own] : m_context.project().themes.own()) now.emplace(name, *own);
    State after = m_state;
    QStringList both;
    const auto before = std::exchange(m_onDisk, now);
    for (const auto& [name, theme] : now) {
        const auto known = before.find(name);
        if (known != before.end() && known->second == theme) continue;
        const auto here =
            std::ranges::find_if(after.themes, [&](const auto& one) { return one.second.origin == name; });
        if (here == after.themes.end() && known == before.end() && !after.themes.contains(name))
            after.themes.emplace(name, Edited{name, theme});
        else if (here != after.themes.end() && known != before.end() && here->second.theme == known->second)
            here->second.theme = theme;
        else
            both += name;
    }
    const auto isGone = [&](const auto& one) {
        return !one.second.origin.isEmpty() && !now.contains(one.second.origin);
    };
    std::erase_if(after.themes, [&](const auto& one) { // deleted there, and nothing was changed here
        return isGone(one) && one.second.theme == before.at(one.second.origin);
    });
    for (auto& one : after.themes)
        if (isGone(one)) one.second.origin.clear();
    if (!after.themes.contains(after.shown))
        after.shown = after.themes.empty() ? QString() : after.themes.begin()->first;
    m_undo.clear(); // its steps are of other files
    showState(std::move(after));
    if (!both.isEmpty())
        m_complaint->say(tr("Changed on disk too: %1. OK replaces what is there.").arg(both.join(", ")), nullptr);
}

Result<void> ThemeDialog::write() {
    PanelProject& project = m_context.project();
    std::map<QString, QString> renamed;
    for (const auto& [name, one] : m_state.themes) {
        if (!one.origin.isEmpty() && one.origin != name) renamed.emplace(one.origin, name);
        const auto known = m_onDisk.find(name);
        if (known != m_onDisk.end() && known->second == one.theme) continue;
        if (auto saved = saveTheme(project, name, one.theme); !saved) return saved;
    }
    for (const auto& [name, theme] : m_onDisk) {
        if (m_state.themes.contains(name)) continue;
        const QString path = project.themePath(name);
        const bool isGone = renamed.contains(name) ? QFile::remove(path) : kit::removeToTrash(path);
        if (!isGone && QFileInfo::exists(path)) return Error{errors::FileNotRemoved(), toUtf8(path)};
        project.disk->forget(path);
    }
    if (!renamed.empty()) m_context.renameThemes(renamed);
    return {};
}

void ThemeDialog::accept() {
    m_isWriting = true;
    const Result<void> written = write();
    m_context.themesReplaced();
    m_isWriting = false;
    if (written) return QDialog::accept();
    m_onDisk.clear(); // some may have been written
    for (const auto& [name, own] : m_context.project().themes.own()) m_onDisk.emplace(name, *own);
    m_complaint->say(kit::messageText(written.error()), nullptr);
}

void ThemeDialog::reject() {
    if (!m_undo.isClean() && QMessageBox::question(this, windowTitle(), tr("Discard the changes of the themes?"),
                                                   QMessageBox::Discard | QMessageBox::Cancel) != QMessageBox::Discard)
        return;
    QDialog::reject();
}

} // namespace plc::hmi
