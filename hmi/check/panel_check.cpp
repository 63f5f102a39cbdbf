#include "hmi/check/panel_check.h"
#include "hmi/check/unread_panels.h"

#include "hmi/check/application_check.h"
#include "hmi/check/faceplate_check.h"
#include "hmi/check/property_check.h"
#include "hmi/check/standard_check.h"
#include "hmi/model/array_index.h"
#include "hmi/model/errors.h"
#include "hmi/model/walk.h"
#include "hmi/view/element_factory.h"

#include <QFontDatabase>
#include <QFontMetrics>
#include <QSet>

namespace plc::hmi {

QString panelFile(const QString& name) { return QStringLiteral("hmi/%1.panel.json").arg(name); }

bool hasLetters(const QString& text) {
    int letters = 0;
    for (const QChar c : text) letters += c.isLetter();
    return letters >= 2;
}

namespace {

const QString kTextFile = QStringLiteral("hmi/texts.csv");
const QString kAlarmFile = QStringLiteral("hmi/alarms.json");

/// "{a}", "{b}": as they are written in a text.
std::vector<std::string> bracedNames(const QStringList& names) {
    std::vector<std::string> out;
    for (const QString& name : names) out.push_back("{" + toUtf8(name) + "}");
    return out;
}

struct Checker {
    const CheckInput& input;
    std::vector<Finding> found;
    QSet<QString> usedKeys;

    const TextTable& table() const { return input.texts.table(); }
    const LanguageSettings& settings() const { return input.texts.settings(); }
    QStringList languages() const { return input.languages.isEmpty() ? settings().languages : input.languages; }

    void add(FindingKind kind, bool isError, const QString& file, const ElementId& element, const QString& property,
             Message message, const QString& language = {}, int line = 0) {
        found.push_back({kind, isError, file, line, element, property, language, std::move(message)});
    }

    /// A text of an element or alarm with the placeholders that it can fill.
    void checkText(const QString& file, const ElementId& id, const Found& text, const QStringList& names,
                   bool hasFixedLanguage) {
        if (!isTextKey(text.text)) {
            const bool isGiven = !parameterNames(text.text).isEmpty(); // by whoever places the panel
            if (hasLetters(text.text) && settings().languages.size() > 1 && !hasFixedLanguage && !isGiven)
                add(FindingKind::HardCodedText, false, file, id, text.place(),
                    errors::TextWithoutKey(toUtf8(text.text)));
            checkNames(file, id, text, text.text, {}, names);
            return;
        }
        const QString key = keyOf(text.text);
        usedKeys += key;
        const int row = table().rowOf(key);
        if (row < 0) {
            add(FindingKind::MissingKey, true, file, id, text.place(), errors::KeyMissing(toUtf8(key)));
            return;
        }
        for (const QString& tag : table().tags()) {
            const QString words = table().text(key, tag);
            if (!words.isEmpty()) checkNames(file, id, text, words, tag, names);
        }
    }

    void checkNames(const QString& file, const ElementId& id, const Found& text, const QString& words,
                    const QString& tag, const QStringList& names) {
        const TextTemplate parts = TextTemplate::parse(words);
        if (!parts.error.isEmpty() && tag.isEmpty())
            add(FindingKind::BadPlaceholder, true, file, id, text.place(), parts.error);
        for (const QString& name : parts.names())
            if (!names.contains(name))
                add(FindingKind::MissingValue, true, file, id, text.place(),
                    errors::ValueForTextMissing("{" + toUtf8(name) + "}"), tag);
    }

    void checkLists(const QString& file, const ElementId& id, const Properties& properties) {
        forEachTextList(properties, [&](const Found& list) {
            const QString prefix = isTextKey(list.text) ? keyOf(list.text) : list.text;
            const int length = table().listLength(prefix);
            if (length == 0)
                add(FindingKind::MissingKey, true, file, id, list.place(),
                    errors::TextListEmpty(toUtf8(prefix), toUtf8(prefix) + ".0"));
            for (int i = 0; i < length; ++i) usedKeys += prefix + u'.' + QString::number(i);
        });
    }

