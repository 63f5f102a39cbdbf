// What is done to a ladder diagram by keyboard, mouse, menu and the field in place.
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/bar_menu.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <QMenu>
#include <QToolBar>

#include <algorithm>

namespace plc::editor {

using ladder::LadderEditor;
using ladder::Node;
using ladder::NodeId;
using ladder::NodeKind;
using ladder::Place;
using ladder::Rung;
using ladder::RungId;
using ladder::RungKind;

namespace {

/// "/stop" is how a negated contact is typed.
std::string spelled(const QString& text) {
    const QString word = text.trimmed();
    if (word.startsWith('/')) return ("NOT " + word.mid(1).trimmed()).toStdString();
    return word.toStdString();
}

/// The one name in an operand, or empty.
std::string nameIn(const std::string& operand) {
    std::string name = operand;
    if (name.size() > 4 && equalsIgnoringCase(name.substr(0, 4), "NOT ")) name = name.substr(4);
    const bool isName = !name.empty() && name.find_first_of(" .()[]<>=+-*/#'%&,;") == std::string::npos &&
                        !(name[0] >= '0' && name[0] <= '9') && !equalsIgnoringCase(name, "TRUE") &&
                        !equalsIgnoringCase(name, "FALSE");
    return isName ? name : std::string();
}

/// "limit : INT": a name that is declared with its type.
std::pair<std::string, std::string> splitDeclaration(const std::string& word) {
    const size_t colon = word.find(':');
    if (colon == std::string::npos || word.substr(colon).starts_with(":=")) return {word, {}};
    const auto trimmed = [](const std::string& part) { return QString::fromStdString(part).trimmed().toStdString(); };
    return {trimmed(word.substr(0, colon)), trimmed(word.substr(colon + 1))};
}

/// The type that a literal like this one has.
std::string typeOfLiteral(std::string_view text) {
    const std::string folded = foldCase(text);
    if (folded.starts_with("t#") || folded.starts_with("time#")) return "TIME";
    if (folded.starts_with("'")) return "STRING";
    if (folded == "true" || folded == "false") return "BOOL";
    return folded.find('.') == std::string::npos ? "INT" : "REAL";
}

bool isContact(const Node& node) {
    return node.kind == NodeKind::Contact || node.kind == NodeKind::Compare || node.kind == NodeKind::Edge;
}

} // namespace

bool LadderView::canEdit() {
    if (m_syntax && !m_isStale) return true;
    emit failed(tr("Fix the text first: this is the last valid drawing"));
    return false;
}

LadderView::Edits LadderView::withDeclaration(Edits edits, const std::string& name, const std::string& type) const {
    if (name.empty() || edits.empty()) return edits;
    Edits declared = editor().declare(name, type);
    declared.insert(declared.end(), edits.begin(), edits.end());
    std::stable_sort(declared.begin(), declared.end(),
                     [](const auto& a, const auto& b) { return a.range.begin < b.range.begin; });
    return declared;
}

/// Types a text over the drawing; what it makes is one edit, new names are declared with it.
void LadderView::ask(FieldKind kind, const QRectF& place, const QString& text, uint32_t at, Make make) {
    m_fieldKind = kind;
    m_scene->markGap(std::nullopt);
    const bool takesName = kind == FieldKind::Operand || kind == FieldKind::Place;
    openField(
        place, text, at,
        [this, kind, takesName, type = std::exchange(m_fieldType, "BOOL"),
         make = std::move(make)](const QString& typed) -> Result<Edits> {
            const std::string word = kind == FieldKind::Operand ? spelled(typed) : typed.trimmed().toStdString();
            if (!takesName) return make(word);
            const auto [operand, declared] = splitDeclaration(word);
            const Result<Edits> edits = make(operand);
            if (!edits) return edits;
            return withDeclaration(*edits, nameIn(operand), declared.empty() ? type : declared);
        },
        takesName);
}

/// For a new name in the place of an operand: what that one is.
std::string LadderView::typeExpected(const Node& node) const {
    if (!node.operand || node.kind != NodeKind::Operand) return "BOOL";
    const syntax::TypeSpec* type = m_types->typeOf(*node.operand, {m_place.pou, m_place.owner});
    if (type && type->kind == syntax::TypeSpecKind::Named && !type->path.empty())
        return std::string(type->path.back().text);
    const SourceRange range = node.operand->range;
    return node.operand->kind == syntax::ExprKind::Literal
               ? typeOfLiteral(std::string_view(m_text).substr(range.begin, range.length()))
               : "BOOL";
}

void LadderView::insertContactLeft() {
    if (!canEdit()) return;
    const LadderPick pick = m_scene->picked();
    const RungId rung = pickedRung();
    if (!rung.isValid()) return insertRungBelow();
    const Node* node = pickedNode();
    const QRectF around = m_scene->rectOf(pick.rung.isValid() ? pick : LadderPick{rung, {}});
    const QRectF place(around.topLeft(), QSizeF(120, 26));
    const bool beside = node && node->expr && isContact(*node);
    ask(FieldKind::Operand, place, {}, m_diagram[rung].range.begin,
        [this, pick, rung, beside](const std::string& text) {
            return beside ? editor().insertContact(pick.node, Place::Before, text) : editor().appendContact(rung, text);
        });
}

void LadderView::insertContactRight() {
    if (!canEdit()) return;
    const LadderPick pick = m_scene->picked();
    const RungId rung = pickedRung();
    const Node* node = pickedNode();
    if (!node || !node->expr || !isContact(*node)) return insertContactLeft();
    const QRectF beside = m_scene->rectOf(pick);
    ask(FieldKind::Operand, QRectF(beside.topRight(), QSizeF(120, beside.height())), {}, m_diagram[rung].range.begin,
        [this, pick](const std::string& text) { return editor().insertContact(pick.node, Place::After, text); });
}

/// Around the selected contact; without one around all contacts of the rung.
void LadderView::insertParallel() {
    if (!canEdit()) return;
    const LadderPick pick = m_scene->picked();
    const RungId rung = pickedRung();
    if (!rung.isValid()) return;
    const Node* node = pickedNode();
    const NodeId with = node && node->expr && isContact(*node) ? pick.node : m_diagram[rung].power;
    if (!with.isValid()) return emit failed(tr("The rung has no contact yet"));
    const QRectF above = m_scene->rectOf({rung, with});
    ask(FieldKind::Operand, QRectF(above.bottomLeft(), QSizeF(120, 26)), {}, m_diagram[rung].range.begin,
        [this, with](const std::string& text) { return editor().insertParallel(with, text); });
}

void LadderView::insertCoil() {
    if (!canEdit()) return;
    const RungId rung = pickedRung();
    if (!rung.isValid()) return insertRungBelow();
    const QRectF whole = m_scene->rectOf({rung, {}});
    ask(FieldKind::Place, QRectF(whole.right() - 160, whole.bottom(), 150, 26), {}, m_diagram[rung].range.begin,
        [this, rung](const std::string& text) { return editor().addCoil(rung, text); });
}

/// "T1 : TON"
void LadderView::insertBlock() {
    if (!canEdit()) return;
    const RungId rung = pickedRung();
    if (!rung.isValid()) return emit failed(tr("Select the rung that gets the block"));
    const QRectF whole = m_scene->rectOf({rung, {}});
    ask(FieldKind::Block, QRectF(whole.center() - QPointF(80, 0), QSizeF(180, 26)), QStringLiteral("T1 : TON"),
        m_diagram[rung].range.begin, [this, rung](const std::string& text) -> Result<Edits> {
            const size_t colon = text.find(':');
            const auto trimmed = [](std::string word) { return QString::fromStdString(word).trimmed().toStdString(); };
            if (colon == std::string::npos) return Error{errors::BlockNeedsNameAndType(), {}};
            return editor().insertBlock(rung, trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1)));
        });
}

