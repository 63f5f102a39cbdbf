#include "hmi/view/panel_check.h"

#include "hmi/model/walk.h"
#include "hmi/view/arrays.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFontMetrics>
#include <QSet>

namespace plc::hmi {

namespace {

class HmiCheck {
    Q_DECLARE_TR_FUNCTIONS(HmiCheck)
};

QString panelFile(const QString& name) { return QStringLiteral("hmi/%1.panel.json").arg(name); }

const QString kTextFile = QStringLiteral("hmi/texts.csv");
const QString kAlarmFile = QStringLiteral("hmi/alarms.json");

bool hasLetters(const QString& text) {
    int letters = 0;
    for (const QChar c : text) letters += c.isLetter();
    return letters >= 2; // "X" and "m" are names of axes and units
}

struct Checker {
    const CheckInput& input;
    std::vector<Finding> found;
    QSet<QString> usedKeys;

    const TextTable& table() const { return input.texts.table(); }
    const LanguageSettings& settings() const { return input.texts.settings(); }
    QStringList languages() const { return input.languages.isEmpty() ? settings().languages : input.languages; }

    void add(FindingKind kind, bool isError, const QString& file, const ElementId& element, const QString& property,
             const QString& message, const QString& language = {}, int line = 0) {
        found.push_back({kind, isError, file, line, element, property, language, message});
    }

    /// A text of an element or alarm with the placeholders that it can fill.
    void checkText(const QString& file, const ElementId& id, const Found& text, const QStringList& names,
                   bool hasFixedLanguage) {
        if (!isTextKey(text.text)) {
            if (hasLetters(text.text) && settings().languages.size() > 1 && !hasFixedLanguage)
                add(FindingKind::HardCodedText, false, file, id, text.place(),
                    HmiCheck::tr("The text \"%1\" has no key, so it can not be translated.").arg(text.text));
            checkNames(file, id, text, text.text, {}, names);
            return;
        }
        const QString key = keyOf(text.text);
        usedKeys += key;
        const int row = table().rowOf(key);
        if (row < 0) {
            add(FindingKind::MissingKey, true, file, id, text.place(),
                HmiCheck::tr("The key %1 is not in the text table.").arg(key));
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
                    HmiCheck::tr("The text needs a value for {%1}; give it in \"Values in texts\".").arg(name), tag);
    }

    void checkLists(const QString& file, const ElementId& id, const Properties& properties) {
        forEachTextList(properties, [&](const Found& list) {
            const QString prefix = isTextKey(list.text) ? keyOf(list.text) : list.text;
            const int length = table().listLength(prefix);
            if (length == 0)
                add(FindingKind::MissingKey, true, file, id, list.place(),
                    HmiCheck::tr("The text list %1 is empty: there is no key %1.0.").arg(prefix));
            for (int i = 0; i < length; ++i) usedKeys += prefix + u'.' + QString::number(i);
        });
    }

    void checkBindings(const QString& file, const ElementId& id, const Properties& properties, bool hasIndex = false) {
        if (!input.checkBinding) return;
        forEachBinding(properties, [&](const Found& binding) {
            QString expression = binding.text;
            if (hasIndex) { // tried with the first index
                const int first = properties.integer("first");
                expression = withIndex(expression, first, first, first);
            }
            const QString complaint =
                input.checkBinding(expression, binding.hint, binding.type == PropertyType::Target);
            if (!complaint.isEmpty()) add(FindingKind::WrongBinding, true, file, id, binding.place(), complaint);
        });
    }

    void checkElement(const QString& file, const Panel& panel, const Element& element) {
        const ElementId id = element.id();
        if (element.kind() == ElementKind::Unknown)
            add(FindingKind::UnknownKind, false, file, id, QStringLiteral("kind"),
                HmiCheck::tr("This version does not know the element kind \"%1\"; it is kept as it is.")
                    .arg(element.text("kind")));
        QStringList names;
        if (const Json& values = element.at("values"); values.is_object())
            for (const auto& [name, expression] : values.items()) names += QString::fromStdString(name);
        const QString fixed = element.text("language");
        if (!fixed.isEmpty() && table().columnOf(fixed) < 0 && !settings().languages.contains(fixed))
            add(FindingKind::UnknownLanguage, true, file, id, QStringLiteral("language"),
                HmiCheck::tr("The project has no language %1.").arg(fixed));
        forEachText(element, [&](const Found& text) { checkText(file, id, text, names, !fixed.isEmpty()); });
        checkLists(file, id, element);
        checkBindings(file, id, element,
                      element.kind() == ElementKind::ArrayTable || element.kind() == ElementKind::CellGrid);
        if (const QRectF rect = element.rect(); !QRectF(QPointF(), panel.size()).intersects(rect))
            add(FindingKind::Outside, false, file, id, QStringLiteral("rect"),
                HmiCheck::tr("The element lies outside the panel."));
        for (const PropertyDescriptor& property : element.descriptor().properties) {
            const QString value = element.text(property.key);
            const QString name = QString::fromStdString(std::string(property.key));
            if (property.type == PropertyType::File && !value.isEmpty() && !input.folder.isEmpty() &&
                !QFileInfo::exists(QDir(input.folder).filePath(value)))
                add(FindingKind::MissingImage, true, file, id, name,
                    HmiCheck::tr("The file %1 is not there.").arg(value));
            if (property.type == PropertyType::Panel && !value.isEmpty()) {
                const bool isKnown = std::any_of(input.panels.begin(), input.panels.end(),
                                                 [&](const NamedPanel& one) { return one.name == value; });
                if (!isKnown)
                    add(FindingKind::UnknownPanel, true, file, id, name,
                        HmiCheck::tr("There is no panel %1.").arg(value));
            }
            if (property.key == "format" && !value.isEmpty() && !NumberFormat::parse(value))
                add(FindingKind::BadFormat, true, file, id, name,
                    HmiCheck::tr("The format %1 is not known; %.1f and %d are.").arg(value));
            if (element.kind() == ElementKind::Button && property.key == "tag" &&
                element.text("action") == QStringLiteral("language") && !settings().languages.contains(value))
                add(FindingKind::UnknownLanguage, true, file, id, name,
                    HmiCheck::tr("The project has no language %1.").arg(value));
        }
    }