    void checkBindings(const QString& file, const ElementId& id, const Properties& properties, bool hasIndex = false) {
        if (!input.checkBinding) return;
        forEachBinding(properties, [&](const Found& binding) {
            if (binding.type == PropertyType::Arguments) return; // by the parameters' types: checkPlacements
            QString expression = binding.text;
            if (hasIndex) { // tried with the first index
                const int first = properties.integer("first");
                expression = withIndex(expression, first, first, first);
            }
            Message complaint =
                input.checkBinding(expression, wantedType(properties, binding), binding.type == PropertyType::Target);
            if (!complaint.isEmpty())
                add(FindingKind::WrongBinding, true, file, id, binding.place(), std::move(complaint));
        });
    }

    void checkElement(const QString& file, const Panel& panel, const Element& element) {
        const ElementId id = element.id();
        if (element.kind() == ElementKind::Unknown)
            add(FindingKind::UnknownKind, false, file, id, QStringLiteral("kind"),
                errors::ElementKindUnknown(toUtf8(element.text("kind"))));
        QStringList names;
        if (const Json& values = element.at("values"); values.is_object())
            for (const auto& [name, expression] : values.items()) names += QString::fromStdString(name);
        const QString fixed = element.text("language");
        if (!fixed.isEmpty() && table().columnOf(fixed) < 0 && !settings().languages.contains(fixed))
            add(FindingKind::UnknownLanguage, true, file, id, QStringLiteral("language"),
                errors::NoLanguage(toUtf8(fixed)));
        forEachText(element, [&](const Found& text) { checkText(file, id, text, names, !fixed.isEmpty()); });
        checkLists(file, id, element);
        if (parametersOf(panel).empty())
            checkBindings(file, id, element,
                          element.kind() == ElementKind::ArrayTable || element.kind() == ElementKind::CellGrid);
        if (const QRectF rect = element.rect(); !QRectF(QPointF(), panel.size()).intersects(rect))
            add(FindingKind::Outside, false, file, id, QStringLiteral("rect"), errors::ElementOutside());
        for (const PropertyDescriptor& property : element.descriptor().properties) {
            const QString value = element.text(property.key);
            const QString name = QString::fromStdString(std::string(property.key));
            if (property.type == PropertyType::Panel && !value.isEmpty()) {
                if (!value.contains(u'$') && !input.panelLookup()(value))
                    add(FindingKind::UnknownPanel, true, file, id, name, errors::NoPanel(toUtf8(value)));
            }
            if (property.key == "format" && !value.isEmpty() && !NumberFormat::parse(value))
                add(FindingKind::BadFormat, true, file, id, name,
                    errors::FormatUnknown(toUtf8(value), Verbatim("%.1f"), Verbatim("%d")));
            if (element.kind() == ElementKind::Button && property.key == "tag" &&
                element.text("action") == QStringLiteral("language") && !settings().languages.contains(value))
                add(FindingKind::UnknownLanguage, true, file, id, name, errors::NoLanguage(toUtf8(value)));
        }
    }

    void checkPanel(const NamedPanel& named) {
        const QString file = panelFile(named.name);
        forEachText(named.panel, [&](const Found& text) { checkText(file, {}, text, {}, false); });
        for (const Element& element : named.panel.elements()) checkElement(file, named.panel, element);
        for (PropertyFinding& one : checkProperties(input, named.panel)) {
            add(one.kind, one.isError, file, one.element, one.property, std::move(one.message));
            found.back().fix = std::move(one.fix);
        }
        append(checkPlacements(input, named));
        append(checkAccess(input, named));
        append(checkStandard(input, named));
        if (!parametersOf(named.panel).empty()) append(checkParameterBindings(input, named));
    }

    void append(std::vector<Finding> more) {
        for (Finding& one : more) found.push_back(std::move(one));
    }

    void checkAlarms() {
        QSet<QString> classes;
        for (const AlarmClass& one : input.alarms.classes()) classes += one.name;
        for (const Properties& row : input.alarms.classRows())
            forEachText(row, [&](const Found& text) { checkText(kAlarmFile, row.text("name"), text, {}, false); });
        for (const Properties& row : input.alarms.rows()) {
            const ElementId id = row.text("id");
            QStringList names;
            if (const Json& values = row.at("values"); values.is_object())
                for (const auto& [name, expression] : values.items()) names += QString::fromStdString(name);
            forEachText(row, [&](const Found& text) { checkText(kAlarmFile, id, text, names, false); });
            checkBindings(kAlarmFile, id, row);
            if (row.text("condition").isEmpty())
                add(FindingKind::WrongBinding, true, kAlarmFile, id, QStringLiteral("condition"),
                    errors::AlarmWithoutCondition());
            const QString own = row.text("class");
            if (!own.isEmpty() && !classes.isEmpty() && !classes.contains(own))
                add(FindingKind::UnknownClass, true, kAlarmFile, id, QStringLiteral("class"),
                    errors::NoAlarmClass(toUtf8(own)));
        }
    }