/// Typed is the coil; its contacts follow.
void LadderView::insertRung(Place place) {
    if (!canEdit()) return;
    const RungId rung = pickedRung();
    const QRectF beside = rung.isValid() ? m_scene->rectOf({rung, {}}) : QRectF(20, 20, 400, 26);
    const double y = place == Place::Before ? beside.top() - 8 : beside.bottom();
    const uint32_t at = rung.isValid() ? m_diagram[rung].range.begin : m_place.body->range.begin;
    ask(FieldKind::Place, QRectF(beside.left() + 60, y, 160, 26), {}, at, [this, rung, place](const std::string& text) {
        const bool isStatement = text.find_first_of(":=(") != std::string::npos;
        return editor().insertRung(rung, place,
                                   isStatement ? text + (text.ends_with(';') ? "" : ";") : text + " := TRUE;");
    });
}

void LadderView::insertRungAbove() { insertRung(Place::Before); }
void LadderView::insertRungBelow() { insertRung(Place::After); }

void LadderView::deleteSelected() {
    if (!canEdit() || !m_scene->picked().rung.isValid()) return;
    const LadderPick pick = m_scene->picked();
    request(pick.node.isValid() ? editor().remove(pick.node) : editor().removeRung(pick.rung));
}

void LadderView::negate() {
    const Node* node = pickedNode();
    if (!canEdit()) return;
    if (!node) return emit failed(tr("Select a contact, a coil or a pin with a variable"));
    request(editor().negate(m_scene->picked().node), kit::fromView(node->label));
}

