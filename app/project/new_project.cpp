#include "app/project/new_project.h"

#include "app/settings/settings.h"
#include "editor/kit/icons.h"
#include "editor/kit/theme.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <filesystem>

namespace plc::app {

namespace {

bool isName(const QString& text) {
    diagnostics::Sink sink;
    const std::string name = text.toStdString();
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), name, sink);
    return list.tokens.size() == 2 && list.tokens[0].kind == lex::TokenKind::Identifier && !sink.hasErrors();
}

constexpr const char* kConfiguration = R"(
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);
        PROGRAM Main WITH Fast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

struct File {
    std::string path, text;
};

std::vector<File> motorFiles() {
    return {{"src/main.st", std::string(R"(/// Starts and stops a motor; stop wins.
PROGRAM Main
VAR
    Start AT %IX0.0 : BOOL;        // button, normally open
    Stop AT %IX0.1 : BOOL := TRUE; // button, normally closed: FALSE means pressed or wire broken
    Motor AT %QX0.0 : BOOL;        // contactor
END_VAR
Motor := (Start OR Motor) AND Stop;
END_PROGRAM
)") + kConfiguration},
            {"src/plant.st", R"(/// The hand on the buttons and the motor behind the contactor.
{attribute 'simulation'}
PROGRAM Plant
VAR
    StartButton : BOOL; // TRUE: pressed
    StopButton : BOOL;  // TRUE: pressed
    Speed : REAL;       // [rpm]
END_VAR
Main.Start := StartButton;
Main.Stop := NOT StopButton;
IF Main.Motor THEN
    Speed := MIN(Speed + 7.25, 1450.0);
ELSE
    Speed := MAX(Speed - 7.25, 0.0);
END_IF
END_PROGRAM
)"},
            {"tests/motor.st", R"(TEST 'starts, holds and stops'
Plant.StartButton := TRUE;
RUN T#50ms;
Plant.StartButton := FALSE;
RUN T#3s;
ASSERT Main.Motor, 'holds itself';
Plant.StopButton := TRUE;
RUN T#50ms;
ASSERT NOT Main.Motor;
END_TEST
)"}};
}

std::vector<File> pidFiles() {
    return {{"src/main.st", std::string(R"(/// A temperature loop: the controller moves the heater, the plant warms up.
PROGRAM Main
VAR
    SetPoint : REAL := 50.0;           // [°C]
    Measured AT %ID0 : REAL;           // [°C]
    Heater AT %QD0 : REAL;             // [%]
    Kp : REAL := 4.0;
    Tn : REAL := 8000.0;               // [ms]
    pid : FB_PID;
    limits : stPid := (xActValType := TRUE, rTargCyclTime := 10.0, rLowLim := 0.0, rHighLim := 100.0);
END_VAR
pid(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Kp, i_rTn := Tn, i_rTd := 20.0, i_stPid := limits, q_rPidOput => Heater);
END_PROGRAM
)") + kConfiguration},
            {"src/plant.st", R"(/// A vessel that the heater warms and the room cools.
{attribute 'simulation'}
PROGRAM Plant
VAR
    Temperature : REAL := 20.0; // [°C]
    Room : REAL := 20.0;        // [°C]
    Gain : REAL := 0.8;         // [K per %] at rest
    TimeConstant : REAL := 20.0; // [s]
END_VAR
Temperature := Temperature + (Room + Gain * Main.Heater - Temperature) * 0.01 / TimeConstant;
Main.Measured := Temperature;
END_PROGRAM
)"},
            {"tests/loop.st", R"(TEST 'reaches the set point'
RUN T#5m;
ASSERT ABS(Main.SetPoint - Main.Measured) < 1.0;
END_TEST
)"}};
}

std::vector<File> sequenceFiles() {
    return {{"src/main.st", std::string(R"(/// Fill, mix, empty: a sequential function chart.
PROGRAM Main
VAR
    Start : BOOL;
    Full : BOOL;
    Empty : BOOL := TRUE;
    Valve AT %QX0.0 : BOOL;
    Mixer AT %QX0.1 : BOOL;
    Drain AT %QX0.2 : BOOL;
END_VAR

INITIAL_STEP Ready:
END_STEP

STEP Fill:
    Valve(N);
END_STEP

STEP Mix:
    Mixer(N);
END_STEP

STEP Discharge:
    Drain(N);
END_STEP

TRANSITION FROM Ready TO Fill := Start AND Empty; END_TRANSITION
TRANSITION FROM Fill TO Mix := Full; END_TRANSITION
TRANSITION FROM Mix TO Discharge := Mix.T >= T#3s; END_TRANSITION
TRANSITION FROM Discharge TO Ready := Empty; END_TRANSITION
END_PROGRAM
)") + kConfiguration},
            {"src/plant.st", R"(/// A tank with a full and an empty switch.
{attribute 'simulation'}
PROGRAM Plant
VAR
    Level : REAL; // [%]
END_VAR
IF Main.Valve THEN
    Level := MIN(Level + 0.25, 100.0);
END_IF
IF Main.Drain THEN
    Level := MAX(Level - 0.25, 0.0);
END_IF
Main.Full := Level >= 95.0;
Main.Empty := Level <= 1.0;
END_PROGRAM
)"},
            {"tests/cycle.st", R"(TEST 'runs a whole cycle'
Main.Start := TRUE;
RUN UNTIL Main.Valve FOR T#1s;
Main.Start := FALSE;
RUN UNTIL Main.Mixer FOR T#10s;
RUN UNTIL Main.Drain FOR T#5s;
RUN UNTIL Main.Empty FOR T#10s;
RUN T#100ms;
ASSERT NOT Main.Drain;
END_TEST
)"}};
}

std::vector<File> emptyFiles() {
    return {{"src/main.st", std::string(R"(PROGRAM Main
VAR
    counter : INT;
END_VAR
counter := counter + 1;
END_PROGRAM
)") + kConfiguration}};
}

std::vector<File> filesOf(const std::string& id) {
    if (id == "motor") return motorFiles();
    if (id == "pid") return pidFiles();
    if (id == "sequence") return sequenceFiles();
    return emptyFiles();
}

} // namespace

const std::vector<ProjectTemplate>& projectTemplates() {
    static const std::vector<ProjectTemplate> all = {
        {"empty", QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "Empty"),
         QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "One program in a task of 10 ms")},
        {"motor", QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "Motor"),
         QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "Start, stop, a simulated motor and a test")},
        {"pid", QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "PID loop"),
         QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "A temperature loop with its plant")},
        {"sequence", QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "Sequence"),
         QT_TRANSLATE_NOOP("plc::app::NewProjectDialog", "Fill, mix, empty as a sequential function chart")},
    };
    return all;
}

