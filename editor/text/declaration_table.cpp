#include "editor/text/declaration_table.h"

#include "editor/kit/icons.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::editor {

namespace {
QString sectionWord(const syntax::VarSection& section) {
    static const char* const words[] = {"VAR",      "VAR_INPUT",  "VAR_OUTPUT",   "VAR_IN_OUT", "VAR_TEMP",  "VAR_STAT",
                                        "VAR_INST", "VAR_GLOBAL", "VAR_EXTERNAL", "VAR_ACCESS", "VAR_CONFIG"};
    QString out = words[static_cast<size_t>(section.kind)];
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
    auto* bar = new QToolBar(this);
    bar->setIconSize({16, 16});
    connect(bar->addAction(kit::icon(kit::Icon::Add), tr("Add a variable")), &QAction::triggered, this,
            &DeclarationTable::addVariable);
    connect(bar->addAction(kit::icon(kit::Icon::Remove), tr("Remove the selected variables")), &QAction::triggered,
            this, &DeclarationTable::removeSelected);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_table);
    connect(m_table, &QTableWidget::cellChanged, this, &DeclarationTable::takeEdit);
    connect(&m_editor, &StEditor::cursorMoved, this, [this] { fill(); });
}

void DeclarationTable::setModel(std::shared_ptr<const analysis::CodeModel> model) {
    m_model = std::move(model);
    m_pou = nullptr;
    fill();
}

void DeclarationTable::fill() {
    if (!m_model || !isVisible()) return;
    const auto file = m_model->fileOf(m_editor.file().toStdString());
    if (!file || m_editor.utf8() != m_model->sources()[*file].text()) return;
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
    walk(walk, m_model->checked().analysis->files[file->index()]->declarations);
    if (around == m_pou && around) return;
    m_pou = around;
    m_isFilling = true;
    m_rows.clear();
    m_table->setRowCount(0);
    const SourceText& source = m_model->sources()[*file];
    if (around)
        for (const syntax::VarSection* section : around->sections)
            for (const syntax::VarDecl* declaration : section->declarations)
                for (size_t i = 0; i < declaration->names.size(); ++i) {
                    const int row = m_table->rowCount();
                    m_table->insertRow(row);
                    m_rows.push_back({declaration, section, i});
                    const auto set = [&](int column, const QString& text, bool editable) {
                        auto* item = new QTableWidgetItem(text);
                        if (!editable) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
                        m_table->setItem(row, column, item);
                    };
                    set(Section, sectionWord(*section), false);
                    set(Name, kit::fromView(declaration->names[i].text), true);
                    set(Address, kit::fromView(declaration->address), false);
                    set(Type, declaration->type ? kit::fromView(source.slice(declaration->type->range)) : QString(),
                        true);
                    set(Initial,
                        declaration->initial ? kit::fromView(source.slice(declaration->initial->range)) : QString(),
                        true);
                    set(Comment, kit::fromView(declaration->comment), false);
                    set(Value, {}, false);
                }
    m_table->resizeColumnsToContents();
    m_isFilling = false;
    refreshOnlineValues();
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
    if (m_isFilling || row >= static_cast<int>(m_rows.size())) return;
    const Row& edited = m_rows[static_cast<size_t>(row)];
    const QString text = m_table->item(row, column)->text().trimmed();
    const syntax::VarDecl& declaration = *edited.declaration;
    std::vector<diagnostics::TextEdit> edits;
    if (column == Name && !text.isEmpty()) {
        const auto file = m_model->fileOf(m_editor.file().toStdString());
        const auto renamed =
            m_model->rename(*file, declaration.names[edited.nameIndex].range.begin, text.toStdString());
        if (renamed)
            for (const analysis::FileEdits& each : *renamed)
                if (each.file == *file) edits = each.edits;
    } else if (column == Type && declaration.type && !text.isEmpty()) {
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
    }
    m_pou = nullptr; // filled anew with the next analysis
    if (!edits.empty()) m_editor.applyEdits(edits);
}

void DeclarationTable::addVariable() {
    if (!m_model || !m_pou) return;
    const auto file = m_model->fileOf(m_editor.file().toStdString());
    std::string name = "newVariable";
    const auto taken = [&](const std::string& wanted) {
        return std::any_of(m_rows.begin(), m_rows.end(), [&](const Row& row) {
            return kit::fromView(row.declaration->names[row.nameIndex].text)
                       .compare(QString::fromStdString(wanted), Qt::CaseInsensitive) == 0;
        });
    };
    for (int i = 2; taken(name); ++i) name = "newVariable" + std::to_string(i);
    const auto edit = m_model->autoDeclare(*file, m_pou->name.range.begin, name);
    m_pou = nullptr;
    if (edit) m_editor.applyEdits({*edit});
}

void DeclarationTable::removeSelected() {
    std::vector<diagnostics::TextEdit> edits;
    const std::string text = m_editor.utf8();
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        const syntax::VarDecl& declaration = *m_rows[static_cast<size_t>(index.row())].declaration;
        if (declaration.names.size() > 1) continue; // shared declarations are edited in the text
        SourceRange range = declaration.range;
        while (range.begin > 0 && (text[range.begin - 1] == ' ' || text[range.begin - 1] == '\t')) --range.begin;
        while (range.end < text.size() && text[range.end] != '\n') ++range.end;
        if (range.end < text.size()) ++range.end;
        edits.push_back({range, ""});
    }
    m_pou = nullptr;
    if (!edits.empty()) m_editor.applyEdits(edits);
}

} // namespace plc::editor
