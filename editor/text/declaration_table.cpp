#include "editor/text/declaration_table.h"

#include "editor/kit/icons.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "projects/analysis/sections.h"
#include "runtime/compiler/parse/section_keyword.h"

#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <map>
#include <set>

namespace plc::editor {

namespace {
using syntax::SectionKind;
/// What a variable can be moved to.
constexpr SectionKind kSections[] = {SectionKind::Var,   SectionKind::Input, SectionKind::Output,
                                     SectionKind::InOut, SectionKind::Temp,  SectionKind::Stat};

/// Chooses the section of a variable from a list.
class SectionDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override {
        auto* box = new QComboBox(parent);
        box->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
        for (const SectionKind kind : kSections) box->addItem(kit::fromView(syntax::keywordOf(kind)));
        const QString now = index.data().toString();
        if (box->findText(now) < 0) box->insertItem(0, now); // VAR CONSTANT, VAR RETAIN
        box->setCurrentText(now);
        connect(box, &QComboBox::activated, this, [this, box] { // chosen is chosen
            auto* self = const_cast<SectionDelegate*>(this);
            emit self->commitData(box);
            emit self->closeEditor(box);
        });
        QTimer::singleShot(0, box, &QComboBox::showPopup);
        return box;
    }
    void setEditorData(QWidget*, const QModelIndex&) const override {}
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        const QString chosen = static_cast<QComboBox*>(editor)->currentText();
        if (chosen != index.data().toString()) model->setData(index, chosen);
    }
};

QString sectionWord(const syntax::VarSection& section) {
    QString out = kit::fromView(syntax::keywordOf(section.kind));
    if (section.constant) out += " CONSTANT";
    if (section.retain) out += " RETAIN";
    if (section.persistent) out += " PERSISTENT";
    return out;
}
} // namespace

DeclarationTable::DeclarationTable(StEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor) {
    m_table = new QTableWidget(0, Column::Count, this);
    m_table->setHorizontalHeaderLabels(
        {tr("Section"), tr("Name"), tr("Address"), tr("Type"), tr("Initial value"), tr("Comment"), tr("Value")});
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(24);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setAccessibleName(tr("Declarations"));
    m_table->setItemDelegateForColumn(Section, new SectionDelegate(m_table));
    // A cell that was being edited kept the rows as they were.
    for (const QAbstractItemDelegate* each : {m_table->itemDelegate(), m_table->itemDelegateForColumn(Section)})
        connect(each, &QAbstractItemDelegate::closeEditor, this, [this] {
            if (m_shown != m_model) fillAgain();
        });
    auto* bar = new QToolBar(this);
    makeBar(*bar);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_table);
    connect(m_table, &QTableWidget::cellChanged, this, &DeclarationTable::takeEdit);
    connect(&m_editor, &StEditor::cursorMoved, this, [this] { fill(); });
}

void DeclarationTable::makeBar(QToolBar& bar) {
    using syntax::SectionKind;
    bar.setIconSize({16, 16});
    auto* add = new QToolButton(&bar);
    add->setIcon(kit::icon(kit::Icon::Add));
    add->setToolTip(tr("Add a variable"));
    add->setAccessibleName(add->toolTip());
    add->setPopupMode(QToolButton::MenuButtonPopup);
    auto* menu = new QMenu(add);
    for (const SectionKind kind :
         {SectionKind::Var, SectionKind::Input, SectionKind::Output, SectionKind::InOut, SectionKind::Temp})
        menu->addAction(kit::fromView(syntax::keywordOf(kind)), this, [this, kind] { addVariable(kind); });
    add->setMenu(menu);
    connect(add, &QToolButton::clicked, this, [this] {
        const int row = m_table->currentRow(); // another one of its kind
        const bool isKnown = row >= 0 && row < static_cast<int>(m_rows.size());
        addVariable(isKnown ? m_rows[static_cast<size_t>(row)].section->kind : SectionKind::Var);
    });
    bar.addWidget(add);
    connect(bar.addAction(kit::icon(kit::Icon::Remove), tr("Remove the selected variables")), &QAction::triggered, this,
            &DeclarationTable::removeSelected);
    connect(bar.addAction(kit::icon(kit::Icon::Up), tr("Move up")), &QAction::triggered, this,
            [this] { moveSelected(-1); });
    connect(bar.addAction(kit::icon(kit::Icon::Down), tr("Move down")), &QAction::triggered, this,
            [this] { moveSelected(1); });
}

