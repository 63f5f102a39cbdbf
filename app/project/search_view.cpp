#include "app/project/search_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/long_task.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace plc::app {

namespace {
constexpr int kElement = Qt::UserRole + 3; // of a panel; set where the row is none of a source

/// The element of a panel's text in which a place is.
QString elementAt(const QString& text, qsizetype at) {
    static const QRegularExpression id("\"id\": \"([^\"]*)\"");
    QString found;
    for (auto matches = id.globalMatch(text.left(text.indexOf('\n', at))); matches.hasNext();)
        found = matches.next().captured(1);
    return found;
}
} // namespace

SearchView::SearchView(editor::Workspace& workspace, QWidget* parent) : QWidget(parent), m_workspace(workspace) {
    m_text = new QLineEdit(this);
    m_text->setPlaceholderText(tr("Find in all files"));
    m_text->setAccessibleName(tr("Text to find in all files"));
    m_replacement = new QLineEdit(this);
    m_replacement->setPlaceholderText(tr("Replace with"));
    m_replacement->setAccessibleName(tr("Replacement in all files"));
    m_case = new QCheckBox(tr("Match case"), this);
    m_regex = new QCheckBox(tr("Regular expression"), this);
    auto* find = new QPushButton(tr("Find"), this);
    auto* replace = new QPushButton(tr("Replace All"), this);
    m_summary = new QLabel(this);
    m_results = new QTreeWidget(this);
    m_results->setHeaderLabels({tr("Place"), tr("Use"), tr("Line")});
    m_results->setRootIsDecorated(false);
    m_results->setUniformRowHeights(true);
    m_results->setAlternatingRowColors(true);
    m_results->setAccessibleName(tr("Search results"));
    m_results->header()->setStretchLastSection(true);
    m_results->setColumnWidth(0, 190);
    m_results->setColumnWidth(1, 90);
    auto* words = new QHBoxLayout; // a row of their own: beside the rest they have no room on a small screen
    words->setContentsMargins(6, 4, 6, 0);
    words->addWidget(m_text);
    words->addWidget(m_replacement);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(6, 4, 6, 4);
    row->addWidget(m_case);
    row->addWidget(m_regex);
    row->addWidget(find);
    row->addWidget(replace);
    row->addWidget(m_summary, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(words);
    layout->addLayout(row);
    layout->addWidget(m_results);
    connect(m_text, &QLineEdit::returnPressed, this, &SearchView::search);
    connect(find, &QPushButton::clicked, this, &SearchView::search);
    connect(replace, &QPushButton::clicked, this, &SearchView::replaceAll);
    connect(m_results, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (item->data(0, kElement).isValid())
            return emit panelPlaceRequested(item->data(0, Qt::UserRole).toString(), item->data(0, kElement).toString());
        emit placeRequested(item->data(0, Qt::UserRole).toString(), item->data(0, Qt::UserRole + 1).toUInt(),
                            item->data(0, Qt::UserRole + 2).toUInt());
    });
    connect(m_results, &QTreeWidget::itemClicked, m_results, &QTreeWidget::itemActivated);
}

void SearchView::openSearch(const QString& text) {
    if (!text.isEmpty()) m_text->setText(text);
    m_text->setFocus();
    m_text->selectAll();
}

void SearchView::addLine(const QString& file, const SourceText& source, SourceRange range, const QString& kind) {
    const uint32_t line = source.lineColumn(range.begin).line;
    const std::string_view text = source.line(line);
    auto* item =
        new QTreeWidgetItem(m_results, {QString("%1:%2").arg(file).arg(line), kind, kit::fromView(text).trimmed()});
    item->setFont(2, QFont("Noto Sans Mono"));
    item->setForeground(0, kit::colors().muted);
    item->setData(0, Qt::UserRole, file);
    item->setData(0, Qt::UserRole + 1, range.begin);
    item->setData(0, Qt::UserRole + 2, range.length());
}