void LadderView::nextCoil() {
    const Node* node = pickedNode();
    if (!canEdit()) return;
    if (!node || node->kind != NodeKind::Coil) return emit failed(tr("Select a coil"));
    using ladder::CoilKind;
    const CoilKind next = node->coil == CoilKind::Set     ? CoilKind::Reset
                          : node->coil == CoilKind::Reset ? CoilKind::Normal
                                                          : CoilKind::Set;
    request(editor().setCoil(m_scene->picked().node, next), kit::fromView(node->label));
}

void LadderView::editSelected() {
    if (!canEdit()) return;
    const LadderPick pick = m_scene->picked();
    if (!pick.rung.isValid()) return;
    const Rung& rung = m_diagram[pick.rung];
    const QRectF place = m_scene->rectOf(pick);
    const Node* node = pickedNode();
    if (!node) {
        if (rung.kind != RungKind::Text) return editComment();
        return ask(FieldKind::Statement, place, QString::fromStdString(rung.text).simplified(), rung.range.begin,
                   [this, pick](const std::string& text) { return editor().setText(pick.rung, text); });
    }
    if (node->kind == NodeKind::Box) return emit placeSelected(node->range.begin);
    const auto slice = [&](SourceRange range) {
        return kit::fromView(std::string_view(m_text).substr(range.begin, range.length()));
    };
    const QString present = node->kind == NodeKind::Compare ? slice(node->expr->range) : kit::fromView(node->label);
    m_fieldType = typeExpected(*node);
    ask(node->kind == NodeKind::Coil ? FieldKind::Place : FieldKind::Operand, place, present, node->range.begin,
        [this, pick](const std::string& text) { return editor().setOperand(pick.node, text); });
}

void LadderView::editComment() {
    if (!canEdit()) return;
    const RungId rung = pickedRung();
    if (!rung.isValid()) return;
    QString present;
    for (const QString& line : QString::fromStdString(m_diagram[rung].note).split('\n'))
        present += (present.isEmpty() ? "" : " ") + line;
    const QRectF whole = m_scene->rectOf({rung, {}});
    ask(FieldKind::Comment, QRectF(whole.left() + 40, whole.top(), 360, 26), present, m_diagram[rung].range.begin,
        [this, rung](const std::string& text) { return editor().setComment(rung, text); });
}

