#include "hmi/designer/editors/recipe_editor.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "hmi/designer/editors/edit_bar.h"
#include "hmi/station/recipe_transfer.h"
#include "projects/storage/project_file.h"

#include <QAction>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QSplitter>
#include <QTableWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::hmi {

namespace {

/// "", or a number as it is written in the file.
std::optional<std::optional<double>> limitOf(const QString& text) {
    if (text.trimmed().isEmpty()) return std::optional<double>();
    bool isNumber = false;
    const double value = text.trimmed().toDouble(&isNumber);
    if (!isNumber) return {};
    return std::optional<double>(value);
}

QString shownLimit(const std::optional<double>& limit) {
    return limit ? QString::number(*limit, 'g', QLocale::FloatingPointShortest) : QString();
}

} // namespace

RecipeEditor::RecipeEditor(DesignContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_list(new QListWidget), m_table(new QTableWidget), m_problems(new QLabel) {
    QToolBar* bar = makeEditBar(m_undo, this);
    bar->addAction(kit::icon(kit::Icon::New), tr("Add a Recipe"), this, [this] {
        addRecipe();
        m_list->setFocus();
        m_list->editItem(m_list->currentItem()); // its name can be typed at once
    });
    bar->addAction(kit::icon(kit::Icon::Variable), tr("Add a Variable"), this, [this] {
        const std::optional<QString> path = m_context.picker() ? m_context.picker()(QString()) : std::nullopt;
        if (path || !m_context.picker()) addVariable(path.value_or(QString()));
    });
    bar->addAction(kit::icon(kit::Icon::Table), tr("Add a Set"), this, &RecipeEditor::addSet);
    bar->addAction(kit::icon(kit::Icon::Rename), tr("Rename Set"), this,
                   [this] { askForSetName(m_table->currentColumn()); });
    bar->addAction(kit::icon(kit::Icon::Remove), tr("Remove Row or Set"), this, &RecipeEditor::removeSelected);
    bar->addAction(kit::icon(kit::Icon::Delete), tr("Remove Recipe"), this, &RecipeEditor::removeRecipe);
    bar->addSeparator();
    const QString filter = tr("Tables (*.csv)");
    bar->addAction(kit::icon(kit::Icon::Import), tr("Import CSV"), this, [this, filter] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Import CSV"), m_context.project().folder, filter);
        if (!path.isEmpty()) importCsv(path);
    });
    bar->addAction(kit::icon(kit::Icon::Export), tr("Export CSV"), this, [this, filter] {
        const QString path = QFileDialog::getSaveFileName(this, tr("Export CSV"), m_context.project().folder, filter);
        if (!path.isEmpty()) exportCsv(path);
    });
    m_list->setAccessibleName(tr("Recipes"));
    m_table->setAccessibleName(tr("Variables and sets of the recipe"));
    m_table->verticalHeader()->hide();
    m_problems->setWordWrap(true);
    m_problems->setMargin(4);
    auto* splitter = new QSplitter;
    splitter->addWidget(m_list);
    splitter->addWidget(m_table);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({160, 640});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(splitter, 1);
    layout->addWidget(m_problems);

    connect(m_list, &QListWidget::currentTextChanged, this, [this](const QString& name) {
        m_current = name;
        rebuild();
    });
    connect(m_list, &QListWidget::itemChanged, this,
            [this](QListWidgetItem* item) { renameRecipe(m_list->row(item), item->text()); });
    connect(m_table, &QTableWidget::cellChanged, this,
            [this](int row, int column) { commit(row, column, m_table->item(row, column)->text()); });
    connect(m_table->horizontalHeader(), &QHeaderView::sectionDoubleClicked, this, &RecipeEditor::askForSetName);
    connect(&m_context, &DesignContext::recipesTaken, &m_undo, &QUndoStack::clear); // its steps are of another file
    connect(&m_context, &DesignContext::recipesChanged, this, &RecipeEditor::rebuild);
    connect(&m_context, &DesignContext::textsChanged, this, &RecipeEditor::rebuild);
    connect(&m_context, &DesignContext::programChanged, this, &RecipeEditor::rebuild);
    rebuild();
}

