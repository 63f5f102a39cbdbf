// What is wrong with panels, texts and alarms before the operator sees it: keys, translations, placeholders, texts that
// do not fit (measured in every language with the real font), glyphs, bindings. Functions; main thread (fonts).
#pragma once
#include "hmi/alarms/alarm_file.h"
#include "hmi/check/standard_settings.h"
#include "hmi/texts/catalog.h"
#include "hmi/view/scene/panel_scene.h"
#include "hmi/view/scene/ready_faceplates.h"

namespace plc::hmi {

enum class FindingKind {
    MissingKey,
    MissingTranslation,
    OrphanKey,
    PlaceholderMismatch,
    MissingValue,
    BadPlaceholder,
    TextTooLong,
    HardCodedText,
    MissingGlyph,
    MissingFont,
    UnknownKind,
    WrongBinding,
    UnknownPanel,
    MissingImage,
    UnknownClass,
    UnknownLanguage,
    Outside,
    BadFormat,
    WrongArgument,
    FaceplateInItself,
    UnknownRole,
    WrongFrame,
    WrongRecipe,
    BadPicture = 30, // H1031
    OutOfRange,
    UnknownProperty,
    WrongPropertyType,
    BadColor,
    WrongLimits,
    BadGroup,
    UnlistedColumn,
    UnnamedControl,
    LeavesRange,
    WrongCheckSetting = 99, // H1100
    FirstStandardRule,      // H1101: the rules of standard_rules.def in their order
};

struct Finding {
    FindingKind kind{};
    bool isError = false;
    QString file; // "hmi/main.panel.json", "hmi/texts.csv", "hmi/alarms.json"
    int line = 0; // of texts.csv
    ElementId element;
    QString property; // "states[2].text"
    QString language;
    Message message;
    Message why = {}; // an explanation, for rules of good practice
    Edit fix = {};    // corrects it without a decision; of the panel in `file`
    /// "H1004", for lists and documentation.
    QString code() const;
    /// English: "hmi/main.panel.json: button1.text [de]: warning H1007: …".
    QString text() const;
};

/// What the checker says to a binding: nothing, or why it is wrong (with the near match).
using BindingCheck = std::function<Message(const QString& expression, std::string_view wanted, bool isTarget)>;

/// Names of an expression's type: its own and those that it extends or implements; none when it is wrong.
using TypeNames = std::function<QStringList(const QString& expression)>;
/// A variable of a type, for checks of what is bound to parameters; empty when the program has none.
using AnInstance = std::function<QString(const QString& type)>;

struct CheckInput {
    std::vector<NamedPanel> panels;
    TextCatalog texts;
    AlarmFile alarms;
    bool hasAlarms = false;
    QString folder;        // of the project, for image files
    QStringList languages; // to measure in; empty: all of the project
    QStringList keysUsedElsewhere;
    bool picturesOutside = false; // the project allows pictures outside its folder
    PanelThemes themes;           // of the project
    QString frame;                // of the project
    QStringList roles;            // of its people
    QStringList startPanels;      // of its people
    QString startPanel;           // of the project
    bool hasPeople = false;
    StandardSettings standard; // off unless somebody asks for it
    BindingCheck checkBinding; // may be empty, and those below with it
    TypeNames typeNames;
    AnInstance anInstance;
    std::function<bool(const QString& type)> isType; // a block or structure of the program or its libraries

    /// The project's panels, then the ready faceplates.
    PanelLookup panelLookup() const;
};

std::vector<Finding> checkPanels(const CheckInput& input);
/// Only what concerns one panel, for the designer while it is edited.
std::vector<Finding> checkPanel(const CheckInput& input, const NamedPanel& panel);
std::vector<Finding> checkFit(const CheckInput& input, const NamedPanel& panel);

/// The file of a panel, from the folder of the project.
QString panelFile(const QString& name);
/// Whether a text has words to translate; "X" and "m" are names of axes and units.
bool hasLetters(const QString& text);

} // namespace plc::hmi