bool DeclarationTable::isUpToDate() const {
    const auto file = m_shown && m_pou ? m_shown->fileOf(m_editor.file().toStdString()) : std::nullopt;
    return file && m_editor.utf8() == m_shown->sources()[*file].text();
}

bool DeclarationTable::isEditing() const {
    if (QApplication::activePopupWidget() && m_table->viewport()->findChild<QComboBox*>()) return true;
    const QWidget* focus = QApplication::focusWidget();
    return focus && focus != m_table && focus != m_table->viewport() && m_table->viewport()->isAncestorOf(focus);
}

void DeclarationTable::whenUpToDate(std::function<void()> change) {
    if (isUpToDate()) return change();
    m_waiting.push_back(std::move(change));
}

int DeclarationTable::rowOf(const QString& name) const {
    for (int row = 0; row < m_table->rowCount() && row < static_cast<int>(m_rows.size()); ++row)
        if (kit::fromView(
                m_rows[static_cast<size_t>(row)].declaration->names[m_rows[static_cast<size_t>(row)].nameIndex].text)
                .compare(name, Qt::CaseInsensitive) == 0)
            return row;
    return -1;
}

/// Behind the event that is being handled: its cell is still in use.
void DeclarationTable::fillAgain() {
    m_pou = nullptr;
    kit::post(this, [this] { fill(); });
}

void DeclarationTable::setModel(std::shared_ptr<const analysis::CodeModel> model) {
    m_model = std::move(model);
    fill();
}

const syntax::Pou* DeclarationTable::unitAtCursor(const analysis::CodeModel& model, FileId file) const {
    const syntax::Pou* around = nullptr;
    const uint32_t at = m_editor.cursorOffset();
    const auto walk = [&](auto&& self, const std::vector<syntax::Decl*>& declarations) -> void {
        for (const syntax::Decl* declaration : declarations) {
            if (declaration->kind == syntax::DeclKind::Pou && declaration->pou &&
                (!around || at >= declaration->pou->range.begin))
                around = declaration->pou;
            if (declaration->kind == syntax::DeclKind::Namespace && declaration->space)
                self(self, declaration->space->declarations);
        }
    };
    walk(walk, model.checked().analysis->files[file.index()]->declarations);
    return around;
}

void DeclarationTable::fill() {
    if (!m_model || !isVisible() || isEditing()) return; // what is being typed in a cell stays
    const auto file = m_model->fileOf(m_editor.file().toStdString());
    if (!file || m_editor.utf8() != m_model->sources()[*file].text()) return;
    const syntax::Pou* around = unitAtCursor(*m_model, *file);
    if (around == m_pou && around && m_shown == m_model) return;
    m_shown = m_model;
    m_pou = around;
    const QString unit = around ? kit::fromView(around->name.text) : QString();
    if (m_unit != unit) m_waiting.clear(); // the cursor is in another one now
    m_unit = unit;
    const int current = m_table->currentRow();
    m_isFilling = true;
    m_table->setEditTriggers(m_editor.isReadOnly()
                                 ? QAbstractItemView::NoEditTriggers
                                 : QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                                       QAbstractItemView::AnyKeyPressed);
    m_rows.clear();
    m_table->setRowCount(0);
    if (around)
        for (const syntax::VarSection* section : around->sections)
            for (const syntax::VarDecl* declaration : section->declarations)
                for (size_t i = 0; i < declaration->names.size(); ++i)
                    setRow(*section, *declaration, i, m_model->sources()[*file]);
    m_table->resizeColumnsToContents();
    m_isFilling = false;
    int chosen = std::min(current, m_table->rowCount() - 1);
    for (int row = 0; row < m_table->rowCount() && !m_toSelect.isEmpty(); ++row)
        if (m_table->item(row, Name)->text() == m_toSelect) chosen = row;
    if (chosen >= 0) m_table->setCurrentCell(chosen, Name);
    if (std::exchange(m_editsIt, false) && chosen >= 0) m_table->editItem(m_table->item(chosen, Name));
    m_toSelect.clear();
    refreshOnlineValues();
    // One change at a time: the next one waits for the analysis of this one.
    if (m_waiting.empty()) return;
    const std::function<void()> change = std::move(m_waiting.front());
    m_waiting.erase(m_waiting.begin());
    kit::post(this, [this, change] { whenUpToDate(change); });
}

