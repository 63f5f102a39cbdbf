#include "hmi/designer/editors/text_editor.h"

#include "editor/kit/bar_menu.h"
#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "hmi/designer/context/arrange.h"
#include "hmi/designer/editors/edit_bar.h"
#include "hmi/designer/editors/language_choice.h"
#include "hmi/texts/language.h"
#include "projects/storage/project_file.h"

#include <QAction>
#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::hmi {

TextModel::TextModel(DesignContext& context, QUndoStack& undo, QObject* parent)
    : QAbstractTableModel(parent), m_context(context), m_undo(undo) {
    const auto measure = [this] {
        m_rows = static_cast<int>(table().rows().size());
        m_columns = FirstLanguage + static_cast<int>(table().tags().size());
    };
    measure();
    connect(&context, &DesignContext::textsChanged, this, [this, measure] {
        const bool isSameShape = m_rows == static_cast<int>(table().rows().size()) &&
                                 m_columns == FirstLanguage + static_cast<int>(table().tags().size());
        if (isSameShape) {
            // A file with as many languages in another order gives other columns.
            emit headerDataChanged(Qt::Horizontal, 0, m_columns - 1);
            if (m_rows > 0) emit dataChanged(index(0, 0), index(m_rows - 1, m_columns - 1));
            return;
        }
        beginResetModel();
        measure();
        endResetModel();
    });
}

const TextTable& TextModel::table() const { return m_context.project().texts.table(); }

int TextModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : m_rows; }

int TextModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : m_columns; }

bool TextModel::isIncomplete(int row) const {
    const TextTable::Row& one = table().rows()[static_cast<size_t>(row)];
    for (const QString& tag : m_context.project().texts.settings().languages)
        if (table().text(one.key, tag).isEmpty()) return true;
    return false;
}

QVariant TextModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= static_cast<int>(table().rows().size())) return {};
    const TextTable::Row& row = table().rows()[static_cast<size_t>(index.row())];
    const bool isLanguage = index.column() >= FirstLanguage;
    const QString text = index.column() == Key       ? row.key
                         : index.column() == Comment ? row.comment
                                                     : row.texts.value(index.column() - FirstLanguage);
    if (role == Qt::DisplayRole || role == Qt::EditRole) return text;
    if (!isLanguage)
        return role == Qt::ForegroundRole && index.column() == Comment ? QVariant(kit::colors().muted) : QVariant();
    const QString tag = table().tags().value(index.column() - FirstLanguage);
    if (role == Qt::BackgroundRole && text.isEmpty() && m_context.project().texts.settings().languages.contains(tag)) {
        QColor missing = kit::colors().warning;
        missing.setAlphaF(0.22f);
        return missing;
    }
    if (role == Qt::TextAlignmentRole && isRightToLeft(tag)) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::FontRole) {
        QFont font;
        font.setFamilies(m_context.project().texts.settings().fontFamilies(tag));
        return font;
    }
    return {};
}

QVariant TextModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section + 1;
    if (section == Key) return tr("Key");
    if (section == Comment) return tr("Comment");
    const QString tag = table().tags().value(section - FirstLanguage);
    return QStringLiteral("%1 (%2)").arg(nativeName(tag), tag);
}

Qt::ItemFlags TextModel::flags(const QModelIndex& index) const {
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

void TextModel::edit(const QString& title, const std::function<void(TextTable&)>& change) {
    const TextTable before = table();
    TextTable after = before;
    change(after);
    if (after.write() == before.write()) return;
    m_undo.push(new kit::ClosureCommand(
        title, [this, after] { m_context.setTable(after); }, [this, before] { m_context.setTable(before); }));
}

bool TextModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid()) return false;
    const QString key = table().rows()[static_cast<size_t>(index.row())].key, text = value.toString();
    switch (index.column()) {
    case Key: {
        const QString to = text.trimmed();
        if (to == key || to.isEmpty() || table().contains(to)) return false;
        edit(tr("Rename key"), [&](TextTable& table) { table.renameKey(key, to); });
        // Panels and alarms follow, so that no text is lost by a rename.
        m_context.rewritePanels(tr("Rename key"), [&](const Panel& panel) { return renamedKey(panel, key, to); });
        AlarmFile alarms = m_context.project().alarms;
        bool isUsed = false;
        for (std::vector<Properties>* rows : {&alarms.rows(), &alarms.classRows()})
            for (Properties& row : *rows)
                for (const char* field : {"text", "title"})
                    if (row.text(field) == u'@' + key) row.set(field, toUtf8(u'@' + to)), isUsed = true;
        if (isUsed) m_context.setAlarms(std::move(alarms));
        return true;
    }
    case Comment:
        edit(tr("Comment"), [&](TextTable& table) { table.setComment(key, text); });
        return true;
    default: {
        const QString tag = table().tags().value(index.column() - FirstLanguage);
        edit(tr("Text"), [&](TextTable& table) { table.setText(key, tag, text); });
        return true;
    }
    }
}

