#include "app/exchange_dialogs.h"

#include "app/main_window.h"
#include "app/settings.h"
#include "editor/kit/message_text.h"
#include "editor/workspace/workspace.h"
#include "projects/exchange/imported.h"
#include "projects/exchange/plcopen_export.h"
#include "projects/storage/project_file.h"

#include <QComboBox>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::app {

namespace {

QTreeWidget* noteTable(QWidget* parent) {
    auto* table = new QTreeWidget(parent);
    table->setObjectName("notes");
    table->setHeaderLabels({ImportDialog::tr("Place"), ImportDialog::tr("Note")});
    table->setRootIsDecorated(false);
    table->setAccessibleName(ImportDialog::tr("Report"));
    table->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    return table;
}

void fill(QTreeWidget& table, const exchange::Report& report) {
    table.clear();
    for (const bool losses : {true, false})
        for (const exchange::Note& note : report.notes) {
            const bool isLoss = exchange::severityOf(note.kind) == exchange::NoteSeverity::Loss;
            if (isLoss != losses) continue;
            auto* row =
                new QTreeWidgetItem(&table, {QString::fromStdString(note.place), kit::messageText(note.message)});
            row->setToolTip(1, kit::messageText(note.message));
            QFont font = row->font(1);
            font.setBold(isLoss);
            row->setFont(1, font);
        }
}

/// Keywords as they are; the elements of a file in words.
QString titleOfUnits(const std::string& name) {
    static const std::map<std::string, const char*> titles = {
        {"pou", QT_TRANSLATE_NOOP("plc::app::ImportDialog", "program units")},
        {"dataType", QT_TRANSLATE_NOOP("plc::app::ImportDialog", "data types")},
        {"globalVars", QT_TRANSLATE_NOOP("plc::app::ImportDialog", "global variable lists")},
        {"configuration", QT_TRANSLATE_NOOP("plc::app::ImportDialog", "configurations")},
        {"text", QT_TRANSLATE_NOOP("plc::app::ImportDialog", "texts")},
        {"file", QT_TRANSLATE_NOOP("plc::app::ImportDialog", "files")}};
    const auto title = titles.find(name);
    return title == titles.end() ? QString::fromStdString(name) : ImportDialog::tr(title->second);
}

QString figures(const std::map<std::string, int>& counts) {
    QStringList out;
    for (const auto& [name, count] : counts) out << QStringLiteral("%1 %2").arg(titleOfUnits(name)).arg(count);
    return out.isEmpty() ? QStringLiteral("–") : out.join(QStringLiteral(", "));
}

QString summaryOf(const exchange::Report& report) {
    return ImportDialog::tr("Objects: %1\nBodies: %2\nNot kept: %3")
        .arg(figures(report.units), figures(report.bodies))
        .arg(report.losses());
}

/// The wait cursor while it lives.
struct Waiting {
    Waiting() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
    ~Waiting() { QGuiApplication::restoreOverrideCursor(); }
    Waiting(const Waiting&) = delete;
};

QWidget* withButtons(QLineEdit* edit, std::initializer_list<QPushButton*> buttons) {
    auto* row = new QWidget(edit->parentWidget());
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(edit, 1);
    for (QPushButton* button : buttons) layout->addWidget(button);
    return row;
}

} // namespace

// ------------------------------------------------------------------ import