void DeclarationTable::setRow(const syntax::VarSection& section, const syntax::VarDecl& declaration, size_t name,
                              const SourceText& source) {
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    m_rows.push_back({&declaration, &section, name});
    const auto set = [&](int column, const QString& text, bool editable) {
        auto* item = new QTableWidgetItem(text);
        if (!editable) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        m_table->setItem(row, column, item);
    };
    set(Section, sectionWord(section), true);
    set(Name, kit::fromView(declaration.names[name].text), true);
    set(Address, kit::fromView(declaration.address), false);
    set(Type, declaration.type ? kit::fromView(source.slice(declaration.type->range)) : QString(), true);
    set(Initial, declaration.initial ? kit::fromView(source.slice(declaration.initial->range)) : QString(), true);
    const bool isOneLine = declaration.comment.find('\n') == std::string_view::npos;
    set(Comment, kit::fromView(declaration.comment).simplified(), isOneLine);
    set(Value, {}, false);
}

/// Behind the declaration on its line, else directly above.
std::optional<SourceRange> DeclarationTable::commentOf(const syntax::VarDecl& declaration) const {
    const auto file = m_shown->fileOf(m_editor.file().toStdString());
    const std::string_view text = m_shown->sources()[*file].text();
    const auto hasNewline = [&](uint32_t begin, uint32_t end) {
        return text.substr(begin, end - begin).find('\n') != std::string_view::npos;
    };
    std::optional<SourceRange> above;
    for (const lex::Comment& each : m_shown->checked().analysis->files[file->index()]->tokens.comments) {
        if (each.begin >= declaration.range.end && !hasNewline(declaration.range.end, each.begin))
            return SourceRange{*file, each.begin, each.end};
        if (each.end > declaration.range.begin) continue;
        const std::string_view between = text.substr(each.end, declaration.range.begin - each.end);
        const size_t newline = each.begin == 0 ? std::string_view::npos : text.rfind('\n', each.begin - 1);
        const size_t line = newline == std::string_view::npos ? 0 : newline + 1;
        if (between.find_first_not_of(" \t\r\n") == std::string_view::npos &&
            std::count(between.begin(), between.end(), '\n') == 1 &&
            text.substr(line, each.begin - line).find_first_not_of(" \t") == std::string_view::npos)
            above = SourceRange{*file, each.begin, each.end};
    }
    return above;
}

std::vector<diagnostics::TextEdit> DeclarationTable::commentEdit(const syntax::VarDecl& declaration,
                                                                 const std::string& wanted) const {
    const auto file = m_shown->fileOf(m_editor.file().toStdString());
    const std::string_view text = m_shown->sources()[*file].text();
    if (const auto old = commentOf(declaration)) {
        SourceRange range = *old;
        if (wanted.empty()) {
            const bool isAbove = range.end <= declaration.range.begin;
            while (range.begin > 0 && (text[range.begin - 1] == ' ' || text[range.begin - 1] == '\t')) --range.begin;
            if (isAbove && range.end < text.size() && text[range.end] == '\n') ++range.end;
            return {{range, ""}};
        }
        const std::string_view was = text.substr(range.begin, range.length());
        const std::string marker(was.substr(0, was.starts_with("///") ? 3 : 2));
        const std::string end = marker == "(*" ? " *)" : marker == "/*" ? " */" : "";
        return {{range, marker + " " + wanted + end}};
    }
    if (wanted.empty()) return {};
    const size_t newline = std::min(text.find('\n', declaration.range.end), text.size());
    const size_t semicolon = std::min(text.find(';', declaration.range.end), newline);
    const auto at = static_cast<uint32_t>(semicolon < newline ? semicolon + 1 : declaration.range.end);
    return {{{*file, at, at},
             semicolon < newline && newline - semicolon > 1 && text[semicolon + 1] != '\r'
                 ? " (* " + wanted + " *)" // more stands on the line
                 : " // " + wanted}};
}

