#include "app/project/project_settings_dialog.h"

#include "runtime/types/string_code.h"
#include "runtime/types/value.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace plc::app {

namespace {

using Json = nlohmann::ordered_json;

// Code is the same in every language.
const char* const kSymbols = "SIMULATION, VERSION=2";
const char* const kStart = "DT#2000-01-01-00:00:00";

/// An object in project.json, or an empty one.
const Json& partOf(const Json& json, const char* name) {
    static const Json none = Json::object();
    const auto found = json.find(name);
    return found != json.end() && found->is_object() ? *found : none;
}

QString textOf(const Json& json, const char* field) {
    const auto found = json.find(field);
    return found != json.end() && found->is_string() ? QString::fromStdString(found->get<std::string>()) : QString();
}

/// Only what was changed is written; a field that says what is so without it goes away.
void put(Json& json, const char* field, const Json& value, const Json& usual) {
    if (json.value(field, usual) == value) return;
    if (value == usual)
        json.erase(field);
    else
        json[field] = value;
}
void put(Json& json, const char* field, const QString& text) { put(json, field, text.trimmed().toStdString(), ""); }

void choose(QComboBox* box, const QString& data) {
    if (box->findData(data) < 0) box->addItem(data, data); // it is in project.json, whatever it is
    box->setCurrentIndex(box->findData(data));
}

QStringList panelNames(const projects::Project& project) {
    QStringList out;
    for (const std::string& file : project.panels) out += QString::fromStdString(file).chopped(11); // .panel.json
    return out;
}

} // namespace

ProjectSettingsDialog::ProjectSettingsDialog(const projects::Project& project, QWidget* parent)
    : QDialog(parent), m_json(project.json), m_usualName(project.name) {
    setWindowTitle(tr("Project Settings"));
    m_complaint = new QLabel(this);
    m_complaint->setObjectName("complaint");
    m_complaint->setWordWrap(true);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(makeProgram(project));
    layout->addWidget(makePanels(project));
    layout->addWidget(m_complaint);
    layout->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (QLineEdit* edit : {m_name, m_symbols, m_start})
        connect(edit, &QLineEdit::textChanged, this, &ProjectSettingsDialog::judge);
    judge();
}

QWidget* ProjectSettingsDialog::makeProgram(const projects::Project& project) {
    auto* group = new QGroupBox(tr("Program"), this);
    auto* form = new QFormLayout(group);
    m_name = new QLineEdit(QString::fromStdString(project.name), group);
    m_addresses = new QComboBox(group);
    m_addresses->addItem(tr("Bytes: %MW1 is bytes 1 and 2 (TwinCAT)"), "byte");
    m_addresses->addItem(tr("Words: %MW1 is the second word (CODESYS)"), "word");
    m_addresses->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    choose(m_addresses, project.addressing == image::Addressing::Words ? "word" : "byte");
    m_strings = new QComboBox(group);
    for (const std::string& name : types::stringCodeNames())
        m_strings->addItem(QString::fromStdString(name), QString::fromStdString(name));
    choose(m_strings, QString::fromStdString(std::string(types::nameOf(project.strings))));
    QStringList symbols;
    for (const std::string& symbol : project.defines) symbols += QString::fromStdString(symbol);
    m_symbols = new QLineEdit(symbols.join(QStringLiteral(", ")), group);
    m_symbols->setPlaceholderText(QLatin1String(kSymbols));
    m_memory = new QSpinBox(group);
    m_memory->setRange(0, static_cast<int>(driver::kMostMemoryForNew));
    m_memory->setSingleStep(64 * 1024);
    m_memory->setGroupSeparatorShown(true);
    m_memory->setSuffix(tr(" bytes"));
    m_memory->setSpecialValueText(tr("None (no __NEW)"));
    m_memory->setValue(static_cast<int>(project.memoryForNew));
    m_start = new QLineEdit(QString::fromStdString(project.calendarStart), group);
    m_start->setPlaceholderText(QLatin1String(kStart));
    m_addresses->setToolTip(tr("What the number of a memory address counts"));
    m_strings->setToolTip(tr("What the bytes of STRING values stand for"));
    m_symbols->setToolTip(tr("What {IF defined (…)} in the sources finds, separated by commas"));
    m_memory->setToolTip(tr("The part of the controller's memory that __NEW takes objects from"));
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("Addressing"), m_addresses);
    form->addRow(tr("Encoding of STRING"), m_strings);
    form->addRow(tr("Defined symbols"), m_symbols);
    form->addRow(tr("Memory for __NEW"), m_memory);
    form->addRow(tr("Date and time of the first scan"), m_start);
    return group;
}