ImportDialog::ImportDialog(const QString& projectsFolder, QWidget* parent)
    : QDialog(parent), m_projectsFolder(projectsFolder) {
    setWindowTitle(tr("Import a Project"));
    resize(QSize(1000, 680).boundedTo(screen()->availableSize() - QSize(24, 48))); // with its frame
    m_source = new QLineEdit(this);
    m_source->setReadOnly(true);
    m_source->setAccessibleName(tr("From:"));
    m_source->setPlaceholderText(tr("PLCopen XML, TwinCAT, CODESYS, ST"));
    const int hint = m_source->fontMetrics().horizontalAdvance(m_source->placeholderText());
    m_source->setMinimumWidth(hint + 4 * m_source->fontMetrics().averageCharWidth()); // whole at 200 %, too
    m_source->setToolTip(tr("PLCopen XML, TwinCAT or CODESYS files, structured text"));
    m_target = new QLineEdit(this);
    m_target->setObjectName("target");
    m_target->setAccessibleName(tr("New project in:"));
    auto* file = new QPushButton(tr("File…"), this);
    auto* folder = new QPushButton(tr("Folder…"), this);
    m_files = new QTreeWidget(this);
    m_files->setObjectName("files");
    m_files->setHeaderHidden(true);
    m_files->setRootIsDecorated(false);
    m_files->setAccessibleName(tr("Source files"));
    m_text = new QPlainTextEdit(this);
    m_text->setReadOnly(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setAccessibleName(tr("Preview"));
    m_notes = noteTable(this);
    m_summary = new QLabel(this);
    m_complaint = new QLabel(this);
    m_complaint->setObjectName("complaint");
    m_complaint->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_import = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    m_import->setObjectName("import");

    auto* form = new QFormLayout;
    form->addRow(tr("From:"), withButtons(m_source, {file, folder}));
    form->addRow(tr("New project in:"), m_target);
    auto* sides = new QSplitter(this);
    sides->addWidget(m_files);
    sides->addWidget(m_text);
    sides->setStretchFactor(1, 1);
    auto* parts = new QSplitter(Qt::Vertical, this);
    parts->addWidget(sides);
    parts->addWidget(m_notes);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(parts, 1);
    layout->addWidget(m_summary);
    layout->addWidget(m_complaint);
    layout->addWidget(buttons);
    setTabOrder(m_source, file);
    setTabOrder(file, folder);
    setTabOrder(folder, m_target);

    connect(file, &QPushButton::clicked, this, [this] { choose(false); });
    connect(folder, &QPushButton::clicked, this, [this] { choose(true); });
    connect(m_files, &QTreeWidget::currentItemChanged, this, &ImportDialog::showFile);
    connect(m_target, &QLineEdit::textChanged, this, &ImportDialog::check);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        if (write()) accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
}

QString ImportDialog::folder() const { return m_target->text(); }

void ImportDialog::choose(bool isFolder) {
    const QString path = isFolder ? QFileDialog::getExistingDirectory(this, windowTitle(), QDir::homePath())
                                  : QFileDialog::getOpenFileName(
                                        this, windowTitle(), QDir::homePath(),
                                        tr("Projects of other tools (%1)")
                                                .arg("*.xml *.TcPOU *.TcDUT *.TcGVL *.TcIO *.EXP *.exp *.export *.st") +
                                            ";;" + tr("All files (*)"));
    if (!path.isEmpty()) preview(path);
}

void ImportDialog::preview(const QString& path) {
    m_source->setText(QDir::toNativeSeparators(path));
    m_files->clear();
    m_text->clear();
    m_notes->clear();
    m_imported.reset();
    m_summary->clear();
    const auto imported = [&] {
        const Waiting waiting;
        return exchange::importFrom(path.toStdString());
    }();
    if (!imported) return complain(imported.error());
    m_imported = std::make_shared<const exchange::Imported>(*imported);
    for (const exchange::ImportedFile& file : m_imported->files)
        new QTreeWidgetItem(m_files, {QString::fromStdString(file.path)});
    fill(*m_notes, m_imported->report);
    m_summary->setText(summaryOf(m_imported->report));
    QString target = m_projectsFolder + "/" + QString::fromStdString(exchange::fileNameOf(m_imported->name));
    const QString stem = target;
    for (int i = 2; QFileInfo::exists(target); ++i) target = stem + "_" + QString::number(i);
    m_target->setText(target);
    if (QTreeWidgetItem* first = m_files->topLevelItem(0)) m_files->setCurrentItem(first);
    check();
}

void ImportDialog::complain(const Error& error) {
    check();
    m_complaint->setText(kit::messageText(error));
}

void ImportDialog::showFile() {
    const int row = m_files->indexOfTopLevelItem(m_files->currentItem());
    if (!m_imported || row < 0 || static_cast<size_t>(row) >= m_imported->files.size()) return;
    m_text->setPlainText(QString::fromStdString(m_imported->files[static_cast<size_t>(row)].text));
}

void ImportDialog::check() {
    const QFileInfo target(m_target->text());
    const bool isTaken = target.exists() && (!target.isDir() || !QDir(target.filePath()).isEmpty());
    m_complaint->setText(m_imported && isTaken ? tr("This folder is not empty; name a new one") : QString());
    m_import->setEnabled(m_imported && !m_target->text().isEmpty() && !isTaken);
}

bool ImportDialog::write() {
    if (!m_imported) return false;
    const auto written = exchange::writeImported(*m_imported, m_target->text().toStdString());
    if (!written) m_complaint->setText(kit::messageText(written.error()));
    return static_cast<bool>(written);
}

// ------------------------------------------------------------------ export

ExportDialog::ExportDialog(const projects::Project& project, QWidget* parent) : QDialog(parent), m_project(project) {
    setWindowTitle(tr("Export the Project"));
    resize(800, 480);
    m_version = new QComboBox(this);
    m_version->setObjectName("version");
    m_version->addItem(tr("PLCopen XML 0200, for CODESYS and TwinCAT"));
    m_version->addItem(tr("PLCopen XML 0201, for Beremiz and OpenPLC"));
    m_target = new QLineEdit(this);
    m_target->setAccessibleName(tr("To:"));
    m_target->setText(QString::fromStdString(project.folder) + "/" +
                      QString::fromStdString(exchange::fileNameOf(project.name)) + ".xml");
    auto* browse = new QPushButton(tr("File…"), this);
    m_notes = noteTable(this);
    m_summary = new QLabel(this);
    m_complaint = new QLabel(this);
    m_complaint->setObjectName("complaint");
    m_complaint->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    auto* form = new QFormLayout;
    form->addRow(tr("Format:"), m_version);
    form->addRow(tr("To:"), withButtons(m_target, {browse}));
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_notes, 1);
    layout->addWidget(m_summary);
    layout->addWidget(m_complaint);
    layout->addWidget(buttons);
    connect(m_version, &QComboBox::currentIndexChanged, this, &ExportDialog::preview);
    connect(browse, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getSaveFileName(this, windowTitle(), m_target->text(), "*.xml");
        if (!path.isEmpty()) m_target->setText(path);
    });
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        if (write()) accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    preview();
}