Result<void> createProject(const std::string& folder, const std::string& name, const std::string& templateId) {
    namespace fs = std::filesystem;
    std::error_code problem;
    if (fs::exists(folder, problem) && !fs::is_empty(folder, problem)) return Error{errors::FolderInUse(), folder};
    for (const char* part : {"src", "tests", "hmi", "traces"}) {
        fs::create_directories(fs::path(folder) / part, problem);
        if (problem) return Error{errors::FolderNotCreated(errors::ofSystem(problem)), folder};
    }
    nlohmann::ordered_json json;
    json["name"] = name;
    json["libraries"] = templateId == "pid" ? std::vector<std::string>{"toolbox"} : std::vector<std::string>{};
    json["hmi"] = {{"languages", {"en"}}};
    if (auto written = projects::writeFileAtomically(folder + "/project.json", json.dump(2) + "\n"); !written)
        return written;
    for (const File& file : filesOf(templateId))
        if (auto written = projects::writeFileAtomically(folder + "/" + file.path, file.text); !written) return written;
    return {};
}

Result<void> copyProject(const std::string& from, const std::string& to) {
    namespace fs = std::filesystem;
    std::error_code problem;
    fs::create_directories(to, problem);
    if (problem) return Error{errors::FolderNotCreated(errors::ofSystem(problem)), to};
    for (fs::recursive_directory_iterator it(from, problem), end; !problem && it != end; it.increment(problem)) {
        const fs::path name = it->path().filename();
        if (name.string().starts_with('.') || name.extension() == ".retain") {
            if (it->is_directory()) it.disable_recursion_pending();
            continue;
        }
        const fs::path target = fs::path(to) / fs::relative(it->path(), from, problem);
        if (it->is_directory())
            fs::create_directories(target, problem);
        else
            fs::copy_file(it->path(), target, fs::copy_options::overwrite_existing, problem);
        if (problem) return Error{errors::FileNotCopied(errors::ofSystem(problem)), it->path().string()};
        fs::permissions(target, fs::perms::owner_write, fs::perm_options::add,
                        problem); // the original may be read-only
    }
    if (problem) return Error{errors::FolderNotRead(errors::ofSystem(problem)), from};
    return {};
}