void LadderView::moveRung(int direction) {
    if (!canEdit() || !m_scene->picked().rung.isValid()) return;
    const size_t from = m_scene->picked().rung.index();
    for (auto at = static_cast<std::ptrdiff_t>(from) + direction;
         at >= 0 && at < static_cast<std::ptrdiff_t>(m_diagram.rungs.size()); at += direction) {
        const Rung& other = m_diagram.rungs[static_cast<size_t>(at)];
        if (other.depth != m_diagram.rungs[from].depth) continue;
        return request(editor().moveRung(RungId(from), direction < 0 ? Place::Before : Place::After,
                                         RungId(static_cast<size_t>(at))));
    }
}

// ------------------------------------------------------------------ names

/// Where the name of a part stands: of T1.Q the instance, of a member of a list the member.
uint32_t LadderView::placeOfName(const LadderPick& pick) const {
    if (!pick.node.isValid()) return m_diagram[pick.rung].range.begin;
    const Node& node = m_diagram[pick.node];
    const syntax::Expr* at = node.operand;
    const ladder::DeclaredTypes::Scope scope{m_place.pou, m_place.owner};
    while (at && at->base && (at->kind != syntax::ExprKind::Member || m_types->calleeOf(*at->base, scope)))
        at = at->base;
    if (!at) return node.range.begin;
    return at->kind == syntax::ExprKind::Member ? at->name.range.begin : at->range.begin;
}

void LadderView::renameSelected() {
    if (pickedNode() && canEdit()) emit renameRequested(placeOfName(m_scene->picked()));
}
void LadderView::usesOfSelected() {
    if (pickedNode() && canEdit()) emit usesRequested(placeOfName(m_scene->picked()));
}
void LadderView::definitionOfSelected() {
    if (pickedNode() && canEdit()) emit definitionRequested(placeOfName(m_scene->picked()));
}
void LadderView::fixSelected() {
    if (m_scene->picked().rung.isValid() && canEdit()) emit fixRequested(placeOfName(m_scene->picked()));
}
void LadderView::toggleBookmark() {
    const RungId rung = pickedRung();
    if (rung.isValid() && canEdit()) emit bookmarkRequested(m_diagram[rung].range.begin);
}

/// What stands above what is selected; says so when it is no variable.
QString LadderView::selectedVariable() {
    const Node* node = pickedNode();
    if (node && node->operand && node->kind != NodeKind::Compare) return kit::fromView(node->label);
    emit failed(tr("Select a contact, a coil or a pin with a variable"));
    return {};
}

void LadderView::forceSelected(const QString& value) {
    if (const QString name = selectedVariable(); !name.isEmpty()) emit forceRequested(name, value);
}

void LadderView::writeSelected(const QString& value) {
    if (const QString name = selectedVariable(); !name.isEmpty()) emit writeRequested(name, value);
}

// ------------------------------------------------------------------ how it is shown

void LadderView::themeChanged() {
    m_scene->refreshTheme();
    m_canvas->setBackgroundBrush(m_scene->colors().base);
}