const Recipe* RecipeEditor::current() const { return m_context.project().recipes.find(m_current); }

void RecipeEditor::perform(const QString& title, RecipeFile after, const DesignContext::NamesInPanels& names) {
    const RecipeFile before = m_context.project().recipes;
    if (after.write() == before.write()) return rebuild();
    m_undo.push(m_context.newEdit(
        title, [this, after] { m_context.setRecipes(after); }, [this, before] { m_context.setRecipes(before); },
        names));
}

void RecipeEditor::edit(const QString& title, const std::function<void(Recipe&)>& change) {
    RecipeFile after = m_context.project().recipes;
    Recipe* recipe = after.find(m_current);
    if (!recipe) return;
    change(*recipe);
    perform(title, std::move(after));
}

/// With its place where it has one: "dough.csv:3: …".
void RecipeEditor::tell(const Error& problem) {
    const QString text = kit::messageText(problem.message);
    m_problems->setText(problem.place.empty() ? text
                                              : QString::fromStdString(problem.place) + QStringLiteral(": ") + text);
}

/// What was typed is not taken: the cell has its old text again, and the reason is said.
void RecipeEditor::refuse(const QString& why) {
    rebuild();
    m_problems->setText(why);
}

QString RecipeEditor::problems() const { return m_problems->text(); }

void RecipeEditor::select(const QString& recipe) {
    const QList<QListWidgetItem*> found = m_list->findItems(recipe, Qt::MatchFixedString);
    if (!found.isEmpty()) m_list->setCurrentItem(found.front());
}

void RecipeEditor::addRecipe() {
    RecipeFile after = m_context.project().recipes;
    QString name = QStringLiteral("recipe");
    for (int i = 2; after.find(name); ++i) name = QStringLiteral("recipe%1").arg(i);
    Recipe recipe;
    recipe.name = name;
    recipe.sets.push_back({QStringLiteral("set1"), {}});
    after.recipes().push_back(recipe);
    m_current = name;
    perform(tr("Add a Recipe"), std::move(after));
}

void RecipeEditor::removeRecipe() {
    RecipeFile after = m_context.project().recipes;
    std::erase_if(after.recipes(), [this](const Recipe& one) { return one.name == m_current; });
    perform(tr("Remove Recipe"), std::move(after));
}

void RecipeEditor::renameRecipe(int row, const QString& name) {
    RecipeFile after = m_context.project().recipes;
    if (row < 0 || row >= static_cast<int>(after.recipes().size())) return;
    Recipe& recipe = after.recipes()[static_cast<size_t>(row)];
    const QString wanted = name.trimmed();
    if (wanted == recipe.name) return rebuild();
    if (wanted.isEmpty()) return refuse(tr("A recipe needs a name."));
    if (after.find(wanted)) return refuse(tr("The recipe \"%1\" already exists; choose another name.").arg(wanted));
    const QString old = std::exchange(recipe.name, wanted);
    m_current = wanted;
    // Panels that show it follow, in the same step.
    perform(tr("Rename Recipe"), std::move(after),
            m_context.namesToRename("recipe", [&](const QString& one) { return one == old ? wanted : one; }));
}

void RecipeEditor::addVariable(const QString& path) {
    edit(tr("Add a Variable"), [&](Recipe& recipe) {
        if (path.isEmpty() || recipe.variable(path)) return;
        RecipeVariable row;
        row.variable = path;
        recipe.variables.push_back(row);
    });
}

namespace {
/// "set1" is a name given here: "set2" follows it, not "set12".
bool isCounted(const QString& name) {
    bool isNumber = false;
    if (name.startsWith(QStringLiteral("set"))) name.mid(3).toUInt(&isNumber);
    return isNumber;
}
} // namespace

void RecipeEditor::addSet() {
    edit(tr("Add a Set"), [](Recipe& recipe) {
        RecipeSet set = recipe.sets.empty() ? RecipeSet() : recipe.sets.back(); // a new kind is often nearly an old one
        if (recipe.sets.empty())
            set.name = QStringLiteral("set1");
        else
            set.name = recipe.freeName(isCounted(set.name) ? QStringLiteral("set") : set.name);
        recipe.sets.push_back(std::move(set));
    });
}

