// What is done to a ladder diagram by keyboard, mouse, menu and the field in place.
#include "editor/graph/ladder_view.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

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

bool isContact(const Node& node) {
    return node.kind == NodeKind::Contact || node.kind == NodeKind::Compare || node.kind == NodeKind::Edge;
}

} // namespace

bool LadderView::canEdit() {
    if (m_syntax && !m_isStale) return true;
    emit failed(tr("Fix the text first: this is the last good drawing"));
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
    openField(
        place, text, at,
        [this, kind, make = std::move(make)](const QString& typed) -> Result<Edits> {
            const std::string word = kind == FieldKind::Operand ? spelled(typed) : typed.trimmed().toStdString();
            Result<Edits> edits = make(word);
            if (!edits || (kind != FieldKind::Operand && kind != FieldKind::Place)) return edits;
            return withDeclaration(*edits, nameIn(word), "BOOL");
        },
        kind == FieldKind::Operand || kind == FieldKind::Place);
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

// ------------------------------------------------------------------ the field

QString LadderView::complaintOf(const QString& text) const {
    if (!m_makeEdits || text.trimmed().isEmpty() || text == m_fieldBegin) return {};
    const Result<Edits> edits = m_makeEdits(text);
    return edits ? QString() : kit::messageText(edits.error());
}

std::vector<kit::Completion> LadderView::completions(const QString& text, int cursor) const {
    if (m_fieldKind == FieldKind::Comment || m_fieldKind == FieldKind::Statement) return {};
    if (m_fieldKind == FieldKind::Block) {
        std::vector<kit::Completion> out;
        if (!text.left(cursor).contains(':')) return out;
        for (const char* block : {"TON", "TOF", "TP", "CTU", "CTD", "SR", "RS", "R_TRIG", "F_TRIG"})
            out.push_back({block, tr("block"), kit::Icon::Layers});
        return out;
    }
    const QString typed = text.startsWith('/') ? text.mid(1) : text;
    const int shift = static_cast<int>(text.size() - typed.size());
    std::vector<kit::Completion> out = namesAt(typed, cursor - shift, [](const QString&) { return true; });
    for (kit::Completion& each : out)
        if (each.replaceFrom >= 0) each.replaceFrom += shift;
    return out;
}

} // namespace plc::editor