void SearchView::search() {
    m_results->clear();
    if (m_text->text().isEmpty() || !m_workspace.isOpen()) return;
    const QRegularExpression pattern(m_regex->isChecked() ? m_text->text() : QRegularExpression::escape(m_text->text()),
                                     m_case->isChecked() ? QRegularExpression::MultilineOption
                                                         : QRegularExpression::MultilineOption |
                                                               QRegularExpression::CaseInsensitiveOption);
    if (!pattern.isValid()) return m_summary->setText(tr("Invalid regular expression: %1").arg(pattern.errorString()));
    int files = 0;
    const std::map<QString, std::string> panels = m_panelTexts ? m_panelTexts() : std::map<QString, std::string>();
    QStringList all = m_workspace.files();
    for (const auto& [file, text] : panels) all << file;
    kit::LongTask task(tr("Searching all files…"), this);
    for (qsizetype i = 0; i < all.size(); ++i) {
        const QString& file = all[i];
        if (!task.reached(static_cast<double>(i) / static_cast<double>(all.size()))) break;
        const auto panel = panels.find(file);
        const std::string text = panel == panels.end() ? m_workspace.text(file) : panel->second;
        const SourceText source(file.toStdString(), text);
        const QString content = QString::fromStdString(text);
        bool any = false;
        qsizetype counted = 0; // characters whose bytes are in `begin`
        uint32_t begin = 0;
        for (auto matches = pattern.globalMatch(content); matches.hasNext() && m_results->topLevelItemCount() < 5000;) {
            const auto match = matches.next();
            if (match.capturedLength() == 0) continue;
            begin += static_cast<uint32_t>(
                QStringView(content).mid(counted, match.capturedStart() - counted).toUtf8().size());
            counted = match.capturedStart();
            addLine(file, source, {FileId(0), begin, begin + static_cast<uint32_t>(match.captured().toUtf8().size())},
                    {});
            if (panel != panels.end())
                m_results->topLevelItem(m_results->topLevelItemCount() - 1)
                    ->setData(0, kElement, elementAt(content, match.capturedStart()));
            any = true;
            if (m_results->topLevelItemCount() % 200 == 0 &&
                !task.reached(
                    (static_cast<double>(i) + static_cast<double>(counted) / static_cast<double>(content.size() + 1)) /
                    static_cast<double>(all.size())))
                break;
        }
        files += any;
    }
    m_summary->setText(
        (task.isCancelled() ? tr("Cancelled; so far: %1 in %2") : tr("%1 in %2"))
            .arg(tr("%n place(s)", nullptr, m_results->topLevelItemCount()), tr("%n file(s)", nullptr, files)));
}

int SearchView::replaceAll() {
    const QRegularExpression pattern(m_regex->isChecked() ? m_text->text() : QRegularExpression::escape(m_text->text()),
                                     m_case->isChecked() ? QRegularExpression::MultilineOption
                                                         : QRegularExpression::MultilineOption |
                                                               QRegularExpression::CaseInsensitiveOption);
    if (!pattern.isValid() || m_text->text().isEmpty()) return 0;
    QString replacement = m_replacement->text();
    if (!m_regex->isChecked()) replacement.replace('\\', "\\\\");
    int count = 0;
    std::map<QString, std::string> changed; // nothing is replaced before all is known: a cancel changes nothing
    const QStringList all = m_workspace.files();
    kit::LongTask task(tr("Replacing in all files…"), this);
    for (qsizetype i = 0; i < all.size(); ++i) {
        const QString& file = all[i];
        if (!task.reached(static_cast<double>(i) / static_cast<double>(all.size()))) {
            emit message(tr("Cancelled; nothing was replaced"), false);
            return 0;
        }
        QString content = QString::fromStdString(m_workspace.text(file));
        int here = 0;
        for (auto matches = pattern.globalMatch(content); matches.hasNext(); matches.next()) ++here;
        if (!here) continue;
        count += here;
        content.replace(pattern, replacement);
        changed[file] = content.toStdString();
    }
    if (!changed.empty()) emit textsReplaced(changed);
    search();
    emit message(tr("%n place(s) replaced", nullptr, count), false);
    return count;
}

void SearchView::showUses(const QString& name, const std::vector<analysis::Use>& uses, const SourceSet& sources,
                          const std::vector<PanelUse>& inPanels) {
    m_results->clear();
    int reads = 0, writes = 0;
    for (const analysis::Use& use : uses) {
        reads += use.isRead;
        writes += use.isWrite;
        const SourceText& source = sources[use.range.file];
        addLine(QString::fromStdString(source.path()), source, use.range,
                use.isDeclaration           ? tr("declared")
                : use.isWrite && use.isRead ? tr("read, write")
                : use.isWrite               ? tr("write")
                                            : tr("read"));
    }
    for (const PanelUse& use : inPanels) {
        reads += !use.isWrite;
        writes += use.isWrite;
        auto* item = new QTreeWidgetItem(m_results, {QString("%1: %2").arg(use.file, use.element),
                                                     use.isWrite ? tr("write") : tr("read"), use.text});
        item->setForeground(0, kit::colors().muted);
        item->setData(0, Qt::UserRole, use.file);
        item->setData(0, kElement, use.element);
    }
    m_summary->setText(tr("%1: %2 read, %3 written").arg(name).arg(reads).arg(writes));
}

} // namespace plc::app