Result<ExampleCopy> copyExample(const QString& example, const QString& projects, bool fresh) {
    const QString name = QFileInfo(example).fileName();
    QString copy = projects + "/" + name;
    for (int i = 2; fresh && QFile::exists(copy); ++i) copy = projects + "/" + name + "_" + QString::number(i);
    const bool isNew = !QFile::exists(copy + "/project.json");
    if (isNew)
        if (auto copied = copyProject(example.toStdString(), copy.toStdString()); !copied) return copied.error();
    return ExampleCopy{copy, isNew};
}

const std::vector<UnitTemplate>& unitTemplates() {
    static const std::vector<UnitTemplate> all = {
        {"program", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Program"), "program"},
        {"block", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Function block"), "block"},
        {"function", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Function"), "function"},
        {"struct", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Structure"), "type"},
        {"enum", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Enumeration"), "type"},
        {"interface", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Interface"), "interface"},
        {"globals", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Global variables"), "globals"},
        {"chart", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Sequential function chart"), "chart"},
        {"ladder", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Program as a ladder diagram"), "program"},
        {"blocks", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Program as a function block diagram"), "program"},
        {"simulation", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Simulation of the plant"), "plant"},
        {"test", QT_TRANSLATE_NOOP("plc::app::NewUnitDialog", "Test"), "test"},
    };
    return all;
}

std::string unitText(const std::string& id, const std::string& name) {
    if (id == "program") return "/// What it does.\nPROGRAM " + name + "\nVAR\nEND_VAR\n\nEND_PROGRAM\n";
    if (id == "ladder" || id == "blocks")
        return std::string("/// What it does.\n{attribute 'view' := '") + (id == "ladder" ? "ladder" : "fbd") +
               "'}\nPROGRAM " + name + "\nVAR\nEND_VAR\n\nEND_PROGRAM\n";
    if (id == "block")
        return "/// What it does.\nFUNCTION_BLOCK " + name +
               "\nVAR_INPUT\nEND_VAR\nVAR_OUTPUT\nEND_VAR\nVAR\nEND_VAR\n\nEND_FUNCTION_BLOCK\n";
    if (id == "function")
        return "/// What it gives.\nFUNCTION " + name + " : INT\nVAR_INPUT\n    x : INT;\nEND_VAR\n" + name +
               " := x;\nEND_FUNCTION\n";
    if (id == "struct") return "TYPE " + name + " :\nSTRUCT\n    value : REAL;\nEND_STRUCT\nEND_TYPE\n";
    if (id == "enum") return "TYPE " + name + " : (First, Second) := First; END_TYPE\n";
    if (id == "interface") return "INTERFACE " + name + "\nMETHOD Start : BOOL\nEND_METHOD\nEND_INTERFACE\n";
    if (id == "globals") return "{gvl " + name + "}\nVAR_GLOBAL\n    value : INT;\nEND_VAR\n";
    if (id == "chart")
        return "PROGRAM " + name +
               "\nVAR\n    go : BOOL;\nEND_VAR\n\nINITIAL_STEP Ready:\nEND_STEP\n\nSTEP Work:\nEND_STEP\n\nTRANSITION "
               "FROM Ready TO Work := go; END_TRANSITION\nTRANSITION FROM Work TO Ready := NOT go; "
               "END_TRANSITION\nEND_PROGRAM\n";
    if (id == "simulation") return "{attribute 'simulation'}\nPROGRAM " + name + "\nVAR\nEND_VAR\n\nEND_PROGRAM\n";
    return "TEST '" + name + "'\nRUN T#1s;\nASSERT TRUE;\nEND_TEST\n";
}

// ------------------------------------------------------------------ dialogs

NewProjectDialog::NewProjectDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("New Project"));
    m_templates = new QListWidget(this);
    m_templates->setAccessibleName(tr("Template"));
    for (const ProjectTemplate& each : projectTemplates()) {
        auto* item =
            new QListWidgetItem(kit::icon(kit::Icon::Project), tr(each.title) + "\n" + tr(each.summary), m_templates);
        item->setData(Qt::UserRole, each.id);
    }
    m_templates->setCurrentRow(0);
    m_templates->setIconSize({28, 28});
    m_templates->setSpacing(3);
    m_name = new QLineEdit(tr("My machine"), this);
    m_parent = new QLineEdit(Settings().projectsFolder(), this);
    auto* browse = new QToolButton(this);
    browse->setIcon(kit::icon(kit::Icon::Folder));
    browse->setAccessibleName(tr("Choose a folder"));
    connect(browse, &QToolButton::clicked, this, [this] {
        const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder of the project"), m_parent->text());
        if (!chosen.isEmpty()) m_parent->setText(chosen);
    });
    auto* parentRow = new QHBoxLayout;
    parentRow->addWidget(m_parent);
    m_parent->setAccessibleName(tr("In folder"));
    parentRow->addWidget(browse);
    m_complaint = new QLabel(this);
    m_complaint->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("In folder"), parentRow);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_create = buttons->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_templates);
    layout->addLayout(form);
    layout->addWidget(m_complaint);
    layout->addWidget(buttons);
    connect(m_name, &QLineEdit::textChanged, this, &NewProjectDialog::check);
    connect(m_parent, &QLineEdit::textChanged, this, &NewProjectDialog::check);
    resize(520, 420);
    check();
}

QString NewProjectDialog::name() const { return m_name->text().trimmed(); }
QString NewProjectDialog::folder() const {
    QString file = name().toLower();
    for (QChar& c : file)
        if (!c.isLetterOrNumber()) c = '_';
    return m_parent->text() + "/" + file;
}
QString NewProjectDialog::templateId() const {
    return m_templates->currentItem() ? m_templates->currentItem()->data(Qt::UserRole).toString() : "empty";
}

void NewProjectDialog::check() {
    QString complaint;
    if (name().isEmpty())
        complaint = tr("Enter a project name");
    else if (QDir(folder()).exists() && !QDir(folder()).isEmpty())
        complaint = tr("%1 already exists and is not empty; choose another name").arg(folder());
    QPalette palette = m_complaint->palette();
    palette.setColor(QPalette::WindowText, complaint.isEmpty() ? kit::colors().muted : kit::colors().bad);
    m_complaint->setPalette(palette);
    m_complaint->setText(complaint.isEmpty() ? tr("Will be created in %1").arg(folder()) : complaint);
    m_create->setEnabled(complaint.isEmpty());
}

NewUnitDialog::NewUnitDialog(const QStringList& files, std::set<std::string> taken, QWidget* parent)
    : QDialog(parent), m_files(files), m_taken(std::move(taken)) {
    setWindowTitle(tr("New"));
    m_kind = new QComboBox(this);
    for (const UnitTemplate& each : unitTemplates()) m_kind->addItem(tr(each.title), each.id);
    m_name = new QLineEdit(this);
    m_file = new QComboBox(this);
    m_file->addItem(tr("a file of its own"), QString());
    for (const QString& file : files) m_file->addItem(file, file);
    m_complaint = new QLabel(this);
    m_complaint->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("Kind"), m_kind);
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("In"), m_file);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_create = buttons->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_complaint);
    layout->addWidget(buttons);
    connect(m_name, &QLineEdit::textChanged, this, &NewUnitDialog::check);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &NewUnitDialog::check);
    connect(m_file, &QComboBox::currentIndexChanged, this, &NewUnitDialog::check);
    resize(420, 180);
    m_name->setFocus();
    check();
}

QString NewUnitDialog::name() const { return m_name->text().trimmed(); }
QString NewUnitDialog::templateId() const { return m_kind->currentData().toString(); }
QString NewUnitDialog::file() const {
    if (!m_file->currentData().toString().isEmpty()) return m_file->currentData().toString();
    QString base = name().toLower();
    for (QChar& c : base)
        if (!c.isLetterOrNumber()) c = '_';
    return (templateId() == "test" ? "tests/" : "src/") + base.left(80) + ".st";
}

void NewUnitDialog::preset(const QString& templateId, const QString& file) {
    if (const int index = m_kind->findData(templateId); index >= 0 && !templateId.isEmpty())
        m_kind->setCurrentIndex(index);
    if (const int index = m_file->findData(file); index >= 0 && !file.isEmpty()) m_file->setCurrentIndex(index);
}

void NewUnitDialog::check() {
    QString complaint;
    if (name().isEmpty())
        complaint = tr("Enter a name");
    else if (templateId() != "test" && !isName(name()))
        complaint = tr("A name has letters, digits and _, starts with a letter and is not a keyword");
    else if (templateId() != "test" && m_taken.contains(foldCase(name().toStdString())))
        complaint = tr("%1 already exists in the project; choose another name").arg(name());
    else if (m_file->currentData().toString().isEmpty() && m_files.contains(file(), Qt::CaseInsensitive))
        complaint = tr("A file %1 already exists: choose it, or another name").arg(file());
    m_complaint->setText(complaint);
    m_create->setEnabled(complaint.isEmpty());
}

} // namespace plc::app
