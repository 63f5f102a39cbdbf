#include "projects/loops/trial.h"
#include "runtime/compiler/tree/tree.h"

#include <functional>

namespace plc::loops {

namespace {

/// Where a place of the tree is in the image, seen from an instance; none where that depends on more.
std::optional<uint32_t> offsetOf(const tree::Place& place, uint32_t self) {
    switch (place.kind) {
    case tree::PlaceKind::Absolute:
        return place.offset;
    case tree::PlaceKind::Instance:
        return self + place.offset;
    case tree::PlaceKind::Field:
        if (const auto base = offsetOf(*place.base, self)) return *base + place.offset;
        return std::nullopt;
    case tree::PlaceKind::Local:
    case tree::PlaceKind::InOutSlot:
    case tree::PlaceKind::Index:
    case tree::PlaceKind::Bit:
    case tree::PlaceKind::TextIndex:
    case tree::PlaceKind::Deref:
    case tree::PlaceKind::Temporary:
        return std::nullopt;
    }
    return std::nullopt;
}

using VisitStatement = std::function<void(const tree::Stmt&)>;

void forEachStatement(const std::vector<tree::Stmt*>& body, const VisitStatement& visit) {
    for (const tree::Stmt* statement : body) {
        visit(*statement);
        forEachStatement(statement->body, visit);
        forEachStatement(statement->elseBody, visit);
        for (const tree::CaseArm& arm : statement->arms) forEachStatement(arm.body, visit);
    }
}

const tree::Expr& withoutConversion(const tree::Expr& expression) {
    const tree::Expr* at = &expression;
    while (at->kind == tree::ExprKind::Convert && at->a) at = at->a;
    return *at;
}

/// An assignment that fills a pin, or the structure that the pin is a member of.
struct Filling {
    bool isThere = false;
    std::string path; // of what it is filled from
};

class Bodies {
public:
    Bodies(const tree::Program& program, const image::Layout& layout) : m_program(program), m_layout(layout) {}

    [[nodiscard]] Filling fillingOf(const image::Place& owner, const image::Place& pin) const {
        Filling out;
        for (const tree::Function& function : m_program.functions) {
            if (function.instanceType != owner.type) continue;
            forEachStatement(function.body, [&](const tree::Stmt& statement) {
                if (statement.kind == tree::StmtKind::Assign && statement.place && statement.a)
                    look(statement, owner.offset, pin, out);
            });
        }
        return out;
    }

private:
    void look(const tree::Stmt& statement, uint32_t self, const image::Place& pin, Filling& out) const {
        const auto target = offsetOf(*statement.place, self);
        const uint32_t size = (*m_program.types)[statement.place->type].size;
        if (!target || pin.offset < *target || pin.offset >= *target + size) return;
        out.isThere = true;
        const tree::Expr& source = withoutConversion(*statement.a);
        if (source.kind != tree::ExprKind::Load || !source.place) return;
        if (const auto from = offsetOf(*source.place, self))
            out.path = m_layout.pathAt(*from + (pin.offset - *target), pin.type);
    }
    const tree::Program& m_program;
    const image::Layout& m_layout;
};

} // namespace

std::string sourceOf(const Loop& loop, const ProgramPointer& program, std::string_view pin) {
    const std::string own = loop.pin(pin);
    const tree::Program* tree = driver::treeOf(program);
    const size_t dot = loop.instance.rfind('.');
    if (!tree || dot == std::string::npos) return own;
    const auto owner = program->layout.find(loop.instance.substr(0, dot));
    const auto place = program->layout.find(own);
    if (!owner || !place) return own;
    const Filling filling = Bodies(*tree, program->layout).fillingOf(*owner, *place);
    return filling.isThere ? filling.path : own;
}

std::vector<Target> targetsOf(const Loop& loop, const ProgramPointer& program) {
    std::vector<Target> out;
    for (const tuning::ParameterForm& parameter : loop.form->parameters)
        out.push_back({std::string(parameter.member), sourceOf(loop, program, parameter.member)});
    return out;
}

} // namespace plc::loops