namespace {

class TextFilter final : public QSortFilterProxyModel {
public:
    TextFilter(const TextModel& model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {}
    QString words;
    bool onlyIncomplete = false;
    void changed() { invalidateFilter(); }

protected:
    bool filterAcceptsRow(int row, const QModelIndex&) const override {
        if (onlyIncomplete && !m_model.isIncomplete(row)) return false;
        if (words.isEmpty()) return true;
        for (int column = 0; column < m_model.columnCount(); ++column)
            if (m_model.data(m_model.index(row, column), Qt::DisplayRole)
                    .toString()
                    .contains(words, Qt::CaseInsensitive))
                return true;
        return false;
    }

private:
    const TextModel& m_model;
};

} // namespace

TextEditor::TextEditor(DesignContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_model(new TextModel(context, m_undo, this)),
      m_proxy(new TextFilter(*m_model, this)), m_view(new QTableView), m_search(new QLineEdit),
      m_incomplete(new QCheckBox(tr("Only incomplete"))), m_users(new QLabel) {
    m_proxy->setSourceModel(m_model);
    m_view->setModel(m_proxy);
    m_view->setSortingEnabled(true);
    m_view->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    m_view->setWordWrap(true);
    m_view->setAlternatingRowColors(true);
    m_view->horizontalHeader()->setDefaultSectionSize(200);
    m_view->verticalHeader()->setDefaultSectionSize(26);
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    m_search->setPlaceholderText(tr("Search texts"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(m_search->placeholderText());
    m_search->setMinimumWidth(m_search->fontMetrics().horizontalAdvance(m_search->placeholderText()) + 24);
    m_view->setAccessibleName(tr("Texts"));
    m_users->setWordWrap(true);
    m_users->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QToolBar* bar = makeEditBar(m_undo, this);
    bar->addAction(kit::icon(kit::Icon::Add), tr("Add a key"), this, [this] {
        const auto take = [this](const QString& key) {
            if (m_model->table().contains(key)) {
                revealKey(key);
                return tr("A key %1 already exists; choose another name").arg(key);
            }
            addKey(key);
            return QString();
        };
        kit::TextQuestion(tr("Add a key"), tr("Key"), {}, take, this).ask();
    });
    bar->addAction(kit::icon(kit::Icon::Remove), tr("Remove the selected keys"), this, &TextEditor::removeSelected);
    QAction* language = bar->addAction(kit::icon(kit::Icon::Language), tr("Add a language"), this, [this] {
        const QString tag = askForLanguage(m_model->table().tags(), this);
        if (!tag.isEmpty()) addLanguage(tag);
    });
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(language)))
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addAction(kit::icon(kit::Icon::Delete), tr("Remove the language"), this, [this] {
        const int column = m_view->currentIndex().column() - TextModel::FirstLanguage;
        const QStringList tags = m_model->table().tags();
        if (column < 0 || column >= tags.size())
            m_users->setText(tr("Select a cell of the language that is to be removed."));
        else if (tags.size() < 2)
            m_users->setText(tr("A table of texts keeps one language; add another one first."));
        else
            removeLanguage(tags[column]);
    });
    bar->addSeparator();
    // The words say what the table is exchanged with: the icons are the same.
    QMenu* imports = kit::addBarMenu(*bar, kit::icon(kit::Icon::Import), tr("Import"));
    QMenu* exports = kit::addBarMenu(*bar, kit::icon(kit::Icon::Export), tr("Export"));
    imports->addAction(tr("Import CSV"), this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Import CSV"), {}, tr("Text tables (*.csv *.txt)"));
        if (!path.isEmpty()) importCsv(path);
    });
    exports->addAction(tr("Export CSV"), this, [this] {
        const QString path = QFileDialog::getSaveFileName(this, tr("Export CSV"), QStringLiteral("texts.csv"),
                                                          tr("Text tables (*.csv)"));
        if (!path.isEmpty()) exportCsv(path);
    });
    imports->addAction(tr("Import XLIFF"), this, [this] {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Import XLIFF"), {}, tr("Translations (*.xlf *.xliff)"));
        if (path.isEmpty()) return;
        if (const auto report = importXliff(path)) showReport(*report);
    });
    exports->addAction(tr("Export XLIFF"), this, &TextEditor::askForXliff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(bar);
    auto* search = new QHBoxLayout; // of its own: in the bar it has no room on a small screen
    search->addWidget(m_search);
    search->addWidget(m_incomplete);
    layout->addLayout(search);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_users);
    setFocusProxy(m_view); // not the search: Ctrl+Z is meant for the table
    m_search->installEventFilter(this);
    m_view->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view->horizontalHeader(), &QWidget::customContextMenuRequested, this, &TextEditor::showHeaderMenu);
    const auto filter = [this] { setFilter(m_search->text(), m_incomplete->isChecked()); };
    connect(m_search, &QLineEdit::textChanged, this, filter);
    connect(m_incomplete, &QCheckBox::toggled, this, filter);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &TextEditor::showUsers);
    connect(m_model, &QAbstractItemModel::modelReset, this, &TextEditor::showUsers); // a text was typed in a panel
    connect(&m_context, &DesignContext::textsTaken, &m_undo, &QUndoStack::clear);    // its steps are of another table
    showUsers();
}