    void checkTable() {
        if (!table().rows().empty())
            for (const QString& tag : table().tags())
                if (!settings().languages.contains(tag, Qt::CaseInsensitive))
                    add(FindingKind::UnlistedColumn, false, kTextFile, {}, {}, errors::ColumnNotInProject(toUtf8(tag)),
                        tag, 1);
        for (const QString& key : input.keysUsedElsewhere) usedKeys += key;
        for (const TextTable::Row& row : table().rows()) {
            if (!usedKeys.contains(row.key) && !row.key.startsWith(QStringLiteral("hmi.")))
                add(FindingKind::OrphanKey, false, kTextFile, {}, row.key, errors::KeyUnused(toUtf8(row.key)), {},
                    row.line);
            QStringList names;
            QString namesOf;
            for (qsizetype i = 0; i < table().tags().size(); ++i) {
                const QString tag = table().tags()[i], words = row.texts.value(i);
                if (words.isEmpty()) continue;
                const TextTemplate parts = TextTemplate::parse(words);
                if (!parts.error.isEmpty())
                    add(FindingKind::BadPlaceholder, true, kTextFile, {}, row.key, parts.error, tag, row.line);
                if (namesOf.isEmpty()) {
                    names = parts.names();
                    namesOf = tag;
                } else if (parts.names() != names) {
                    add(FindingKind::PlaceholderMismatch, true, kTextFile, {}, row.key,
                        errors::PlaceholdersDiffer(toUtf8(tag), bracedNames(parts.names()), toUtf8(namesOf),
                                                   bracedNames(names)),
                        tag, row.line);
                }
            }
            if (!usedKeys.contains(row.key)) continue;
            for (const QString& tag : settings().languages) {
                bool has = false;
                for (QString one = tag; !one.isEmpty() && !has;
                     one = one.contains(u'-') ? one.left(one.lastIndexOf(u'-')) : QString())
                    has = !table().text(row.key, one).isEmpty();
                if (!has)
                    add(FindingKind::MissingTranslation, false, kTextFile, {}, row.key,
                        errors::TranslationMissing(toUtf8(row.key), toUtf8(tag)), tag, row.line);
            }
        }
    }

    void checkFonts() {
        if (!QFontDatabase::hasFamily(settings().font))
            add(FindingKind::MissingFont, true, QStringLiteral("project.json"), {}, QStringLiteral("font"),
                errors::FontMissing(toUtf8(settings().font)));
        for (const TextTable::Row& row : table().rows())
            for (qsizetype i = 0; i < table().tags().size(); ++i) {
                const QString tag = table().tags()[i];
                if (!settings().languages.contains(tag)) continue;
                QFont font;
                font.setFamilies(settings().fontFamilies(tag));
                const QFontMetrics metrics(font);
                for (const uint c : row.texts.value(i).toUcs4()) {
                    if (c < 0x20 || c == 0xAD || (c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) ||
                        (c >= 0x2066 && c <= 0x2069) || metrics.inFontUcs4(c))
                        continue;
                    add(FindingKind::MissingGlyph, true, kTextFile, {}, row.key,
                        errors::GlyphMissing(toUtf8(QStringLiteral("U+%1").arg(c, 4, 16, QLatin1Char('0')))), tag,
                        row.line);
                    break;
                }
            }
    }

