// What the main window does with units, names and files of the project: new, rename, delete with what refers to it.
#include "app/main_window.h"
#include "app/pages/conversion_dialog.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/live_views.h"
#include "app/project/new_project.h"
#include "app/project/project_tree.h"
#include "app/project/rename_dialog.h"
#include "app/project/search_view.h"
#include "editor/graph/chart/chart_unit.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "hmi/designer/panel_designer.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <map>
#include <set>

namespace plc::app {

void MainWindow::newUnit() { newUnitIn({}, {}); }

void MainWindow::newUnitIn(const QString& kind, const QString& wantedFile) {
    if (!m_workspace->isOpen()) return;
    std::set<std::string> taken;
    if (const auto model = m_workspace->model())
        for (const sema::Symbol& symbol : model->checked().analysis->symbols)
            if (symbol.owner.empty()) taken.insert(foldCase(symbol.name));
    NewUnitDialog dialog(m_workspace->files(), std::move(taken), this);
    dialog.preset(kind, wantedFile);
    if (dialog.exec() != QDialog::Accepted) return;
    const std::string text = unitText(dialog.templateId().toStdString(), dialog.name().toStdString());
    const QString file = dialog.file();
    if (m_workspace->files().contains(file)) {
        const std::string old = m_workspace->text(file);
        const auto at = static_cast<uint32_t>(old.size());
        if (StPage* page = m_tabs->openFile(file)) {
            page->first().applyEdits(
                {{{FileId(), at, at}, (old.empty() || old.ends_with('\n') ? "\n" : "\n\n") + text}});
            page->first().goTo(at + 1);
        }
        return;
    }
    if (auto added = m_workspace->addFile(file, text); !added) return say(kit::messageText(added.error()), true);
    if (StPage* page = m_tabs->openFile(file)) page->first().setFocus(); // one goes on typing in it
}

// ------------------------------------------------------------------ names

void MainWindow::goToLine() {
    auto* editor = m_tabs->currentEditor();
    if (!editor) return;
    bool ok = false;
    const int line = QInputDialog::getInt(this, tr("Go to Line"), tr("Line (1 to %1)").arg(editor->lines()), 1, 1,
                                          editor->lines(), 1, &ok);
    if (ok) m_tabs->goToLine(editor->file(), line);
}

void MainWindow::findDefinition(const QString& file, uint32_t offset) {
    const auto model = m_workspace->model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto place = model->definition(*id, offset);
    if (!place) return say(tr("Nothing is declared under this name; declare it or check the name"));
    const QString target = QString::fromStdString(model->sources()[place->file].path());
    m_tabs->goTo(target, place->begin, place->length());
}

void MainWindow::definitionAtCursor() {
    if (auto* editor = m_tabs->currentEditor()) findDefinition(editor->file(), editor->cursorOffset());
}

void MainWindow::usesAtCursor() {
    if (auto* editor = m_tabs->currentEditor()) findUses(editor->file(), editor->cursorOffset());
}

void MainWindow::renameAtCursor() {
    if (auto* editor = m_tabs->currentEditor()) renameSymbol(editor->file(), editor->cursorOffset());
}

void MainWindow::showConverted(analysis::TextLanguage to) {
    auto* editor = m_tabs->currentEditor();
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
    if (!before) return say(tr("Put the cursor into a unit that is written in ST or IL"), true);
    driver::BuildInput input = m_workspace->buildInput();
    for (driver::SourceFile& source : input.files)
        if (source.path == path) source.text = text;
    const auto converted = analysis::convertBody(input, path, before->unit, to);
    if (!converted) return say(kit::messageText(converted.error()), true);
    const auto after =
        places(converted->text, [&](const analysis::BodyPlace& place) { return place.unit == before->unit; });
    const auto slice = [](const std::string& whole, const std::optional<analysis::BodyPlace>& place) {
        return place ? whole.substr(place->range.begin, place->range.length()) : whole;
    };
    auto* dialog = new ConversionDialog(slice(text, before), slice(converted->text, after), *converted, to, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ConversionDialog::replaceRequested, editor, [this, editor, text, edits = converted->edits] {
        if (editor->utf8() == text)
            editor->applyEdits(edits);
        else
            say(tr("The text has changed meanwhile"), true);
    });
    dialog->open();
}

void MainWindow::findUses(const QString& file, uint32_t offset) {
    const auto model = m_workspace->presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto symbol = model->symbolAt(*id, offset);
    if (!symbol) return say(tr("There is no name at the cursor; put the cursor on one"));
    const sema::Symbol& found = model->symbol(*symbol);
    m_search->showUses(QString::fromStdString(found.name), model->uses(*id, offset), model->sources(),
                       usesInPanels(found));
    showDock("search");
}

/// Panels and alarms that name a variable of the program; they name nothing inside a block.
std::vector<SearchView::PanelUse> MainWindow::usesInPanels(const sema::Symbol& symbol) const {
    std::vector<SearchView::PanelUse> out;
    const bool isAtTop = symbol.owner.empty() || symbol.path != symbol.name;
    if (!m_live->design() || symbol.path.empty() || !isAtTop) return out;
    for (const auto& use : m_live->design()->usesOfVariable(QString::fromStdString(symbol.path)))
        out.push_back({use.file, use.element, use.property + " = " + use.expression, use.isWrite});
    return out;
}

void MainWindow::renameSymbol(const QString& file, uint32_t offset) {
    const auto model = m_workspace->presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return say(tr("The project is still being checked; try again in a moment"));
    const auto symbol = model->symbolAt(*id, offset);
    if (!symbol) return say(tr("There is no name at the cursor; put the cursor on one"));
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
    RenameDialog dialog(old, places, this);
    if (dialog.exec() != QDialog::Accepted || dialog.name().isEmpty() || dialog.name() == old) return;
    renameTo(file, offset, dialog.name());
}

void MainWindow::renameTo(const QString& file, uint32_t offset, const QString& name) {
    const auto model = m_workspace->presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    const auto symbol = id ? model->symbolAt(*id, offset) : std::nullopt;
    if (!symbol) return say(tr("There is no name at the cursor; put the cursor on one"));
    const sema::Symbol& renamedSymbol = model->symbol(*symbol);
    const QString old = QString::fromStdString(renamedSymbol.name), path = QString::fromStdString(renamedSymbol.path);
    const auto found = model->rename(*id, offset, name.toStdString());
    if (!found) return say(kit::messageText(found.error()), true);
    std::map<QString, std::vector<diagnostics::TextEdit>> edits;
    for (const analysis::FileEdits& each : *found)
        edits[QString::fromStdString(model->sources()[each.file].path())] = each.edits;
    size_t places = 0;
    for (const auto& [each, list] : edits) places += list.size();
    // Panels follow, also when the rename is taken back.
    const QString newPath = path.left(path.size() - old.size()) + name;
    const auto renamePanels = [this, path, newPath](bool back) {
        if (m_live->design() && m_live->design()->renameVariable(back ? newPath : path, back ? path : newPath))
            (void)m_live->design()->save();
    };
    const bool hasPath = path.endsWith(old, Qt::CaseInsensitive) &&
                         (renamedSymbol.owner.empty() || path != old); // panels name nothing inside a block
    m_tabs->applyEdits(edits, hasPath ? std::function<void(bool)>(renamePanels) : nullptr);
    if (hasPath) renamePanels(false);
    emit renamed(path, old, name);
    say(tr("%1 is now %2 in %n place(s)", nullptr, static_cast<int>(places)).arg(old, name));
}

void MainWindow::deleteUnit(const QString& file, uint32_t begin, uint32_t end, const QString& name) {
    const auto model = m_workspace->presentModel();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return say(tr("The project is still being checked; try again in a moment"));
    int others = 0;
    for (const analysis::Use& use : model->uses(*id, begin))
        others += !use.isDeclaration && !(use.range.file == *id && use.range.begin >= begin && use.range.end <= end);
    QString question = tr("Delete %1?").arg(name);
    if (others) question += "\n" + tr("It is used in %n other place(s).", nullptr, others);
    QMessageBox box(QMessageBox::Question, tr("Delete"), question, QMessageBox::Cancel, this);
    QPushButton* plain = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
    QPushButton* commentOut =
        others ? box.addButton(tr("Delete and Comment Out the Uses"), QMessageBox::DestructiveRole) : nullptr;
    QPushButton* show = others ? box.addButton(tr("Show the Uses"), QMessageBox::ActionRole) : nullptr;
    box.exec();
    if (show && box.clickedButton() == show) return findUses(file, begin);
    const bool comments = commentOut && box.clickedButton() == commentOut;
    if (!comments && box.clickedButton() != plain) return;
    if (others) findUses(file, begin);
    m_tabs->applyEdits(model->removal(*id, begin, comments), model->sources());
    // A file that held nothing else goes with it.
    const std::string rest = m_workspace->text(file);
    if (rest.find_first_not_of(" \t\r\n") == std::string::npos)
        if (auto removed = m_workspace->removeFile(file); !removed) say(kit::messageText(removed.error()), true);
}

// ------------------------------------------------------------------ files

void MainWindow::renameSource(const QString& from, const QString& to) {
    const bool wasOpen = m_tabs->pageOf(from) != nullptr;
    if (wasOpen && m_workspace->isModified(from))
        if (auto saved = m_workspace->save(from); !saved) return say(kit::messageText(saved.error()), true);
    if (auto renamed = m_workspace->renameFile(from, to); !renamed) return say(kit::messageText(renamed.error()), true);
    std::vector<editor::EditorBreakpoint> breakpoints = m_control->breakpoints();
    for (editor::EditorBreakpoint& each : breakpoints)
        if (each.file == from) each.file = to;
    m_control->setBreakpoints(breakpoints);
    if (wasOpen) m_tabs->openFile(to);
}

void MainWindow::showInstance(const QString& block, const QString& instance) {
    m_control->setPreferredInstance(block, instance);
    for (const QString& file : m_workspace->files()) {
        diagnostics::Sink sink;
        const std::string text = m_workspace->text(file);
        const auto syntax = parse::parseFile(FileId(size_t(0)), text, sink);
        const syntax::Pou* unit = editor::findUnit(*syntax, block.toStdString());
        if (!unit) continue;
        m_tabs->goTo(file, unit->name.range.begin);
        return;
    }
    say(tr("%1 is not a source of this project; open the project that contains it").arg(block), true);
}

} // namespace plc::app