void TextEditor::setFilter(const QString& text, bool onlyIncomplete) {
    auto* filter = static_cast<TextFilter*>(m_proxy);
    filter->words = text.trimmed();
    filter->onlyIncomplete = onlyIncomplete;
    filter->changed();
}

QStringList TextEditor::shownKeys() const {
    QStringList out;
    for (int row = 0; row < m_proxy->rowCount(); ++row) out += m_proxy->index(row, TextModel::Key).data().toString();
    return out;
}

void TextEditor::addKey(const QString& key) {
    m_model->edit(tr("Add key"), [&](TextTable& table) {
        table.setText(key, table.tags().value(0, m_context.language()), QString());
    });
    revealKey(key);
}

void TextEditor::removeSelected() {
    QStringList keys;
    for (const QModelIndex& index : m_view->selectionModel()->selectedIndexes())
        keys += index.siblingAtColumn(TextModel::Key).data().toString();
    m_model->edit(tr("Remove keys"), [&](TextTable& table) {
        for (const QString& key : keys) table.removeKey(key);
    });
}

void TextEditor::addLanguage(const QString& tag) {
    m_model->edit(tr("Add language"), [&](TextTable& table) { table.addLanguage(tag); });
}

void TextEditor::removeLanguage(const QString& tag) {
    m_model->edit(tr("Remove language"), [&](TextTable& table) { table.removeLanguage(tag); });
}

void TextEditor::showHeaderMenu(QPoint at) {
    const int column = m_view->horizontalHeader()->logicalIndexAt(at) - TextModel::FirstLanguage;
    const QStringList tags = m_model->table().tags();
    if (column < 0 || column >= tags.size() || tags.size() < 2) return; // one language is left
    QMenu menu(this);
    menu.addAction(kit::icon(kit::Icon::Remove), tr("Remove %1").arg(nativeName(tags[column])), this,
                   [this, tag = tags[column]] { removeLanguage(tag); });
    menu.exec(m_view->horizontalHeader()->viewport()->mapToGlobal(at));
}

/// Undo in the search line is the line's own only as long as something was typed there.
bool TextEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || watched != m_search) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isOwn = key->matches(QKeySequence::Undo)   ? m_search->isUndoAvailable()
                       : key->matches(QKeySequence::Redo) ? m_search->isRedoAvailable()
                                                          : true;
    if (!isOwn) event->ignore();
    return !isOwn;
}

void TextEditor::importCsv(const QString& path) {
    const auto bytes = projects::readFile(path.toStdString());
    const auto parsed = bytes ? TextTable::parse(*bytes, path) : Result<TextTable>(bytes.error());
    if (!parsed) {
        QMessageBox::warning(this, tr("Import CSV"), kit::messageText(parsed.error()));
        return;
    }
    // Texts of the file win; keys and languages that it does not have stay.
    m_model->edit(tr("Import CSV"), [&](TextTable& table) {
        for (const TextTable::Row& row : parsed->rows()) {
            for (qsizetype i = 0; i < parsed->tags().size(); ++i)
                if (!row.texts[i].isEmpty() || !table.contains(row.key))
                    table.setText(row.key, parsed->tags()[i], row.texts[i]);
            if (!row.comment.isEmpty()) table.setComment(row.key, row.comment);
        }
    });
}

void TextEditor::exportCsv(const QString& path) const {
    if (const auto written = projects::writeFileAtomically(path.toStdString(), m_model->table().write()); !written)
        QMessageBox::warning(const_cast<TextEditor*>(this), tr("Export CSV"), kit::messageText(written.error()));
}

void TextEditor::revealKey(const QString& key) {
    for (int row = 0; row < m_proxy->rowCount(); ++row) {
        if (m_proxy->index(row, TextModel::Key).data().toString() != key) continue;
        const QModelIndex index = m_proxy->index(row, TextModel::FirstLanguage);
        m_view->setCurrentIndex(index);
        m_view->scrollTo(index);
    }
}

void TextEditor::showUsers() {
    const QModelIndex index = m_view->currentIndex();
    if (!index.isValid()) {
        m_users->setText(tr("%n text(s)", nullptr, m_model->rowCount()));
        return;
    }
    const QString key = index.siblingAtColumn(TextModel::Key).data().toString();
    const QStringList users = m_context.usersOf(key);
    m_users->setText(users.isEmpty() ? tr("%1 is not used.").arg(key)
                                     : tr("%1 is used by %2").arg(key, users.join(QStringLiteral(", "))));
}

} // namespace plc::hmi