void RecipeEditor::askForSetName(int column) {
    if (!current()) return;
    if (column < FirstSet) return refuse(tr("Select a cell of the set that is to be renamed."));
    const QString present = current()->sets[static_cast<size_t>(column - FirstSet)].name;
    const auto take = [&](const QString& name) { return renameSet(column, name); };
    kit::TextQuestion(tr("Rename Set"), tr("Name:"), present, take, this).ask();
}

QString RecipeEditor::renameSet(int column, const QString& name) {
    const Recipe* recipe = current();
    const auto index = static_cast<size_t>(column - FirstSet);
    if (!recipe || column < FirstSet || index >= recipe->sets.size() || recipe->sets[index].name == name) return {};
    if (recipe->find(name)) return tr("The set \"%1\" already exists; choose another name.").arg(name);
    edit(tr("Rename Set"), [&](Recipe& changed) { changed.sets[index].name = name; });
    return {};
}

void RecipeEditor::removeSelected() {
    const int row = m_table->currentRow(), column = m_table->currentColumn();
    edit(column >= FirstSet ? tr("Remove Set") : tr("Remove Row"), [&](Recipe& recipe) {
        if (column >= FirstSet && column - FirstSet < static_cast<int>(recipe.sets.size())) {
            recipe.sets.erase(recipe.sets.begin() + (column - FirstSet));
        } else if (row >= 0 && row < static_cast<int>(recipe.variables.size())) {
            for (RecipeSet& set : recipe.sets) set.values.remove(recipe.variables[static_cast<size_t>(row)].variable);
            recipe.variables.erase(recipe.variables.begin() + row);
        }
    });
}

void RecipeEditor::commit(int row, int column, const QString& typed) {
    const QString text = typed.trimmed();
    const Recipe* recipe = current();
    if (!recipe || row < 0 || row >= static_cast<int>(recipe->variables.size())) return;
    const QString title = m_table->horizontalHeaderItem(column)->text();
    const auto limit = limitOf(text);
    if ((column == Minimum || column == Maximum) && !limit)
        return refuse(tr("\"%1\" is not a number; a limit is written like 12.5.").arg(text));
    const QString& before = recipe->variables[static_cast<size_t>(row)].variable;
    if (column == Variable && text.isEmpty())
        return refuse(tr("A row needs a variable; Remove Row or Set takes the row away."));
    if (column == Variable && text != before && recipe->variable(text))
        return refuse(tr("%1 is already in the recipe; choose another variable.").arg(text));
    std::optional<kit::MacroScope> macro;
    QString stored = text;
    if (column == Title) { // the text goes into the table of texts: one step with its key
        macro.emplace(m_undo, title);
        const QString now = recipe->variables[static_cast<size_t>(row)].title;
        stored = m_context.storeText(now, text, QStringLiteral("recipe"), m_undo);
    }
    edit(title, [&](Recipe& changed) {
        RecipeVariable& variable = changed.variables[static_cast<size_t>(row)];
        switch (column) {
        case Variable:
            if (text == variable.variable) return;
            for (RecipeSet& set : changed.sets)
                if (const auto value = set.values.find(variable.variable); value != set.values.end())
                    set.values.insert(text, set.values.take(variable.variable));
            variable.variable = text;
            return;
        case Title:
            variable.title = stored;
            return;
        case Unit:
            variable.unit = text;
            return;
        case Format:
            variable.format = text;
            return;
        case Minimum:
            variable.minimum = *limit;
            return;
        case Maximum:
            variable.maximum = *limit;
            return;
        default:
            if (text.isEmpty())
                changed.sets[static_cast<size_t>(column - FirstSet)].values.remove(variable.variable);
            else
                changed.sets[static_cast<size_t>(column - FirstSet)].values.insert(variable.variable, text);
        }
    });
}

