// The text table as a table: keys, comments, one column per language; search, missing texts, who uses a key, with undo.
// Owned by its Qt parent; the context must outlive it. Main thread.
#pragma once
#include "hmi/designer/context/design_context.h"
#include "hmi/texts/xliff.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QUndoStack>
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace plc::hmi {

class TextModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Key, Comment, FirstLanguage };
    TextModel(DesignContext& context, QUndoStack& undo, QObject* parent = nullptr);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    const TextTable& table() const;
    bool isIncomplete(int row) const;
    /// Pushes one undo step that changes the table.
    void edit(const QString& title, const std::function<void(TextTable&)>& change);

private:
    DesignContext& m_context;
    QUndoStack& m_undo;
    int m_rows = 0, m_columns = 0;
};

class TextEditor final : public QWidget {
    Q_OBJECT
public:
    explicit TextEditor(DesignContext& context, QWidget* parent = nullptr);
    QUndoStack& undoStack() { return m_undo; }
    TextModel& model() { return *m_model; }
    QTableView& view() { return *m_view; }
    void setFilter(const QString& text, bool onlyIncomplete);
    QStringList shownKeys() const;
    void addKey(const QString& key);
    void removeSelected();
    void addLanguage(const QString& tag);
    void removeLanguage(const QString& tag);
    void importCsv(const QString& path);
    void exportCsv(const QString& path) const;
    /// For translators' tools: from one language into another; taken back with a report of what does not fit.
    void exportXliff(const QString& path, const QString& from, const QString& to, XliffVersion version) const;
    std::optional<XliffReport> importXliff(const QString& path);
    void revealKey(const QString& key);

private:
    void showUsers();
    void showHeaderMenu(QPoint at);
    bool eventFilter(QObject* watched, QEvent* event) override;
    void askForXliff();
    void showReport(const XliffReport& report);
    DesignContext& m_context;
    QUndoStack m_undo;
    TextModel* m_model = nullptr;
    QSortFilterProxyModel* m_proxy = nullptr;
    QTableView* m_view = nullptr;
    QLineEdit* m_search = nullptr;
    QCheckBox* m_incomplete = nullptr;
    QLabel* m_users = nullptr;
};

} // namespace plc::hmi
