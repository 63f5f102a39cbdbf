// The declarations of a program unit as a table: section, name, address, type, initial value, comment, and the value
// while online. The text stays the truth: an edit of a cell is a text edit of its declaration (D4). Owned by the tab;
// GUI thread.
#pragma once
#include "editor/text/st_editor.h"

#include <QTableWidget>
#include <QWidget>

#include <functional>

class QToolBar;

namespace plc::editor {

class DeclarationTable : public QWidget {
    Q_OBJECT
public:
    explicit DeclarationTable(StEditor& editor, QWidget* parent = nullptr);
    /// Shows the unit around the editor's cursor, as of the newest analysis.
    void setModel(std::shared_ptr<const analysis::CodeModel> model);
    void setOnlineValues(OnlineValues values) { m_values = std::move(values); }
    void refreshOnlineValues();
    [[nodiscard]] QTableWidget& table() { return *m_table; }
    void addVariable(syntax::SectionKind section);
    void removeSelected();
    void moveSelected(int direction); // within its section, with its comments
    /// The variable of a row goes to a section of another kind.
    void moveToSection(int row, syntax::SectionKind kind);

signals:
    /// The name at this place of the editor's file gets another one, in the whole project.
    void renameRequested(uint32_t offset, const QString& name);

private:
    enum Column { Section, Name, Address, Type, Initial, Comment, Value, Count };
    struct Row {
        const syntax::VarDecl* declaration = nullptr;
        const syntax::VarSection* section = nullptr;
        size_t nameIndex = 0;
    };
    void fill();
    void takeEdit(int row, int column);
    void fillAgain();
    [[nodiscard]] bool isUpToDate() const; // the rows' places are those of the text
    [[nodiscard]] bool isEditing() const;
    /// Now, or when the analysis of the present text is there: an edit of the table waits for it.
    void whenUpToDate(std::function<void()> change);
    [[nodiscard]] int rowOf(const QString& name) const;
    [[nodiscard]] QStringList selectedNames() const;
    void removeNamed(const QStringList& names);
    void changeCell(int row, int column, const QString& text);
    const syntax::Pou* unitAtCursor(const analysis::CodeModel& model, FileId file) const;
    void makeBar(QToolBar& bar);
    void setRow(const syntax::VarSection& section, const syntax::VarDecl& declaration, size_t name,
                const SourceText& source);
    [[nodiscard]] std::optional<SourceRange> commentOf(const syntax::VarDecl& declaration) const;
    [[nodiscard]] SourceRange linesOf(const syntax::VarDecl& declaration) const;
    [[nodiscard]] std::vector<diagnostics::TextEdit> commentEdit(const syntax::VarDecl& declaration,
                                                                 const std::string& text) const;

    StEditor& m_editor;
    QTableWidget* m_table;
    std::shared_ptr<const analysis::CodeModel> m_model;
    std::shared_ptr<const analysis::CodeModel> m_shown; // whose declarations the rows are
    const syntax::Pou* m_pou = nullptr;
    QString m_unit; // its name, also while the next analysis is waited for
    std::vector<std::function<void()>> m_waiting;
    std::vector<Row> m_rows;
    OnlineValues m_values;
    bool m_isFilling = false;
    QString m_toSelect; // a name that is chosen when the table is filled next
    bool m_editsIt = false;
};

} // namespace plc::editor