    void checkFit(const NamedPanel& named) {
        // Alarm texts are measured by the lists that show them.
        AlarmBook book;
        book.setFile(input.alarms);
        PanelScene scene{makeElementView};
        scene.setMeasuring(true);
        scene.setTexts(&input.texts);
        scene.setAlarms(&book);
        scene.setFolder(input.folder);
        scene.setPicturesOutside(input.picturesOutside);
        scene.setFaceplates(input.panelLookup());
        scene.setThemes(input.themes);
        scene.setPanel(named.panel);
        QSet<QString> said;
        for (const QString& tag : languages()) {
            scene.setLanguage(tag);
            scene.refresh(0);
            for (const auto& view : scene.views()) {
                const QString fixed = view->element().text("language");
                std::vector<TextBox> boxes;
                view->collectTexts(fixed.isEmpty() ? tag : fixed, boxes);
                for (const TextBox& box : boxes) {
                    if (fits(box)) continue;
                    // Said where the faceplate is drawn, unless the text comes from here.
                    if (scene.isInner(*view) && !dependsOnArguments(scene, *view, box.property)) continue;
                    const QString place = view->element().id() + u'.' + box.property;
                    if (said.contains(place + tag + box.text)) continue;
                    said += place + tag + box.text;
                    const QSizeF needed = neededSize(box);
                    const QString shown = box.text.size() > 60 ? box.text.left(57) + u'…' : box.text;
                    const bool isTooWide = needed.width() > box.rect.width() + 0.5;
                    const auto pixels = [](double length) { return static_cast<int64_t>(length); };
                    Message message = isTooWide ? errors::TextTooWide(toUtf8(shown), pixels(std::ceil(needed.width())),
                                                                      pixels(std::floor(box.rect.width())))
                                                : errors::TextTooHigh(toUtf8(shown), pixels(std::ceil(needed.height())),
                                                                      pixels(std::floor(box.rect.height())));
                    add(FindingKind::TextTooLong, false, panelFile(named.name), view->element().id(), box.property,
                        std::move(message), fixed.isEmpty() ? tag : fixed);
                }
            }
        }
    }
};

} // namespace

QString Finding::code() const { return QStringLiteral("H%1").arg(1001 + static_cast<int>(kind)); }

QString Finding::text() const {
    QString out = file;
    if (line > 0) out += u':' + QString::number(line);
    QString place = element + (element.isEmpty() || property.isEmpty() ? QString() : QStringLiteral(".")) + property;
    if (!language.isEmpty()) place += QStringLiteral(" [%1]").arg(language);
    if (!place.isEmpty()) out += QStringLiteral(": ") + place; // a file as a whole has none
    return out + QStringLiteral(": ") + (isError ? QStringLiteral("error ") : QStringLiteral("warning ")) + code() +
           QStringLiteral(": ") + QString::fromStdString(message.english());
}

namespace {

/// What seems to be missing or unused only because a panel could not be read.
void dropFollowUps(std::vector<Finding>& found, const CheckInput& input) {
    const QStringList unread = unreadPanels(input.folder, input.panels);
    if (unread.isEmpty()) return;
    std::erase_if(found, [&](const Finding& one) {
        if (one.kind == FindingKind::OrphanKey) return true;
        if (one.kind != FindingKind::UnknownPanel) return false;
        return std::any_of(unread.begin(), unread.end(),
                           [&](const QString& name) { return one.message == errors::NoPanel(toUtf8(name)); });
    });
}

} // namespace

std::vector<Finding> checkPanels(const CheckInput& input) {
    Checker checker{input, {}, {}};
    for (const NamedPanel& panel : input.panels) checker.checkPanel(panel);
    if (input.hasAlarms) checker.checkAlarms();
    checker.append(checkApplication(input));
    if (unreadPanels(input.folder, input.panels).isEmpty()) checker.append(checkStandardOfAll(input));
    checker.checkTable();
    checker.checkFonts();
    for (const NamedPanel& panel : input.panels) checker.checkFit(panel);
    dropFollowUps(checker.found, input);
    return checker.found;
}

std::vector<Finding> checkPanel(const CheckInput& input, const NamedPanel& panel) {
    Checker checker{input, {}, {}};
    checker.checkPanel(panel);
    checker.checkFit(panel);
    // What all panels say of this one: its way, its keys' places.
    std::vector<Finding> ofAll;
    if (unreadPanels(input.folder, input.panels).isEmpty()) ofAll = checkStandardOfAll(input);
    std::erase_if(ofAll, [&](const Finding& one) { return one.file != panelFile(panel.name); });
    checker.append(std::move(ofAll));
    dropFollowUps(checker.found, input);
    return checker.found;
}

std::vector<Finding> checkFit(const CheckInput& input, const NamedPanel& panel) {
    Checker checker{input, {}, {}};
    checker.checkFit(panel);
    return checker.found;
}

} // namespace plc::hmi
