#include "app/exchange/exchange_dialogs.h"

#include "editor/kit/long_task.h"
#include "editor/kit/message_text.h"
#include "editor/workspace/workspace.h"
#include "projects/exchange/import.h"
#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"

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

    addEncodings();
    auto* form = new QFormLayout;
    form->addRow(tr("From:"), withButtons(m_source, {file, folder}));
    form->addRow(tr("Encoding:"), m_encoding);
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
    setTabOrder(folder, m_encoding);
    setTabOrder(m_encoding, m_target);

    connect(file, &QPushButton::clicked, this, [this] { choose(false); });
    connect(folder, &QPushButton::clicked, this, [this] { choose(true); });
    connect(m_encoding, &QComboBox::activated, this, &ImportDialog::readAgain);
    connect(m_files, &QTreeWidget::currentItemChanged, this, &ImportDialog::showCurrent);
    connect(m_files, &QTreeWidget::itemChanged, this, &ImportDialog::check);
    connect(m_target, &QLineEdit::textChanged, this, &ImportDialog::check);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
}

QString ImportDialog::folder() const {
    return QString::fromStdString(exchange::folderOf(chosen(), 0, m_target->text().toStdString()));
}

void ImportDialog::choose(bool isFolder) {
    const QString path =
        isFolder ? QFileDialog::getExistingDirectory(this, windowTitle(), QDir::homePath())
                 : QFileDialog::getOpenFileName(this, windowTitle(), QDir::homePath(),
                                                tr("Projects of other tools (%1)")
                                                        .arg("*.xml *.sln *.tsproj *.plcproj *.TcPOU *.TcDUT *.TcGVL "
                                                             "*.TcIO *.EXP *.exp *.export *.st") +
                                                    ";;" + tr("All files (*)"));
    if (!path.isEmpty()) preview(path);
}

/// Only code pages: Unicode is recognised whatever is chosen.
void ImportDialog::addEncodings() {
    m_encoding = new QComboBox(this);
    m_encoding->setObjectName("encoding");
    m_encoding->setAccessibleName(tr("Encoding:"));
    m_encoding->setToolTip(tr("For files that are not in Unicode and do not specify their encoding"));
    m_encoding->addItem(tr("Recognised"));
    for (const std::string& name : projects::codePageNames())
        m_encoding->addItem(QString::fromStdString(name), QString::fromStdString(name));
}

/// With another encoding; the folder that was chosen stays.
void ImportDialog::readAgain() {
    if (m_path.isEmpty()) return;
    const QString target = m_target->text();
    preview(m_path);
    if (!m_projects.empty() && !target.isEmpty()) m_target->setText(target);
}

void ImportDialog::clear() {
    m_projects.clear();
    m_shown = -1;
    m_files->clear();
    m_text->clear();
    m_notes->clear();
    m_summary->clear();
    m_complaint->clear();
}

void ImportDialog::preview(const QString& path) {
    clear();
    m_path = path;
    m_source->setText(QDir::toNativeSeparators(path));
    std::optional<Result<std::vector<exchange::Imported>>> imported;
    const auto encoding = projects::encodingNamed(m_encoding->currentData().toString().toStdString());
    const QString label = tr("Reading %1…").arg(QFileInfo(path).fileName());
    const bool isDone = kit::LongTask::runAside(label, this, [&](Progress& progress) {
        exchange::ImportOptions options;
        options.progress = &progress;
        options.codePage = encoding;
        imported = exchange::importProjects(path.toStdString(), options);
    });
    if (!isDone) return complain({errors::Cancelled(), ""}); // even where all had been read by then
    if (!*imported) return complain(imported->error());
    m_projects = std::move(**imported);
    const std::string name = m_projects.size() == 1 ? m_projects.front().name : QDir(path).dirName().toStdString();
    QString target = m_projectsFolder + "/" + QString::fromStdString(exchange::fileNameOf(name));
    const QString stem = target;
    for (int i = 2; QFileInfo::exists(target); ++i) target = stem + "_" + QString::number(i);
    m_target->setText(target);
    showProjects();
    check();
}

