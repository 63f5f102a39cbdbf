#include "app/documents/unit_commands.h"

#include "app/pages/conversion_dialog.h"
#include "app/project/new_project.h"
#include "app/project/rename_dialog.h"
#include "editor/graph/chart/chart_unit.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "hmi/designer/context/design_context.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>

#include <map>
#include <set>

namespace plc::app {

UnitCommands::UnitCommands(Parts parts, QObject* parent) : QObject(parent), m_parts(parts) {}

void UnitCommands::newUnit(const QString& kind, const QString& wantedFile) {
    if (!m_parts.workspace.isOpen()) return;
    std::set<std::string> taken;
    if (const auto model = m_parts.workspace.model())
        for (const sema::Symbol& symbol : model->checked().analysis->symbols)
            if (symbol.owner.empty()) taken.insert(foldCase(symbol.name));
    NewUnitDialog dialog(m_parts.workspace.files(), std::move(taken), &m_parts.window);
    dialog.preset(kind, wantedFile);
    if (dialog.exec() != QDialog::Accepted) return;
    const std::string text = unitText(dialog.templateId().toStdString(), dialog.name().toStdString());
    if (m_parts.workspace.files().contains(dialog.file())) return addTo(dialog.file(), text);
    if (auto added = m_parts.workspace.addFile(dialog.file(), text); !added)
        return emit message(kit::messageText(added.error()), true);
    if (StPage* page = m_parts.tabs.openFile(dialog.file())) page->first().setFocus(); // one goes on typing in it
}

void UnitCommands::addTo(const QString& file, const std::string& text) {
    const std::string old = m_parts.workspace.text(file);
    const auto at = static_cast<uint32_t>(old.size());
    StPage* page = m_parts.tabs.openFile(file);
    if (!page) return;
    page->first().applyEdits({{{FileId(), at, at}, (old.empty() || old.ends_with('\n') ? "\n" : "\n\n") + text}});
    page->first().goTo(at + 1);
}

void UnitCommands::goToLine() {
    auto* editor = m_parts.tabs.currentEditor();
    if (!editor) return;
    bool ok = false;
    const int line = QInputDialog::getInt(&m_parts.window, tr("Go to Line"), tr("Line (1 to %1)").arg(editor->lines()),
                                          1, 1, editor->lines(), 1, &ok);
    if (ok) m_parts.tabs.goToLine(editor->file(), line);
}

void UnitCommands::findDefinition(const QString& file, uint32_t offset) {
    const auto model = m_parts.workspace.model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto place = model->definition(*id, offset);
    if (!place) return emit message(tr("Nothing is declared under this name; declare it or check the name"));
    const QString target = QString::fromStdString(model->sources()[place->file].path());
    m_parts.tabs.goTo(target, place->begin, place->length());
}

void UnitCommands::definitionAtCursor() {
    if (auto* editor = m_parts.tabs.currentEditor()) findDefinition(editor->file(), editor->cursorOffset());
}

void UnitCommands::usesAtCursor() {
    if (auto* editor = m_parts.tabs.currentEditor()) findUses(editor->file(), editor->cursorOffset());
}

void UnitCommands::renameAtCursor() {
    if (auto* editor = m_parts.tabs.currentEditor()) renameSymbol(editor->file(), editor->cursorOffset());
}

void UnitCommands::showConverted(analysis::TextLanguage to) {
    auto* editor = m_parts.tabs.currentEditor();
    if (!editor) return;
    const std::string path = editor->file().toStdString();
    const auto places = [](const std::string& text, auto&& wanted) {
        std::optional<analysis::BodyPlace> found;
        for (const analysis::BodyPlace& place : analysis::bodiesOf(text))
            if (wanted(place)) found = place; // the innermost is the last
        return found;
    };
    const std::string text = editor->utf8();
    const uint32_t at = editor->cursorOffset();
    const auto before = places(
        text, [&](const analysis::BodyPlace& place) { return at >= place.range.begin && at <= place.range.end; });
    if (!before) return emit message(tr("Put the cursor into a unit that is written in ST or IL"), true);
    driver::BuildInput input = m_parts.workspace.buildInput();
    for (driver::SourceFile& source : input.files)
        if (source.path == path) source.text = text;
    const auto converted = analysis::convertBody(input, path, before->unit, to);
    if (!converted) return emit message(kit::messageText(converted.error()), true);
    const auto after =
        places(converted->text, [&](const analysis::BodyPlace& place) { return place.unit == before->unit; });
    const auto slice = [](const std::string& whole, const std::optional<analysis::BodyPlace>& place) {
        return place ? whole.substr(place->range.begin, place->range.length()) : whole;
    };
    auto* dialog =
        new ConversionDialog(slice(text, before), slice(converted->text, after), *converted, to, &m_parts.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ConversionDialog::replaceRequested, editor, [this, editor, text, edits = converted->edits] {
        if (editor->utf8() == text)
            editor->applyEdits(edits);
        else
            emit message(tr("The text has changed meanwhile"), true);
    });
    dialog->open();
}

void UnitCommands::findUses(const QString& file, uint32_t offset) {
    const auto model = m_parts.workspace.presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto symbol = model->symbolAt(*id, offset);
    if (!symbol) return emit message(tr("There is no name at the cursor; put the cursor on one"));
    const sema::Symbol& found = model->symbol(*symbol);
    m_parts.search.showUses(QString::fromStdString(found.name), model->uses(*id, offset), model->sources(),
                            usesInPanels(found));
    emit usesShown();
}

hmi::DesignContext::NamedVariable UnitCommands::inPanels(const sema::Symbol& symbol) const {
    // A path that is only the name is relative to an instance: panels name it behind the instance's.
    const bool isAtTop = symbol.owner.empty() || symbol.path != symbol.name;
    return m_parts.live.design()->namedVariable(QString::fromStdString(isAtTop ? symbol.path : std::string()),
                                                QString::fromStdString(symbol.owner),
                                                QString::fromStdString(symbol.name), watched());
}

QStringList UnitCommands::watched() const {
    QStringList out = m_parts.watch.allExpressions();
    trace::TraceSetup setup = m_parts.live.traceView().setup();
    trace::forEachExpression(setup, [&](std::string& each) { out << QString::fromStdString(each); });
    return out;
}

QString UnitCommands::noteOnRunning(const sema::Symbol& symbol) const {
    const bool hasValue = symbol.kind == sema::SymbolKind::Variable || symbol.kind == sema::SymbolKind::Program ||
                          symbol.kind == sema::SymbolKind::GlobalList;
    if (!hasValue || !m_parts.control.hasValues()) return {};
    return tr("The program is running. To an online change the new name is another variable: it begins with its "
              "initial value.");
}

std::vector<SearchView::PanelUse> UnitCommands::usesInPanels(const sema::Symbol& symbol) const {
    std::vector<SearchView::PanelUse> out;
    if (!m_parts.live.design()) return out;
    for (const auto& use : m_parts.live.design()->usesOf(inPanels(symbol)))
        out.push_back({use.file, use.element, use.property + " = " + use.expression, use.isWrite});
    return out;
}

void UnitCommands::renameSymbol(const QString& file, uint32_t offset) {
    const auto model = m_parts.workspace.presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return emit message(tr("The project is still being checked; try again in a moment"));
    const auto symbol = model->symbolAt(*id, offset);
    if (!symbol) return emit message(tr("There is no name at the cursor; put the cursor on one"));
    const QString old = QString::fromStdString(model->symbol(*symbol).name);
    std::vector<RenameDialog::Place> places;
    for (const analysis::Use& use : model->uses(*id, offset)) {
        const SourceText& source = model->sources()[use.range.file];
        const uint32_t line = source.lineColumn(use.range.begin).line;
        places.push_back({QString("%1:%2").arg(QString::fromStdString(source.path())).arg(line),
                          kit::fromView(source.line(line)).trimmed()});
    }
    for (const SearchView::PanelUse& use : usesInPanels(model->symbol(*symbol)))
        places.push_back({QString("%1: %2").arg(use.file, use.element), use.text});
    const auto check = [&](const QString& name) {
        const auto edits = model->rename(*id, offset, name.toStdString());
        return edits ? QString() : kit::messageText(edits.error());
    };
    RenameDialog dialog(old, places, noteOnRunning(model->symbol(*symbol)), check, &m_parts.window);
    if (dialog.exec() != QDialog::Accepted || dialog.name() == old) return;
    renameTo(file, offset, dialog.name());
}

std::function<void(bool)> UnitCommands::followers(const hmi::DesignContext::NamedVariable& before,
                                                  const QString& name) const {
    if (!before.path.isEmpty() && !before.path.endsWith(before.name, Qt::CaseInsensitive)) return {};
    hmi::DesignContext::NamedVariable after = before;
    after.path = hmi::DesignContext::renamed({before.path, before.name, {}}, name, before.path);
    after.name = name;
    return [this, before, after](bool back) {
        hmi::DesignContext* design = m_parts.live.design();
        if (!design) return;
        const hmi::DesignContext::NamedVariable& from = back ? after : before;
        const QString& to = back ? before.name : after.name;
        const auto renamed = [&](const QString& expression) {
            return hmi::DesignContext::renamed(from, to, expression);
        };
        m_parts.watch.renameExpressions(renamed);
        m_parts.live.traceView().renameExpressions(renamed);
        if (design->rename(from, to)) (void)design->save();
    };
}

void UnitCommands::renameTo(const QString& file, uint32_t offset, const QString& name) {
    const auto model = m_parts.workspace.presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    const auto symbol = id ? model->symbolAt(*id, offset) : std::nullopt;
    if (!symbol) return emit message(tr("There is no name at the cursor; put the cursor on one"));
    const sema::Symbol& renamedSymbol = model->symbol(*symbol);
    const QString old = QString::fromStdString(renamedSymbol.name);
    const auto found = model->rename(*id, offset, name.toStdString());
    if (!found) return emit message(kit::messageText(found.error()), true);
    std::map<QString, std::vector<diagnostics::TextEdit>> edits;
    for (const analysis::FileEdits& each : *found)
        edits[QString::fromStdString(model->sources()[each.file].path())] = each.edits;
    size_t places = 0;
    for (const auto& [each, list] : edits) places += list.size();
    size_t panelPlaces = 0;
    std::function<void(bool)> follow;
    if (const hmi::DesignContext* design = m_parts.live.design()) {
        const hmi::DesignContext::NamedVariable before = inPanels(renamedSymbol);
        panelPlaces = design->usesOf(before).size();
        follow = followers(before, name);
    }
    m_parts.tabs.applyEdits(edits, follow);
    if (follow) follow(false);
    const auto all = static_cast<int>(places + panelPlaces);
    emit message((panelPlaces
                      ? tr("%1 is now %2 in %n place(s); the panels are saved, the sources not yet", nullptr, all)
                      : tr("%1 is now %2 in %n place(s)", nullptr, all))
                     .arg(old, name));
}

void UnitCommands::deleteUnit(const QString& file, uint32_t begin, uint32_t end, const QString& name) {
    const auto model = m_parts.workspace.presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return emit message(tr("The project is still being checked; try again in a moment"));
    int others = 0;
    for (const analysis::Use& use : model->uses(*id, begin))
        others += !use.isDeclaration && !(use.range.file == *id && use.range.begin >= begin && use.range.end <= end);
    QString question = tr("Delete %1?").arg(name);
    if (others) question += "\n" + tr("It is used in %n other place(s).", nullptr, others);
    QMessageBox box(QMessageBox::Question, tr("Delete"), question, QMessageBox::Cancel, &m_parts.window);
    QPushButton* plain = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
    QPushButton* commentOut =
        others ? box.addButton(tr("Delete and Comment Out the Uses"), QMessageBox::DestructiveRole) : nullptr;
    QPushButton* show = others ? box.addButton(tr("Show the Uses"), QMessageBox::ActionRole) : nullptr;
    box.exec();
    if (show && box.clickedButton() == show) return findUses(file, begin);
    const bool comments = commentOut && box.clickedButton() == commentOut;
    if (!comments && box.clickedButton() != plain) return;
    if (others) findUses(file, begin);
    m_parts.tabs.applyEdits(model->removal(*id, begin, comments), model->sources());
    // A file that held nothing else goes with it.
    const std::string rest = m_parts.workspace.text(file);
    if (rest.find_first_not_of(" \t\r\n") == std::string::npos)
        if (auto removed = m_parts.workspace.removeFile(file); !removed)
            emit message(kit::messageText(removed.error()), true);
}

void UnitCommands::showInstance(const QString& block, const QString& instance) {
    m_parts.control.setPreferredInstance(block, instance);
    for (const QString& file : m_parts.workspace.files()) {
        diagnostics::Sink sink;
        const std::string text = m_parts.workspace.text(file);
        const auto syntax = parse::parseFile(FileId(size_t(0)), text, sink);
        const syntax::Pou* unit = editor::findUnit(*syntax, block.toStdString());
        if (!unit) continue;
        m_parts.tabs.goTo(file, unit->name.range.begin);
        return;
    }
    emit message(tr("%1 is not a source of this project; open the project that contains it").arg(block), true);
}

} // namespace plc::app
