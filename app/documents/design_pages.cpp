#include "app/documents/design_pages.h"

#include "app/panels/text_page.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/message_text.h"
#include "hmi/designer/editors/alarm_editor.h"
#include "hmi/designer/editors/people_editor.h"
#include "hmi/designer/editors/recipe_editor.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/editors/theme_dialog.h"
#include "hmi/designer/panel_designer.h"
#include "projects/storage/project_file.h"

#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QTimer>

namespace plc::app {

namespace {
const QString kPanel = "panel:", kTheme = "theme:", kText = "text:";
constexpr int kLittle = 420; // pixels of height for a drawing with its lists around

QString keyOf(const QWidget* page) { return page->property("pageKey").toString(); }
} // namespace

DesignPages::DesignPages(Parts parts, QObject* parent) : QObject(parent), m_parts(parts) {}

bool DesignPages::isKey(const Key& key) {
    static const QStringList single{"texts", "alarms", "recipes", "people"};
    return key.startsWith(kPanel) || single.contains(key);
}

// ------------------------------------------------------------------ open

void DesignPages::open(const Key& key) {
    if (!m_parts.live.design()) return;
    // What is wrong with it can be put right in its text.
    const bool isBroken = key.startsWith(kPanel) ? !m_parts.live.panels().find(key.mid(kPanel.size())) : isUnread(key);
    if (isBroken) return openAsText(key);
    if (QWidget* page = m_parts.tabs.pageByKey(key)) return m_parts.tabs.setCurrentWidget(page);
    hmi::DesignContext& design = *m_parts.live.design();
    if (key.startsWith(kPanel))
        addDesigner(key);
    else if (key == "texts")
        addPage(new hmi::TextEditor(design, &m_parts.tabs), tr("Texts"), kit::Icon::Texts, key);
    else if (key == "alarms")
        addPage(new hmi::AlarmEditor(design, &m_parts.tabs), tr("Alarms"), kit::Icon::Alarm, key);
    else if (key == "recipes")
        addPage(new hmi::RecipeEditor(design, &m_parts.tabs), tr("Recipes"), kit::Icon::Table, key);
    else if (key == "people")
        addPage(new hmi::PeopleEditor(design, &m_parts.tabs), tr("Users and Rights"), kit::Icon::User, key);
}

void DesignPages::addPage(QWidget* page, const QString& title, kit::Icon icon, const Key& key) {
    // A closed page dies a moment later, perhaps after the project: it keeps what it works on, the panels last.
    connect(page, &QObject::destroyed, [panels = m_parts.live.sharedPanels(), design = m_parts.live.sharedDesign()] {
        (void)panels, (void)design;
    });
    m_parts.tabs.addPage(page, title, kit::icon(icon), key);
}

void DesignPages::addDesigner(const Key& key) {
    const QString panel = key.mid(kPanel.size());
    auto* designer = new hmi::PanelDesigner(*m_parts.live.design(), panel, &m_parts.tabs);
    addPage(designer, panel, kit::Icon::Panel, key);
    QTimer::singleShot(0, designer, [designer] { // once it has its size: the whole panel
        if (auto* fit = designer->findChild<QAction*>("zoom-fit")) fit->trigger();
    });
    if (m_parts.tabs.height() < kLittle) emit littleRoom();
    connect(designer, &hmi::PanelDesigner::panelRequested, this, &DesignPages::openPanel); // of a faceplate
    connect(designer, &hmi::PanelDesigner::modifiedChanged, &m_parts.tabs,
            [tabs = &m_parts.tabs, key](bool modified) { tabs->markPage(key, modified); });
    m_parts.tabs.markPage(key, m_parts.files.isChanged(key));
}

void DesignPages::openAsText(const Key& key) {
    const QString path = m_parts.files.pathOf(key);
    if (!QFile::exists(path)) return;
    EditorTabs& tabs = m_parts.tabs;
    if (QWidget* open = tabs.pageByKey(kText + key)) return tabs.setCurrentWidget(open);
    auto* page = new TextPage(path, &tabs);
    tabs.addPage(page, QFileInfo(path).fileName(), kit::icon(kit::Icon::Error), kText + key);
    connect(page, &TextPage::modifiedChanged, &tabs,
            [&tabs, key](bool modified) { tabs.markPage(kText + key, modified); });
    const auto showProblem = [this, page, path] {
        const PanelProblem problem = m_parts.findings.problemOf(m_parts.live.panels().placeOf(path));
        page->showProblem(problem.message, problem.line);
    };
    showProblem();
    page->setFocus();
    connect(page, &TextPage::saved, this, [this, page, key, showProblem] {
        m_parts.files.look();
        const bool isGood = m_parts.live.panels().disk->isKnown(m_parts.files.pathOf(key));
        if (!isGood || key.startsWith(kTheme)) return showProblem();
        m_parts.tabs.closePage(m_parts.tabs.indexOf(page)); // it can be opened as what it is
        open(key);
    });
}

bool DesignPages::isUnread(const Key& key) const {
    const QString path = m_parts.files.pathOf(key);
    return QFile::exists(path) && !m_parts.live.panels().disk->isKnown(path);
}

void DesignPages::openPlace(const QString& file, const QString& element) {
    if (file.startsWith("hmi/themes/")) return editThemes(QFileInfo(file).completeBaseName());
    if (file.endsWith(".csv")) return openTexts();
    if (file.endsWith("recipes.json")) return openRecipes();
    if (file.endsWith("people.json")) return openPeople();
    if (!file.endsWith(".panel.json")) return openAlarms();
    const QString panel = QFileInfo(file).fileName().chopped(QString(".panel.json").size());
    openPanel(panel);
    auto* designer = qobject_cast<hmi::PanelDesigner*>(m_parts.tabs.pageByKey(kPanel + panel));
    if (designer && designer->document().panel().find(element)) designer->selection().set({element});
}

void DesignPages::editThemes(const QString& theme) {
    if (!m_parts.live.design()) return;
    if (const Key key = kTheme + theme; !theme.isEmpty() && isUnread(key)) return openAsText(key);
    const auto* designer = qobject_cast<hmi::PanelDesigner*>(m_parts.tabs.currentWidget());
    hmi::ThemeDialog(*m_parts.live.design(), designer ? designer->panelName() : QString(), theme, &m_parts.window)
        .exec();
}

void DesignPages::newPanel() {
    if (!m_parts.workspace.isOpen()) return;
    QString name;
    const auto add = [&](const QString& text) {
        if (text.contains('/') || text.contains('\\'))
            return tr("A panel's name cannot contain / or \\; choose another name");
        name = text;
        const auto added = m_parts.live.addPanel(text);
        return added ? QString() : kit::messageText(added.error());
    };
    if (!kit::TextQuestion(tr("New Panel"), tr("Name of the panel:"), tr("overview"), add, &m_parts.window).ask())
        return;
    openPanel(name);
    if (QWidget* page = m_parts.tabs.pageByKey(kPanel + name)) page->setFocus();
}

// ------------------------------------------------------------------ close

bool DesignPages::closeAll() {
    EditorTabs& tabs = m_parts.tabs;
    for (int i = tabs.count() - 1; i >= 0; --i) {
        const QString key = keyOf(tabs.widget(i));
        if ((isKey(key) || key.startsWith(kText)) && !tabs.closePage(i)) return false;
    }
    return true;
}

void DesignPages::drop() {
    for (int i = m_parts.tabs.count() - 1; i >= 0; --i) {
        QWidget* page = m_parts.tabs.widget(i);
        if (!isKey(keyOf(page))) continue;
        m_parts.tabs.removeTab(i);
        delete page;
    }
}

bool DesignPages::mayClose(QWidget* page) {
    auto* text = qobject_cast<TextPage*>(page);
    if (!text) return mayForget(keyOf(page));
    if (!text->isModified()) return true;
    return asksToSave(
        QFileInfo(text->path()).fileName(), [text] { return text->save(); }, [] {});
}

bool DesignPages::mayForget(const Key& key) {
    if (!m_parts.files.isChanged(key)) return true;
    return asksToSave(
        PanelFiles::titleOf(key), [this, key] { return m_parts.files.save(key); },
        [this, key] { m_parts.files.discard(key); });
}

bool DesignPages::asksToSave(const QString& title, const std::function<Result<void>()>& save,
                             const std::function<void()>& discard) {
    const auto answer =
        QMessageBox::question(&m_parts.window, tr("Unsaved changes"), tr("%1 was changed. Save it?").arg(title),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Cancel) return false;
    if (answer == QMessageBox::Discard) {
        discard();
        return true;
    }
    const Result<void> saved = save();
    report(saved);
    return static_cast<bool>(saved);
}

bool DesignPages::mayLeave() {
    if (!m_parts.tabs.closeAll()) return false;
    for (const Key& key : m_parts.files.changed()) // what has no page, as texts typed in a panel
        if (!mayForget(key)) return false;
    return true;
}

// ------------------------------------------------------------------ save

void DesignPages::save() {
    QWidget* page = m_parts.tabs.currentWidget();
    if (auto* text = qobject_cast<TextPage*>(page)) return report(text->save());
    if (m_parts.tabs.currentPage()) return m_parts.tabs.saveCurrent();
    if (!page || !m_parts.live.design()) return;
    report(m_parts.files.save(keyOf(page)));
    saveLanguages();
}

void DesignPages::saveAll() {
    for (int i = 0; i < m_parts.tabs.count(); ++i)
        if (auto* text = qobject_cast<TextPage*>(m_parts.tabs.widget(i)); text && text->isModified())
            report(text->save());
    report(m_parts.files.saveAll());
    saveLanguages();
    m_parts.tabs.saveAll();
}

void DesignPages::saveLanguages() {
    if (!m_parts.live.design()) return;
    std::vector<std::string> languages;
    for (const QString& tag : m_parts.live.panels().texts.settings().languages) languages.push_back(tag.toStdString());
    const projects::Project& project = m_parts.workspace.project();
    if (languages == project.languages) return;
    nlohmann::ordered_json json = project.json;
    json["hmi"]["languages"] = languages;
    report(m_parts.workspace.saveProjectFile(json));
}

void DesignPages::report(const Result<void>& result) {
    if (!result) emit message(kit::messageText(result.error()), true);
}

} // namespace plc::app