QWidget* ProjectSettingsDialog::makePanels(const projects::Project& project) {
    auto* group = new QGroupBox(tr("Panels"), this);
    auto* form = new QFormLayout(group);
    const Json& hmi = partOf(project.json, "hmi");
    m_startPanel = new QComboBox(group);
    m_frame = new QComboBox(group);
    m_startPanel->addItem(tr("The first panel"), "");
    m_frame->addItem(tr("None"), "");
    for (const QString& name : panelNames(project)) {
        m_startPanel->addItem(name, name);
        m_frame->addItem(name, name);
    }
    QString start = QString::fromStdString(project.startPanel);
    if (start.endsWith(QStringLiteral(".panel.json"))) start.chop(11);
    choose(m_startPanel, start);
    choose(m_frame, textOf(hmi, "frame"));
    m_font = new QLineEdit(QString::fromStdString(project.font), group);
    m_font->setCompleter(new QCompleter(QFontDatabase::families(), m_font));
    m_font->completer()->setCaseSensitivity(Qt::CaseInsensitive);
    m_font->completer()->setFilterMode(Qt::MatchContains);
    m_languageVariable = new QLineEdit(QString::fromStdString(project.languageVariable), group);
    m_picturesOutside = new QCheckBox(tr("Allow pictures outside the project folder"), group);
    m_picturesOutside->setChecked(hmi.contains("picturesOutside") && hmi["picturesOutside"] == true);
    m_frame->setToolTip(tr("The panel that is drawn around all others"));
    m_languageVariable->setToolTip(tr("A variable with the operator's language; panels read and write it"));
    form->addRow(tr("Start panel"), m_startPanel);
    form->addRow(tr("Frame"), m_frame);
    form->addRow(tr("Font"), m_font);
    form->addRow(tr("Language variable"), m_languageVariable);
    form->addRow(m_picturesOutside);
    return group;
}

Json ProjectSettingsDialog::json() const {
    Json out = m_json;
    put(out, "name", m_name->text().trimmed().toStdString(), m_usualName);
    put(out, "addressing", m_addresses->currentData().toString().toStdString(), "byte");
    put(out, "stringEncoding", m_strings->currentData().toString().toStdString(),
        std::string(types::nameOf(types::StringCode::Latin1)));
    Json symbols = Json::array();
    for (const QString& symbol : m_symbols->text().split(QLatin1Char(','), Qt::SkipEmptyParts))
        if (!symbol.trimmed().isEmpty()) symbols.push_back(symbol.trimmed().toStdString());
    put(out, "defines", symbols, Json::array());
    put(out, "memoryForNew", static_cast<uint32_t>(m_memory->value()), 0u);
    Json settings = partOf(out, "settings"), hmi = partOf(out, "hmi");
    put(settings, "calendarStart", m_start->text());
    put(hmi, "startPanel", m_startPanel->currentData().toString());
    put(hmi, "frame", m_frame->currentData().toString());
    put(hmi, "font", m_font->text().trimmed().toStdString(), projects::Project().font);
    put(hmi, "languageVariable", m_languageVariable->text());
    put(hmi, "picturesOutside", m_picturesOutside->isChecked(), false);
    put(out, "settings", settings, Json::object());
    put(out, "hmi", hmi, Json::object());
    return out;
}

void ProjectSettingsDialog::judge() {
    QString wrong;
    const QString start = m_start->text().trimmed();
    if (m_name->text().trimmed().isEmpty())
        wrong = tr("A project needs a name.");
    else if (!start.isEmpty() && !types::parseDateTime(start.toStdString()))
        wrong = tr("“%1” is not a date and time; write for example DT#2026-01-31-06:00:00.").arg(start);
    m_complaint->setText(wrong);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
}

} // namespace plc::app