/// Its lines, with the comments directly above.
SourceRange DeclarationTable::linesOf(const syntax::VarDecl& declaration) const {
    SourceRange range = declaration.range;
    const std::string_view text = m_shown->sources()[range.file].text();
    const auto lineBegin = [&](uint32_t at) {
        while (at > 0 && text[at - 1] != '\n') --at;
        return at;
    };
    range.begin = lineBegin(range.begin);
    while (range.begin > 0) {
        const uint32_t above = lineBegin(range.begin - 1);
        const std::string_view line = text.substr(above, range.begin - above);
        const size_t first = line.find_first_not_of(" \t");
        if (first == std::string_view::npos) break;
        const std::string_view words = line.substr(first);
        const bool isComment = words.starts_with("//") || words.starts_with("{") ||
                               (words.starts_with("(*") && words.find("*)") != std::string_view::npos &&
                                words.find_first_not_of(" \t\r\n", words.find("*)") + 2) == std::string_view::npos);
        if (!isComment) break;
        range.begin = above;
    }
    while (range.end < text.size() && text[range.end] != '\n') ++range.end;
    if (range.end < text.size()) ++range.end;
    return range;
}

void DeclarationTable::refreshOnlineValues() {
    if (!m_values || !m_pou || !isVisible()) return;
    m_isFilling = true;
    for (int row = 0; row < m_table->rowCount() && row < static_cast<int>(m_rows.size()); ++row) {
        const auto values = m_values({{m_table->item(row, Name)->text(), kit::fromView(m_pou->name.text)}});
        m_table->item(row, Value)->setText(values.empty() ? QString() : values[0].value);
        if (!values.empty() && values[0].isBool)
            m_table->item(row, Value)->setForeground(values[0].isTrue ? kit::colors().good : kit::colors().muted);
    }
    m_isFilling = false;
}

void DeclarationTable::takeEdit(int row, int column) {
    if (m_isFilling || row >= static_cast<int>(m_rows.size()) || m_editor.isReadOnly()) return;
    const Row& edited = m_rows[static_cast<size_t>(row)];
    const QString name = kit::fromView(edited.declaration->names[edited.nameIndex].text),
                  text = m_table->item(row, column)->text().trimmed();
    whenUpToDate([this, name, column, text] { changeCell(rowOf(name), column, text); });
}

void DeclarationTable::changeCell(int row, int column, const QString& text) {
    if (row < 0) return fillAgain();
    const Row& edited = m_rows[static_cast<size_t>(row)];
    const syntax::VarDecl& declaration = *edited.declaration;
    std::vector<diagnostics::TextEdit> edits;
    if (column == Section) {
        for (const SectionKind kind : kSections)
            if (text == kit::fromView(syntax::keywordOf(kind))) return moveToSection(row, kind);
        return fillAgain();
    }
    if (column == Name) {
        const syntax::Name& name = declaration.names[edited.nameIndex];
        if (text.isEmpty() || text == kit::fromView(name.text)) return fillAgain();
        m_toSelect = text;
        fillAgain(); // the old name stays when the new one is refused
        kit::post(this, [this, offset = name.range.begin, text] { emit renameRequested(offset, text); });
        return;
    }
    if (column == Type && declaration.type && !text.isEmpty()) {
        edits.push_back({declaration.type->range, text.toStdString()});
    } else if (column == Initial && declaration.initial) {
        edits.push_back(text.isEmpty()
                            ? diagnostics::TextEdit{{declaration.type->range.file, declaration.type->range.end,
                                                     declaration.initial->range.end},
                                                    ""}
                            : diagnostics::TextEdit{declaration.initial->range, text.toStdString()});
    } else if (column == Initial && declaration.type && !text.isEmpty()) {
        edits.push_back({{declaration.type->range.file, declaration.type->range.end, declaration.type->range.end},
                         " := " + text.toStdString()});
    } else if (column == Comment) {
        edits = commentEdit(declaration, text.toStdString());
    }
    if (edits.empty()) return fillAgain();
    m_pou = nullptr; // filled again with the next analysis
    m_editor.applyEdits(edits);
}

void DeclarationTable::moveToSection(int row, SectionKind kind) {
    const Row& moved = m_rows[static_cast<size_t>(row)];
    const SourceRange lines = linesOf(*moved.declaration);
    const std::string_view text = m_shown->sources()[lines.file].text();
    const auto edits =
        analysis::moveToSection(*m_pou, *moved.section, *moved.declaration, moved.nameIndex, kind, lines, text);
    if (edits.empty()) return fillAgain();
    m_toSelect = kit::fromView(moved.declaration->names[moved.nameIndex].text);
    m_pou = nullptr;
    m_editor.applyEdits(edits);
}