void RecipeEditor::rebuild() {
    const RecipeFile& file = m_context.project().recipes;
    if (!file.find(m_current)) m_current = file.recipes().empty() ? QString() : file.recipes().front().name;
    const QSignalBlocker quietList(m_list), quietTable(m_table);
    // The items stay: one of them may be what is being edited.
    while (m_list->count() > static_cast<int>(file.recipes().size())) delete m_list->takeItem(m_list->count() - 1);
    for (int row = 0; row < static_cast<int>(file.recipes().size()); ++row) {
        const QString& name = file.recipes()[static_cast<size_t>(row)].name;
        if (row == m_list->count()) m_list->addItem(name);
        m_list->item(row)->setText(name);
        m_list->item(row)->setFlags(m_list->item(row)->flags() | Qt::ItemIsEditable);
        if (name == m_current) m_list->setCurrentRow(row);
    }
    m_problems->setText(file.recipes().empty() ? tr("Add a recipe, then its variables, then a set for each product.")
                                               : QString());
    const Recipe* recipe = current();
    m_table->setEnabled(recipe != nullptr);
    if (!recipe) {
        m_table->setRowCount(0);
        m_table->setColumnCount(0);
        return;
    }
    fillTable(*recipe);
    showProblems(*recipe);
}

void RecipeEditor::fillTable(const Recipe& recipe) {
    const int row = m_table->currentRow(), column = m_table->currentColumn();
    QStringList heads{tr("Variable"), tr("Title"), tr("Unit"), tr("Format"), tr("Minimum"), tr("Maximum")};
    for (const RecipeSet& set : recipe.sets) heads += set.name;
    m_table->setColumnCount(static_cast<int>(heads.size()));
    m_table->setHorizontalHeaderLabels(heads);
    m_table->setRowCount(static_cast<int>(recipe.variables.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const RecipeVariable& one = recipe.variables[static_cast<size_t>(i)];
        QStringList cells{one.variable, m_context.shownText(one.title), one.unit,
                          one.format,   shownLimit(one.minimum),        shownLimit(one.maximum)};
        for (const RecipeSet& set : recipe.sets) cells += set.values.value(one.variable);
        for (int k = 0; k < cells.size(); ++k) {
            if (!m_table->item(i, k)) m_table->setItem(i, k, new QTableWidgetItem);
            m_table->item(i, k)->setText(cells[k]);
            m_table->item(i, k)->setToolTip({});
            m_table->item(i, k)->setIcon({});
        }
    }
    m_table->resizeColumnsToContents();
    if (row >= 0 && row < m_table->rowCount()) m_table->setCurrentCell(row, std::max(0, column));
}

/// What the check says, in the cells that it is about.
void RecipeEditor::showProblems(const Recipe& recipe) {
    if (!m_context.checked().analysis) return;
    QStringList all;
    for (const RecipeFinding& one : checkRecipes(m_context.project().recipes, m_context.checked())) {
        const QString text = kit::messageText(one.message);
        if (one.recipe == recipe.name) all += one.set.isEmpty() ? text : one.set + QStringLiteral(": ") + text;
        for (int row = 0; one.recipe == recipe.name && row < m_table->rowCount(); ++row) {
            if (m_table->item(row, Variable)->text() != one.variable) continue;
            const auto set = std::find_if(recipe.sets.begin(), recipe.sets.end(),
                                          [&](const RecipeSet& each) { return each.name == one.set; });
            const int column =
                set == recipe.sets.end() ? Variable : FirstSet + static_cast<int>(set - recipe.sets.begin());
            m_table->item(row, column)->setToolTip(text);
            m_table->item(row, column)->setIcon(kit::icon(kit::Icon::Error));
        }
    }
    m_problems->setText(all.join(u'\n'));
    m_table->resizeColumnsToContents(); // the icons need room beside the values
}

void RecipeEditor::importCsv(const QString& path) {
    const auto bytes = projects::readFile(path.toStdString());
    if (!bytes) return tell(bytes.error());
    std::optional<Error> problem;
    edit(tr("Import CSV"), [&](Recipe& recipe) {
        Recipe taken = recipe;
        if (auto good = recipeFromCsv(taken, *bytes, path); good)
            recipe = std::move(taken);
        else
            problem = good.error();
    });
    if (problem) tell(*problem);
}

void RecipeEditor::exportCsv(const QString& path) {
    if (!current()) return;
    if (auto written = projects::writeFileAtomically(path.toStdString(), recipeToCsv(*current())); !written)
        tell(written.error());
}

} // namespace plc::hmi