void ExportDialog::setTarget(const QString& path) { m_target->setText(path); }

void ExportDialog::preview() {
    m_exported.reset();
    m_complaint->clear();
    m_summary->clear();
    m_notes->clear();
    exchange::ExportOptions options;
    options.edition = m_version->currentIndex() == 0 ? exchange::Edition::Codesys0200 : exchange::Edition::Plain0201;
    options.time = QDateTime::currentDateTimeUtc().toString("yyyy-MM-ddTHH:mm:ss").toStdString();
    const auto exported = [&] {
        const Waiting waiting;
        return exchange::exportPlcopen(m_project, options);
    }();
    m_export->setEnabled(static_cast<bool>(exported));
    if (!exported) return m_complaint->setText(kit::messageText(exported.error()));
    m_exported = std::make_shared<const exchange::Exported>(*exported);
    fill(*m_notes, m_exported->report);
    m_summary->setText(summaryOf(m_exported->report));
}

bool ExportDialog::write() {
    if (!m_exported) return false;
    const auto written = projects::writeFileAtomically(m_target->text().toStdString(), m_exported->text);
    if (!written) m_complaint->setText(kit::messageText(written.error()));
    return static_cast<bool>(written);
}

// ------------------------------------------------------------------ the actions

void importProject(MainWindow& window) {
    ImportDialog dialog(window.settings().projectsFolder(), &window);
    if (dialog.exec() == QDialog::Accepted) window.openProject(dialog.folder());
}

void exportProject(MainWindow& window) {
    if (!window.workspace().isOpen()) return;
    if (auto saved = window.workspace().saveAll(); !saved) return window.say(kit::messageText(saved.error()), true);
    const auto project = projects::openProject({window.workspace().folder().toStdString()});
    if (!project) return window.say(kit::messageText(project.error()), true);
    ExportDialog dialog(*project, &window);
    if (dialog.exec() == QDialog::Accepted) window.say(MainWindow::tr("The project was exported"));
}

} // namespace plc::app