    void checkPanel(const NamedPanel& named) {
        const QString file = panelFile(named.name);
        forEachText(named.panel, [&](const Found& text) { checkText(file, {}, text, {}, false); });
        for (const Element& element : named.panel.elements()) checkElement(file, named.panel, element);
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
                    HmiCheck::tr("The alarm has no condition."));
            const QString own = row.text("class");
            if (!own.isEmpty() && !classes.isEmpty() && !classes.contains(own))
                add(FindingKind::UnknownClass, true, kAlarmFile, id, QStringLiteral("class"),
                    HmiCheck::tr("There is no alarm class %1.").arg(own));
        }
    }

    void checkTable() {
        for (const QString& key : input.keysUsedElsewhere) usedKeys += key;
        for (const TextTable::Row& row : table().rows()) {
            if (!usedKeys.contains(row.key) && !row.key.startsWith(QStringLiteral("hmi.")))
                add(FindingKind::OrphanKey, false, kTextFile, {}, row.key,
                    HmiCheck::tr("No panel and no alarm uses the key %1.").arg(row.key), {}, row.line);
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
                        HmiCheck::tr("%1 has the placeholders {%2}, but %3 has {%4}.")
                            .arg(tag, parts.names().join(QStringLiteral(", ")), namesOf,
                                 names.join(QStringLiteral(", "))),
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
                        HmiCheck::tr("The key %1 has no text in %2.").arg(row.key, tag), tag, row.line);
            }
        }
    }

    void checkFonts() {
        if (!QFontDatabase::hasFamily(settings().font))
            add(FindingKind::MissingFont, true, QStringLiteral("project.json"), {}, QStringLiteral("font"),
                HmiCheck::tr("The font %1 is not installed here, so texts can not be measured.").arg(settings().font));
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
                        HmiCheck::tr("No font has the character U+%1.").arg(c, 4, 16, QLatin1Char('0')), tag, row.line);
                    break;
                }
            }
    }

    void checkFit(const NamedPanel& named) {
        // Alarm texts are measured by the lists that show them.
        AlarmBook book;
        book.setFile(input.alarms);
        PanelScene scene;
        scene.setMeasuring(true);
        scene.setTexts(&input.texts);
        scene.setAlarms(&book);
        scene.setFolder(input.folder);
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
                    const QString place = view->element().id() + u'.' + box.property;
                    if (said.contains(place + tag + box.text)) continue;
                    said += place + tag + box.text;
                    const QSizeF needed = neededSize(box);
                    const QString shown = box.text.size() > 60 ? box.text.left(57) + u'…' : box.text;
                    const QString message =
                        needed.width() > box.rect.width() + 0.5
                            ? HmiCheck::tr("\"%1\" does not fit: it needs %2 px, there are %3.")
                                  .arg(shown)
                                  .arg(std::ceil(needed.width()))
                                  .arg(std::floor(box.rect.width()))
                            : HmiCheck::tr("\"%1\" does not fit: it needs a height of %2 px, there are %3.")
                                  .arg(shown)
                                  .arg(std::ceil(needed.height()))
                                  .arg(std::floor(box.rect.height()));
                    add(FindingKind::TextTooLong, false, panelFile(named.name), view->element().id(), box.property,
                        message, fixed.isEmpty() ? tag : fixed);
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
    out += QStringLiteral(": ");
    if (!element.isEmpty() || !property.isEmpty())
        out += element + (element.isEmpty() || property.isEmpty() ? QString() : QStringLiteral(".")) + property;
    if (!language.isEmpty()) out += QStringLiteral(" [%1]").arg(language);
    return out + QStringLiteral(": ") +
           (isError ? QCoreApplication::translate("HmiCheck", "error")
                    : QCoreApplication::translate("HmiCheck", "warning")) +
           u' ' + code() + QStringLiteral(": ") + message;
}

std::vector<Finding> checkPanels(const CheckInput& input) {
    Checker checker{input, {}, {}};
    for (const NamedPanel& panel : input.panels) checker.checkPanel(panel);
    if (input.hasAlarms) checker.checkAlarms();
    checker.checkTable();
    checker.checkFonts();
    for (const NamedPanel& panel : input.panels) checker.checkFit(panel);
    return checker.found;
}

std::vector<Finding> checkPanel(const CheckInput& input, const NamedPanel& panel) {
    Checker checker{input, {}, {}};
    checker.checkPanel(panel);
    checker.checkFit(panel);
    return checker.found;
}

std::vector<Finding> checkFit(const CheckInput& input, const NamedPanel& panel) {
    Checker checker{input, {}, {}};
    checker.checkFit(panel);
    return checker.found;
}

} // namespace plc::hmi