void DeclarationTable::addVariable(syntax::SectionKind section) {
    if (m_editor.isReadOnly()) return;
    if (!isUpToDate()) return whenUpToDate([this, section] { addVariable(section); });
    const auto file = m_shown->fileOf(m_editor.file().toStdString());
    std::string name = "newVariable";
    const auto taken = [&](const std::string& wanted) {
        return std::any_of(m_rows.begin(), m_rows.end(), [&](const Row& row) {
            return kit::fromView(row.declaration->names[row.nameIndex].text)
                       .compare(QString::fromStdString(wanted), Qt::CaseInsensitive) == 0;
        });
    };
    for (int i = 2; taken(name); ++i) name = "newVariable" + std::to_string(i);
    const auto edit = m_shown->autoDeclare(*file, m_pou->name.range.begin, name, section);
    if (!edit) return;
    m_pou = nullptr;
    m_toSelect = QString::fromStdString(name); // and its name is typed at once
    m_editsIt = true;
    m_editor.applyEdits({*edit});
}

QStringList DeclarationTable::selectedNames() const {
    QStringList names;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        if (const auto row = static_cast<size_t>(index.row()); row < m_rows.size())
            names << kit::fromView(m_rows[row].declaration->names[m_rows[row].nameIndex].text);
    return names;
}

void DeclarationTable::removeSelected() {
    whenUpToDate([this, names = selectedNames()] { removeNamed(names); });
}

void DeclarationTable::removeNamed(const QStringList& wanted) {
    std::map<const syntax::VarDecl*, std::set<size_t>> chosen;
    for (const QString& name : wanted)
        if (const int at = rowOf(name); at >= 0) {
            const Row& row = m_rows[static_cast<size_t>(at)];
            chosen[row.declaration].insert(row.nameIndex);
        }
    std::vector<diagnostics::TextEdit> edits;
    for (const auto& [declaration, names] : chosen) {
        if (names.size() == declaration->names.size()) {
            const SourceRange lines = linesOf(*declaration);
            const std::string_view text = m_shown->sources()[lines.file].text();
            const size_t semicolon = text.find(';', declaration->range.end - 1);
            const bool sharesLine = std::any_of(m_rows.begin(), m_rows.end(), [&](const Row& other) {
                return other.declaration != declaration && other.declaration->range.begin < lines.end &&
                       other.declaration->range.end > lines.begin;
            });
            edits.push_back(
                {sharesLine ? SourceRange{lines.file, declaration->range.begin, static_cast<uint32_t>(semicolon + 1)}
                            : lines,
                 ""});
            continue;
        }
        std::string rest; // of "a, b, c : INT"
        for (size_t i = 0; i < declaration->names.size(); ++i)
            if (!names.contains(i)) rest += (rest.empty() ? "" : ", ") + std::string(declaration->names[i].text);
        SourceRange range = declaration->names.front().range;
        range.end = declaration->names.back().range.end;
        edits.push_back({range, rest});
    }
    if (edits.empty()) return;
    m_pou = nullptr;
    m_editor.applyEdits(edits);
}

void DeclarationTable::moveSelected(int direction) {
    const int row = m_table->currentRow();
    if (row < 0 || row >= static_cast<int>(m_rows.size())) return;
    if (!isUpToDate())
        return whenUpToDate([this, direction, names = selectedNames()] {
            if (names.size() != 1 || rowOf(names[0]) < 0) return;
            m_table->setCurrentCell(rowOf(names[0]), Name);
            moveSelected(direction);
        });
    const Row& moved = m_rows[static_cast<size_t>(row)];
    const auto& declarations = moved.section->declarations;
    const auto here = std::find(declarations.begin(), declarations.end(), moved.declaration) - declarations.begin();
    const auto other = here + direction;
    if (other < 0 || other >= static_cast<std::ptrdiff_t>(declarations.size())) return;
    const SourceRange first = linesOf(*declarations[static_cast<size_t>(std::min(here, other))]),
                      second = linesOf(*declarations[static_cast<size_t>(std::max(here, other))]);
    if (first.end > second.begin) return; // both on one line
    const std::string_view text = m_shown->sources()[first.file].text();
    const std::string swapped = std::string(text.substr(second.begin, second.length())) +
                                std::string(text.substr(first.end, second.begin - first.end)) +
                                std::string(text.substr(first.begin, first.length()));
    m_pou = nullptr;
    m_toSelect = m_table->item(row, Name)->text();
    m_editor.applyEdits({{{first.file, first.begin, second.end}, swapped}});
}

} // namespace plc::editor
