#include "hmi/designer/context/design_context.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/message_text.h"
#include "hmi/designer/context/arrange.h"
#include "hmi/model/faceplate.h"
#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"
#include "hmi/station/plc_convert.h"
#include "hmi/station/program_facts.h"

#include <QRegularExpression>

namespace plc::hmi {

DesignContext::DesignContext(PanelProject& project, QObject* parent)
    : QObject(parent), m_project(project),
      m_language(project.texts.settings().languages.value(0, QStringLiteral("en"))) {}

void DesignContext::setChecked(driver::Checked checked) {
    m_checked = std::move(checked);
    emit programChanged();
}

void DesignContext::setRun(session::Run* run) {
    m_run = run;
    emit programChanged();
}

void DesignContext::setRecording(std::shared_ptr<const session::Run> recording) {
    if (!recording && !m_recording) return;
    m_recording = std::move(recording);
    m_position.reset();
    emit recordingChanged();
}

void DesignContext::setPosition(std::optional<history::Position> position) {
    if (position == m_position) return;
    m_position = position;
    emit positionChanged();
}

void DesignContext::setLanguage(const QString& tag) {
    if (tag == m_language || tag.isEmpty()) return;
    m_language = tag;
    emit languageChanged();
}

QString DesignContext::shownText(const QString& reference) const {
    if (!isTextKey(reference)) return reference;
    const QString key = keyOf(reference);
    if (!m_project.texts.table().contains(key)) return reference;
    const QString own = m_project.texts.table().text(key, m_language);
    return own.isEmpty() ? m_project.texts.text(reference, m_language) : own;
}

QString DesignContext::storeText(const QString& present, const QString& typed, const QString& panel, QUndoStack& undo) {
    if (typed.isEmpty() || typed.startsWith(u'@')) return typed;
    int letters = 0;
    for (const QChar c : typed) letters += c.isLetter();
    // Signs and units need no translation; a project with one language and no table needs no keys.
    if (letters < 2 || (m_project.texts.settings().languages.size() < 2 && !m_project.hasTexts)) return typed;
    const TextTable& before = m_project.texts.table();
    QString key;
    if (isTextKey(present) && before.contains(keyOf(present)))
        key = keyOf(present); // the text of its key is changed
    else
        key = before.keyOfText(m_language, typed); // a text that is there is used again
    if (key.isEmpty()) key = before.newKeyFor(panel, typed);
    if (before.text(key, m_language) == typed) return u'@' + key;
    // Only this text comes and goes: the rest of the table may have come from disk meanwhile.
    const bool wasThere = before.contains(key);
    const auto put = [this, key, tag = m_language](const QString& text) {
        TextTable table = m_project.texts.table();
        table.setText(key, tag, text);
        setTable(std::move(table));
    };
    const auto takeBack = [this, key, wasThere, put, old = before.text(key, m_language)] {
        if (wasThere) return put(old);
        TextTable table = m_project.texts.table();
        table.removeKey(key);
        setTable(std::move(table));
    };
    undo.push(new kit::ClosureCommand(
        tr("Text"), [put, typed] { put(typed); }, takeBack));
    return u'@' + key;
}

/// A language that gets a column is one of the operator's from then on; one that loses its column no more.
void DesignContext::setTable(TextTable table) {
    LanguageSettings settings = m_project.texts.settings();
    const QStringList before = m_project.texts.table().tags(), after = table.tags();
    for (const QString& tag : after)
        if (!before.contains(tag) && !settings.languages.contains(tag)) settings.languages += tag;
    for (const QString& tag : before)
        if (!after.contains(tag) && settings.languages.size() > 1) settings.languages.removeAll(tag);
    if (settings.languages != m_project.texts.settings().languages) m_project.texts.setSettings(settings);
    m_project.texts.setTable(std::move(table));
    m_project.hasTexts = true;
    m_textsChanged = true;
    emit textsChanged();
}

void DesignContext::setAlarms(AlarmFile alarms) {
    m_project.alarms = std::move(alarms);
    m_project.hasAlarms = true;
    m_alarmsChanged = true;
    emit alarmsChanged();
}

void DesignContext::setRecipes(RecipeFile recipes) {
    m_project.recipes = std::move(recipes);
    m_recipesChanged = true;
    emit recipesChanged();
}

void DesignContext::setPeople(PeopleFile people) {
    m_project.people = std::move(people);
    m_peopleChanged = true;
    emit peopleChanged();
}

Result<void> DesignContext::save() {
    if (m_textsChanged)
        if (auto saved = saveTexts(m_project); !saved) return saved;
    m_textsChanged = false;
    if (m_alarmsChanged)
        if (auto saved = saveAlarms(m_project); !saved) return saved;
    m_alarmsChanged = false;
    if (m_recipesChanged)
        if (auto saved = saveRecipes(m_project, m_project.recipes); !saved) return saved;
    m_recipesChanged = false;
    if (m_peopleChanged)
        if (auto saved = savePeople(m_project); !saved) return saved;
    m_peopleChanged = false;
    while (!m_changedPanels.isEmpty()) { // one that is refused stays changed
        if (const NamedPanel* panel = m_project.find(m_changedPanels.front()))
            if (auto saved = hmi::savePanel(m_project, *panel); !saved) return saved;
        m_changedPanels.removeFirst();
    }
    emit saved();
    return {};
}

Result<void> DesignContext::savePanel(const QString& name) {
    const NamedPanel* panel = m_project.find(name);
    if (!panel) return {};
    if (auto saved = hmi::savePanel(m_project, *panel); !saved) return saved;
    m_changedPanels.removeAll(name);
    if (PanelDocument* open = m_documents.value(name)) open->setClean();
    return {};
}

void DesignContext::setPanel(const QString& name, const Panel& panel) {
    NamedPanel* known = m_project.find(name);
    if (!known) return;
    known->panel = panel;
    PanelDocument* open = m_documents.value(name);
    if (open) {
        open->reset(panel);
        open->undoStack().resetClean();
    } else if (!m_changedPanels.contains(name)) {
        m_changedPanels += name;
    }
    emit panelEdited(name);
}

void DesignContext::panelReplaced(const QString& name) {
    m_changedPanels.removeAll(name);
    const NamedPanel* panel = m_project.find(name);
    if (PanelDocument* open = m_documents.value(name); open && panel) open->reset(panel->panel);
    emit panelEdited(name);
}

void DesignContext::textsReplaced() {
    m_textsChanged = false;
    emit textsTaken();
    emit textsChanged();
}

void DesignContext::alarmsReplaced() {
    m_alarmsChanged = false;
    emit alarmsTaken();
    emit alarmsChanged();
}

void DesignContext::recipesReplaced() {
    m_recipesChanged = false;
    emit recipesTaken();
    emit recipesChanged();
}

void DesignContext::peopleReplaced() {
    m_peopleChanged = false;
    emit peopleTaken();
    emit peopleChanged();
}

void DesignContext::themesReplaced() {
    m_project.readThemes();
    emit themesTaken();
}

namespace {
/// The panel itself (an empty id) and its buttons, where they name a theme that `renamed` makes another.
Edit withThemes(const Panel& panel, const std::function<QString(const QString&)>& renamed) {
    EditList out;
    const auto rename = [&](const ElementId& element, const QString& before) {
        if (const QString after = renamed(before); after != before)
            out.edits.push_back(setProperty(panel, element, "theme", toUtf8(after)));
    };
    rename({}, panel.text("theme"));
    for (const Element& element : panel.elements())
        if (element.kind() == ElementKind::Button) rename(element.id(), element.text("theme"));
    return {out};
}
} // namespace

QStringList DesignContext::panelsWithTheme(const QString& name) const {
    QStringList out;
    for (const NamedPanel& panel : m_project.panels) {
        const auto other = [&](const QString& theme) { return theme == name ? QString() : theme; };
        if (!withThemes(latest(panel), other).isEmpty()) out += panel.name;
    }
    return out;
}

void DesignContext::renameThemes(const std::map<QString, QString>& names) {
    const auto renamed = [&](const QString& theme) {
        const auto found = names.find(theme);
        return found == names.end() ? theme : found->second;
    };
    rewritePanels(tr("Rename Theme"), [&](const Panel& panel) { return withThemes(panel, renamed); });
}

bool DesignContext::isPanelChanged(const QString& name) const {
    const PanelDocument* open = m_documents.value(name);
    return m_changedPanels.contains(name) || (open && !open->isClean());
}

const Panel* DesignContext::panelNow(const QString& name) const {
    const NamedPanel* panel = m_project.find(name);
    return panel ? &latest(*panel) : nullptr;
}

void DesignContext::openDocument(const QString& panel, PanelDocument* document) { m_documents.insert(panel, document); }

void DesignContext::closeDocument(const PanelDocument* document) {
    for (const QString& name : m_documents.keys(const_cast<PanelDocument*>(document))) m_documents.remove(name);
}

void DesignContext::rewritePanel(NamedPanel& panel, const QString& title, const Edit& change) {
    if (PanelDocument* open = m_documents.value(panel.name)) return open->perform(title, change);
    applyTo(panel.panel, change);
    if (!m_changedPanels.contains(panel.name)) m_changedPanels += panel.name;
    emit panelEdited(panel.name);
}

const Panel& DesignContext::latest(const NamedPanel& panel) const {
    const PanelDocument* open = m_documents.value(panel.name);
    return open ? open->panel() : panel.panel;
}

bool DesignContext::rewritePanels(const QString& title, const std::function<Edit(const Panel&)>& edit) {
    bool any = false;
    for (NamedPanel& panel : m_project.panels) {
        const Edit change = edit(latest(panel));
        if (change.isEmpty()) continue;
        any = true;
        rewritePanel(panel, title, change);
    }
    return any;
}

DesignContext::NamesInPanels DesignContext::namesToRename(std::string_view key,
                                                          const std::function<QString(const QString&)>& renamed) const {
    NamesInPanels out;
    for (const NamedPanel& panel : m_project.panels)
        for (const Element& element : latest(panel).elements()) {
            const QString before = element.text(key);
            if (before.isEmpty()) continue;
            if (const QString after = renamed(before); after != before)
                out.push_back({panel.name, element.id(), std::string(key), before, after});
        }
    return out;
}

void DesignContext::putNames(const QString& title, const NamesInPanels& names, Names which) {
    for (NamedPanel& panel : m_project.panels) {
        EditList list;
        for (const NameInPanel& one : names)
            if (one.panel == panel.name)
                list.edits.push_back(hmi::setProperty(latest(panel), one.element, one.key,
                                                      toUtf8(which == Names::After ? one.after : one.before)));
        if (!list.edits.empty()) rewritePanel(panel, title, {list});
    }
}

QUndoCommand* DesignContext::newEdit(const QString& title, std::function<void()> forward, std::function<void()> back,
                                     const NamesInPanels& names) {
    const auto both = [this, title, names](const std::function<void()>& change, Names which) {
        change();
        putNames(title, names, which);
    };
    return new kit::ClosureCommand(
        title, [both, forward = std::move(forward)] { both(forward, Names::After); },
        [both, back = std::move(back)] { both(back, Names::Before); });
}

bool DesignContext::renameExpressions(const QString& title, const Renamed& renamed) {
    bool any = false;
    for (NamedPanel& panel : m_project.panels) {
        const Edit change =
            withExpressions(latest(panel), [&](const QString& expression) { return renamed(panel.name, expression); });
        if (change.isEmpty()) continue;
        any = true;
        rewritePanel(panel, title, change);
    }
    const auto other = [&](const QString& expression) { return renamed({}, expression); };
    AlarmFile alarms = m_project.alarms;
    const std::string before = alarms.write();
    for (Properties& row : alarms.rows()) {
        for (const char* key : {"condition", "inhibit"})
            if (row.has(key)) row.set(key, toUtf8(other(row.text(key))));
        if (!row.has("values"_field) || !row.at("values"_field).is_object()) continue;
        Json values = row.at("values"_field);
        for (Json& expression : values)
            if (expression.is_string()) expression = toUtf8(other(toQString(expression)));
        row.set("values"_field, values);
    }
    if (alarms.write() != before) {
        setAlarms(std::move(alarms));
        any = true;
    }
    RecipeFile recipes = m_project.recipes;
    for (Recipe& recipe : recipes.recipes()) {
        for (RecipeVariable& row : recipe.variables) row.variable = other(row.variable);
        for (RecipeSet& set : recipe.sets) {
            QMap<QString, QString> values;
            for (auto each = set.values.cbegin(); each != set.values.cend(); ++each)
                values.insert(other(each.key()), each.value());
            set.values = values;
        }
    }
    if (recipes.write() != m_project.recipes.write()) {
        setRecipes(std::move(recipes));
        any = true;
    }
    return any;
}

std::vector<DesignContext::VariableUse> DesignContext::expressionsThat(const Renamed& renames) const {
    std::vector<VariableUse> out;
    const auto look = [&](const QString& panel, const QString& file, const Properties& properties,
                          const ElementId& id) {
        forEachBinding(properties, [&](const Found& found) {
            if (renames(panel, found.text) != found.text)
                out.push_back({file, id, found.place(), found.text, found.place().startsWith(QLatin1String("target"))});
        });
    };
    for (const NamedPanel& panel : m_project.panels) {
        const QString file = m_project.placeOf(m_project.panelPath(panel.name));
        look(panel.name, file, panel.panel, {});
        for (const Element& element : panel.panel.elements()) look(panel.name, file, element, element.id());
    }
    const auto names = [&](const QString& expression) { return renames({}, expression) != expression; };
    for (const Properties& row : m_project.alarms.rows())
        for (const char* key : {"condition", "inhibit"})
            if (names(row.text(key)))
                out.push_back({m_project.placeOf(m_project.alarmsPath()), row.text("id"_text), QString::fromLatin1(key),
                               row.text(key), false});
    for (const Recipe& recipe : m_project.recipes.recipes())
        for (const RecipeVariable& row : recipe.variables)
            if (names(row.variable))
                out.push_back({m_project.placeOf(m_project.recipesPath()), recipe.name, QStringLiteral("variable"),
                               row.variable, true});
    return out;
}

DesignContext::Renamed DesignContext::renamer(const NamedVariable& variable, const QString& newPath,
                                              const QString& newName) {
    return [=](const QString& panel, const QString& expression) {
        const QString moved =
            variable.path.isEmpty() ? expression : withRenamedPath(expression, variable.path, newPath);
        const auto bases = variable.bases.find(panel);
        if (bases == variable.bases.end()) return moved;
        return withRenamedMember(moved, variable.name, newName,
                                 [&](const QString& base) { return bases->second.count(base) > 0; });
    };
}

namespace {
QString pathAfter(const DesignContext::NamedVariable& variable, const QString& newName) {
    return variable.path.left(variable.path.size() - variable.name.size()) + newName;
}
} // namespace

bool DesignContext::rename(const NamedVariable& variable, const QString& newName) {
    return renameExpressions(tr("Rename %1").arg(variable.name),
                             renamer(variable, pathAfter(variable, newName), newName));
}

QString DesignContext::renamed(const NamedVariable& variable, const QString& newName, const QString& expression) {
    return renamer(variable, pathAfter(variable, newName), newName)({}, expression);
}

std::vector<DesignContext::VariableUse> DesignContext::usesOf(const NamedVariable& variable) const {
    return expressionsThat(renamer(variable, QStringLiteral("_"), QStringLiteral("_")));
}

/// The names of its type and of what that extends; `panel`: whose parameters it may begin with.
QStringList DesignContext::typesOfBase(const NamedPanel* panel, const QString& base) const {
    QString path = base;
    if (base.startsWith(u'$')) {
        const QString name = base.mid(1).section(QRegularExpression(QStringLiteral("[^\\w]")), 0, 0);
        QString type;
        if (panel)
            for (const Parameter& parameter : parametersOf(latest(*panel)))
                if (parameter.name.compare(name, Qt::CaseInsensitive) == 0) type = parameter.type;
        const QString rest = base.mid(1 + name.size());
        if (rest.isEmpty()) {
            const std::optional<TypedExpression> known = typedVariable(m_checked, type);
            return known ? typeNamesOf(*known) : QStringList();
        }
        path = instanceOf(m_checked, type) + rest;
    }
    // An index that the panel fills in, "[#]" or "[$i]": any element has the type.
    static const QRegularExpression filledIn(QStringLiteral("\\[[^\\[\\]]*[#$][^\\[\\]]*\\]"));
    for (auto match = filledIn.match(path); match.hasMatch(); match = filledIn.match(path)) {
        const auto bounds = boundsOf(m_checked, path.left(match.capturedStart()));
        if (!bounds) return {};
        path.replace(match.capturedStart(), match.capturedLength(), QStringLiteral("[%1]").arg(bounds->first));
    }
    return typeNamesOf(m_checked, path);
}

DesignContext::NamedVariable DesignContext::namedVariable(const QString& path, const QString& owner,
                                                          const QString& name, const QStringList& elsewhere) const {
    NamedVariable out{path, name, {}};
    if (owner.isEmpty()) return out;
    const auto collect = [&](const NamedPanel* panel, const QString& expression) {
        (void)withRenamedMember(expression, name, name, [&](const QString& base) {
            if (typesOfBase(panel, base).contains(owner, Qt::CaseInsensitive))
                out.bases[panel ? panel->name : QString()].insert(base);
            return false;
        });
    };
    for (const QString& expression : elsewhere) collect(nullptr, expression);
    for (const NamedPanel& panel : m_project.panels)
        (void)withExpressions(latest(panel), [&](const QString& expression) {
            collect(&panel, expression);
            return expression;
        });
    for (const Properties& row : m_project.alarms.rows()) {
        for (const char* key : {"condition", "inhibit"}) collect(nullptr, row.text(key));
        if (row.has("values"_field) && row.at("values"_field).is_object())
            for (const Json& expression : row.at("values"_field))
                if (expression.is_string()) collect(nullptr, toQString(expression));
    }
    for (const Recipe& recipe : m_project.recipes.recipes()) {
        for (const RecipeVariable& row : recipe.variables) collect(nullptr, row.variable);
        for (const RecipeSet& set : recipe.sets)
            for (auto each = set.values.cbegin(); each != set.values.cend(); ++each) collect(nullptr, each.key());
    }
    return out;
}

std::optional<ValueFacts> DesignContext::factsOf(const QString& path) const {
    const std::optional<TypedExpression> known = typedExpression(m_checked, path);
    if (!known) return {};
    return hmi::factsOf(*known->types, known->type, known->isPlace);
}

std::optional<QString> DesignContext::variableNamed(const QString& words) const {
    const QString name = words.trimmed();
    const auto isVariable = [&](const QString& path) {
        const std::optional<ValueFacts> facts = factsOf(path);
        return facts && facts->writable;
    };
    if (name.isEmpty() || name.size() > 200 || !m_checked.analysis) return {};
    if (isVariable(name)) return name;
    QStringList found;
    for (const sema::SymbolKind kind : {sema::SymbolKind::Program, sema::SymbolKind::GlobalList})
        for (const sema::Symbol& symbol : m_checked.analysis->symbols) {
            if (symbol.kind != kind) continue;
            const QString path = QString::fromStdString(symbol.name) + u'.' + name;
            if (!found.contains(path, Qt::CaseInsensitive) && isVariable(path)) found += path;
        }
    if (found.size() != 1) return {}; // several are called so: which one is not for us to guess
    return found.front();
}

QString DesignContext::checkBinding(const QString& expression, std::string_view wanted, bool isTarget) const {
    if (!parameterNames(expression).isEmpty()) return {}; // by what it is given: checked with the panel
    return m_checked.analysis && !expression.trimmed().isEmpty()
               ? kit::messageText(hmi::checkBinding(m_checked, expression, wanted, isTarget))
               : QString();
}

CheckInput DesignContext::checkInput() const {
    CheckInput input = m_project.checkInput();
    askProgram(input, m_checked);
    return input;
}

QStringList DesignContext::usersOf(const QString& key) const {
    QStringList out;
    const auto look = [&](const QString& owner, const Properties& properties, const QString& id) {
        forEachText(properties, [&](const Found& found) {
            if (found.text == u'@' + key)
                out += owner + QStringLiteral(": ") + (id.isEmpty() ? QString() : id + u'.') + found.place();
        });
        forEachTextList(properties, [&](const Found& found) {
            const QString prefix = (isTextKey(found.text) ? keyOf(found.text) : found.text) + u'.';
            if (key.startsWith(prefix) && !key.mid(prefix.size()).contains(u'.'))
                out += owner + QStringLiteral(": ") + id + u'.' + found.place();
        });
    };
    for (const NamedPanel& panel : m_project.panels) {
        look(panel.name, panel.panel, {});
        for (const Element& element : panel.panel.elements()) look(panel.name, element, element.id());
    }
    for (const Properties& alarm : m_project.alarms.rows()) look(tr("Alarms"), alarm, alarm.text("id"_text));
    for (const Properties& one : m_project.alarms.classRows()) look(tr("Alarms"), one, one.text("name"_text));
    return out;
}

} // namespace plc::hmi
