#include "runtime/compiler/facts/writes.h"

#include "runtime/compiler/facts/walk.h"

#include <algorithm>

namespace plc::facts {

using tree::Expr;
using tree::ExprKind;
using tree::Place;
using tree::PlaceKind;

void WriteSummary::addAbsolute(Extent extent) {
    constexpr size_t kMany = 32; // then one extent around all
    for (Extent& known : absolutes) {
        if (extent.begin > known.end || known.begin > extent.end) continue;
        known = {std::min(known.begin, extent.begin), std::max(known.end, extent.end)};
        return;
    }
    absolutes.push_back(extent);
    if (absolutes.size() <= kMany) return;
    Extent all = absolutes.front();
    for (const Extent& each : absolutes) all = {std::min(all.begin, each.begin), std::max(all.end, each.end)};
    absolutes = {all};
}

bool extentOf(const types::TypeTable& types, const Place& place, WriteSummary::Extent& extent) {
    const Place* whole = &place; // the outermost part without an index below it
    for (const Place* p = &place; p; p = p->base) {
        if (p->kind == PlaceKind::InOutSlot || p->kind == PlaceKind::Deref || p->kind == PlaceKind::Temporary)
            return false;
        if ((p->kind == PlaceKind::Index || p->kind == PlaceKind::TextIndex || p->kind == PlaceKind::Bit) && p->base)
            whole = p->base;
    }
    extent.begin = 0;
    for (const Place* p = whole; p; p = p->base) extent.begin += p->offset;
    extent.end = extent.begin + std::max(1u, types[whole->type].size);
    return true;
}

namespace {
class WriteScan : public Walker {
public:
    WriteScan(const tree::Program& program, WriteSummary& writes) : m_program(program), m_writes(writes) {}

protected:
    void onPlace(const Place& place, Use use) override {
        if (use == Use::Read || place.kind == PlaceKind::Temporary) return;
        const Place& root = rootOf(place);
        if (root.kind == PlaceKind::Local) return; // its own, or an IN_OUT: the caller's affair
        WriteSummary::Extent extent;
        if (!extentOf(*m_program.types, place, extent))
            m_writes.anything = true;
        else if (root.kind == PlaceKind::Instance)
            m_writes.instance = true;
        else
            m_writes.addAbsolute(extent);
    }
    void onExpr(const Expr& expr) override {
        if (expr.kind != ExprKind::Call || !expr.call) return;
        if (expr.call->dispatch != tree::Call::Dispatch::Direct) m_writes.anything = true;
    }

private:
    const tree::Program& m_program;
    WriteSummary& m_writes;
};
} // namespace

WriteSummary ownWrites(const tree::Program& program, uint32_t function) {
    WriteSummary writes;
    WriteScan(program, writes).walkFunction(program.functions[function]);
    return writes;
}

} // namespace plc::facts