/// The files of one project; of several the projects, with their files below them.
void ImportDialog::showProjects() {
    const QSignalBlocker blocker(m_files);
    const bool areSeveral = m_projects.size() > 1;
    m_files->setRootIsDecorated(areSeveral);
    for (const exchange::Imported& project : m_projects) {
        QTreeWidgetItem* parent = m_files->invisibleRootItem();
        if (areSeveral) {
            parent = new QTreeWidgetItem(m_files, {QString::fromStdString(project.name)});
            parent->setCheckState(0, Qt::Checked);
            parent->setToolTip(0, tr("Becomes a separate project with the libraries it uses"));
        }
        for (const exchange::ImportedFile& file : project.files)
            new QTreeWidgetItem(parent, {QString::fromStdString(file.path)});
    }
    m_files->setCurrentItem(m_files->topLevelItem(0));
    showCurrent();
}

std::pair<int, int> ImportDialog::current() const {
    QTreeWidgetItem* item = m_files->currentItem();
    if (!item) return {-1, -1};
    if (m_projects.size() == 1) return {0, m_files->indexOfTopLevelItem(item)};
    if (!item->parent()) return {m_files->indexOfTopLevelItem(item), -1};
    return {m_files->indexOfTopLevelItem(item->parent()), item->parent()->indexOfChild(item)};
}

void ImportDialog::showCurrent() {
    const auto [index, file] = current();
    if (index < 0 || static_cast<size_t>(index) >= m_projects.size()) return;
    const exchange::Imported& project = m_projects[static_cast<size_t>(index)];
    if (m_shown != index) {
        fill(*m_notes, project.report);
        m_summary->setText(summaryOf(project.report));
        m_shown = index;
    }
    const bool isFile = file >= 0 && static_cast<size_t>(file) < project.files.size();
    m_text->setPlainText(isFile ? QString::fromStdString(project.files[static_cast<size_t>(file)].text) : QString());
}

std::vector<exchange::Imported> ImportDialog::chosen() const {
    if (m_projects.size() < 2) return m_projects;
    std::vector<exchange::Imported> out;
    for (int i = 0; i < m_files->topLevelItemCount(); ++i)
        if (m_files->topLevelItem(i)->checkState(0) == Qt::Checked) out.push_back(m_projects[static_cast<size_t>(i)]);
    return out;
}

void ImportDialog::complain(const Error& error) {
    check();
    m_complaint->setText(kit::messageText(error));
}

void ImportDialog::check() {
    const QFileInfo target(m_target->text());
    const bool isTaken = target.exists() && (!target.isDir() || !QDir(target.filePath()).isEmpty());
    const bool isChosen = m_projects.size() == 1 || !chosen().empty();
    m_complaint->setText(!m_projects.empty() && isTaken ? tr("This folder is not empty; name a new one") : QString());
    m_import->setEnabled(!m_projects.empty() && isChosen && !m_target->text().isEmpty() && !isTaken);
}

void ImportDialog::accept() {
    if (write()) QDialog::accept();
}

bool ImportDialog::write() {
    const std::vector<exchange::Imported> projects = chosen();
    if (projects.empty()) return false;
    Result<void> written;
    kit::LongTask::runAside(tr("Writing the project…"), this, [&](Progress& progress) {
        written = exchange::writeProjects(projects, m_target->text().toStdString(), &progress);
    });
    if (!written) complain(written.error());
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
    connect(m_target, &QLineEdit::textChanged, this, &ExportDialog::check);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    preview();
}

void ExportDialog::check() {
    const QFileInfo target(m_target->text());
    m_export->setEnabled(m_exported && !m_target->text().isEmpty() && !target.isDir());
    if (m_exported) m_complaint->setText(target.isFile() ? tr("This file exists and will be replaced") : QString());
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
    m_export->setEnabled(false);
    if (!exported) return m_complaint->setText(kit::messageText(exported.error()));
    m_exported = std::make_shared<const exchange::Exported>(*exported);
    fill(*m_notes, m_exported->report);
    m_summary->setText(summaryOf(m_exported->report));
    check();
}

void ExportDialog::accept() {
    if (write()) QDialog::accept();
}

bool ExportDialog::write() {
    if (!m_exported) return false;
    const auto written = projects::writeFileAtomically(m_target->text().toStdString(), m_exported->text);
    if (!written) m_complaint->setText(kit::messageText(written.error()));
    return static_cast<bool>(written);
}

} // namespace plc::app