void LadderView::addLookMenu() {
    QMenu* menu = kit::addBarMenu(*m_bar, kit::icon(kit::Icon::Watch), tr("What is shown"));
    menu->setObjectName("ladderLook");
    const auto add = [&](const QString& text, auto isSet, auto set) {
        QAction* action = menu->addAction(text);
        action->setCheckable(true);
        connect(menu, &QMenu::aboutToShow, action, [this, action, isSet] { action->setChecked(isSet(m_look)); });
        connect(action, &QAction::triggered, this, [this, set](bool on) {
            LadderLook look = m_look;
            set(look, on);
            setLook(look);
        });
    };
    using ladder::Naming;
    using ladder::Symbols;
    add(
        tr("Contacts as Bars (IEC 61131-3, ANSI)"), [](const LadderLook& l) { return l.symbols == Symbols::Bars; },
        [](LadderLook& l, bool) { l.symbols = Symbols::Bars; });
    add(
        tr("Contacts as in Circuit Diagrams (IEC 60617)"),
        [](const LadderLook& l) { return l.symbols == Symbols::Circuit; },
        [](LadderLook& l, bool) { l.symbols = Symbols::Circuit; });
    menu->addSeparator();
    const auto addNaming = [&](const QString& text, Naming naming) {
        add(
            text, [naming](const LadderLook& l) { return l.layout.naming == naming; },
            [naming](LadderLook& l, bool) { l.layout.naming = naming; });
    };
    addNaming(tr("Names"), Naming::Symbols);
    addNaming(tr("Addresses"), Naming::Addresses);
    addNaming(tr("Names and Addresses"), Naming::Both);
    menu->addSeparator();
    add(
        tr("Comments of the Variables"), [](const LadderLook& l) { return l.layout.showsComments; },
        [](LadderLook& l, bool on) { l.layout.showsComments = on; });
    add(
        tr("Comments of the Rungs"), [](const LadderLook& l) { return l.layout.showsNotes; },
        [](LadderLook& l, bool on) { l.layout.showsNotes = on; });
    add(
        tr("High Contrast"), [](const LadderLook& l) { return l.isHighContrast; },
        [](LadderLook& l, bool on) { l.isHighContrast = on; });
}

// ------------------------------------------------------------------ the field

QString LadderView::complaintOf(const QString& text) const {
    if (!m_makeEdits || text.trimmed().isEmpty() || text == m_fieldBegin) return {};
    const Result<Edits> edits = m_makeEdits(text);
    return edits ? QString() : kit::messageText(edits.error());
}

std::vector<kit::Completion> LadderView::blockCompletions() const {
    std::vector<kit::Completion> out;
    for (const std::string& block : m_types->blocks())
        out.push_back({QString::fromStdString(block), tr("block"), kit::Icon::Layers});
    return out;
}

/// Behind "limit :" stands a type.
std::vector<kit::Completion> LadderView::typeCompletions() const {
    std::vector<kit::Completion> out;
    for (const char* type : {"BOOL", "INT", "DINT", "UINT", "WORD", "REAL", "LREAL", "TIME", "STRING"})
        out.push_back({type, tr("type"), kit::Icon::Type});
    for (kit::Completion& block : blockCompletions()) out.push_back(std::move(block));
    return out;
}

namespace {

/// Nothing is offered for a word that is complete: Enter takes the field as it is.
std::vector<kit::Completion> unlessComplete(std::vector<kit::Completion> all, const QString& text) {
    const QString word = text.section(':', -1).trimmed();
    const bool isComplete = std::any_of(all.begin(), all.end(), [&](const kit::Completion& each) {
        return each.text.compare(word, Qt::CaseInsensitive) == 0;
    });
    return isComplete ? std::vector<kit::Completion>() : all;
}

} // namespace

std::vector<kit::Completion> LadderView::completions(const QString& text, int cursor) const {
    if (m_fieldKind == FieldKind::Comment || m_fieldKind == FieldKind::Statement) return {};
    if (m_fieldKind == FieldKind::Block) {
        if (!text.left(cursor).contains(':')) return {};
        return unlessComplete(blockCompletions(), text.left(cursor));
    }
    if (text.left(cursor).contains(':')) return unlessComplete(typeCompletions(), text.left(cursor));
    const QString typed = text.startsWith('/') ? text.mid(1) : text;
    const int shift = static_cast<int>(text.size() - typed.size());
    std::vector<kit::Completion> out = namesAt(typed, cursor - shift, [](const QString&) { return true; });
    for (kit::Completion& each : out)
        if (each.replaceFrom >= 0) each.replaceFrom += shift;
    return out;
}

} // namespace plc::editor
