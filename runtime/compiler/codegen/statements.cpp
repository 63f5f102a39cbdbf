// Statements. Each has a site: the number by which faults, breakpoints and coverage name its place in the text.
#include "runtime/compiler/codegen/emitter.h"

namespace plc::codegen {

using tree::Stmt;
using tree::StmtKind;
using types::TypeKind;

namespace {
// Fewer outside of loops: there the cut costs nothing, in a loop it is paid in each pass.
constexpr uint32_t kStraight = 40, kStraightInLoop = 200; // statements in a row
} // namespace

void FunctionEmitter::body(const std::vector<Stmt*>& statements) {
    uint32_t inARow = 0;
    for (const Stmt* stmt : statements) {
        if (!stmt) continue;
        statement(*stmt);
        if (!m.isQuick() && ++inARow % (m_loops.empty() ? kStraight : kStraightInLoop) == 0) breakBlock();
    }
}

/// Schedulers and the vectoriser take a time that grows with the square of a block: converted ladder diagrams are
/// thousands of assignments in a row. A branch that LLVM cannot see through cuts them.
void FunctionEmitter::breakBlock() {
    if (b.GetInsertBlock()->getTerminator()) return;
    llvm::LoadInst* depth = loadContext(m.i32, offsetof(image::RuntimeContext, depth));
    depth->setVolatile(true);
    guard(b.CreateICmpEQ(depth, int32(0xffffffffu)), image::FaultCode::StackOverflow);
}

void FunctionEmitter::statement(const Stmt& stmt) {
    // Writes are reported with the statement that caused them, also from inside of its parts.
    const tree::Stmt* around = std::exchange(m_cause, &stmt);
    if (stmt.kind != StmtKind::Label && stmt.kind != StmtKind::While) watch(image::WatchKind::Statement, &stmt);
    plainStatement(stmt);
    m_cause = around;
}

void FunctionEmitter::plainStatement(const Stmt& stmt) {
    // Temporaries live as long as their statement.
    const uint64_t top = m_temporaryTop;
    if (stmt.kind != StmtKind::Label && stmt.kind != StmtKind::While) setSite(stmt);
    switch (stmt.kind) {
    case StmtKind::Assign:
        assign(stmt);
        break;
    case StmtKind::Bind:
        bind(stmt);
        break;
    case StmtKind::Evaluate:
        if (stmt.a) {
            // A call for its effect: what it returns is not looked at.
            if (m.types().kind(stmt.a->type) == TypeKind::Void || stmt.a->kind == tree::ExprKind::Call) {
                if (stmt.a->kind == tree::ExprKind::Call)
                    call(*stmt.a->call);
                else
                    scalar(*stmt.a);
            } else if (m.types().isText(stmt.a->type)) {
                text(*stmt.a);
            } else if (m.isScalar(stmt.a->type)) {
                scalar(*stmt.a);
            } else {
                aggregate(*stmt.a);
            }
        }
        break;
    case StmtKind::If:
        ifStatement(stmt);
        break;
    case StmtKind::Case:
        caseStatement(stmt);
        break;
    case StmtKind::While:
        whileLoop(stmt);
        break;
    case StmtKind::Repeat:
        repeatLoop(stmt);
        break;
    case StmtKind::For:
        forLoop(stmt);
        break;
    case StmtKind::Try:
        protectedStatement(stmt);
        break;
    case StmtKind::Exit:
        leave(image::Leaving::Exit);
        break;
    case StmtKind::Continue:
        leave(image::Leaving::Continue);
        break;
    case StmtKind::Return:
        leave(image::Leaving::Return);
        break;
    case StmtKind::Label: {
        // The block may exist already, made by a jump from above.
        Block* block = labelBlock(stmt.label);
        jump(block);
        enter(block);
        if (stmt.label.index() < m_labelPlaced.size()) m_labelPlaced[stmt.label.index()] = true;
        break;
    }
    case StmtKind::Jump: {
        Block* skip = stmt.a ? newBlock("no_jump") : nullptr;
        if (stmt.a) {
            Value* condition = scalar(*stmt.a);
            Block* take = newBlock("jump");
            b.CreateCondBr(condition, take, skip);
            enter(take);
        }
        Block* target = labelBlock(stmt.label);
        if (stmt.label.index() < m_labelPlaced.size() && m_labelPlaced[stmt.label.index()])
            // Only backwards: a jump forward ends by itself.
            chargeUnits(m.facts.work().ofJump(m_index)); // backwards: a loop
        b.CreateBr(target);
        // What follows cannot be reached, but is emitted as well and needs a block.
        enter(skip ? skip : newBlock("dead"));
        break;
    }
    case StmtKind::Block:
        body(stmt.body);
        break;
    }
    m_temporaryTop = top;
}

FunctionEmitter::Block* FunctionEmitter::labelBlock(tree::LabelId label) {
    if (label.index() >= m_labels.size()) {
        m_labels.resize(label.index() + 1, nullptr);
        m_labelPlaced.resize(label.index() + 1, false);
    }
    if (!m_labels[label.index()]) m_labels[label.index()] = newBlock("label");
    return m_labels[label.index()];
}

// By kind of value: texts and aggregates are made in place where no part of the target is read meanwhile.
void FunctionEmitter::assign(const Stmt& stmt) {
    const tree::Place& place = *stmt.place;
    if (m.types().isText(place.type)) {
        if (mayOverlap(*stmt.a, place)) {
            // t := CONCAT('a', t): written in place it would read what it has overwritten.
            const Text made = textTemporary(place.type);
            textInto(*stmt.a, made);
            assignText(textAt(address(place)), made);
        } else {
            textInto(*stmt.a, textAt(address(place)));
        }
        return;
    }
    if (m.isScalar(place.type)) {
        Value* value = scalar(*stmt.a);
        // Before the store: a variable of a subrange never holds a value outside, not even until the fault is seen.
        guardRange(value, *stmt.a, place.type);
        // The target after the value: a[i] := F() uses the i that F leaves.
        store(address(place), value);
        return;
    }
    aggregateInto(*stmt.a, address(place));
}

// An in-out or a reference gets its address: 0 where nothing is bound.
void FunctionEmitter::bind(const Stmt& stmt) {
    const tree::Place& place = *stmt.place;
    Value* at = int64(0);
    std::vector<std::pair<Value*, Value*>> bounds;
    const bool isOpen = m.types().kind(place.type) == TypeKind::OpenArray;
    if (stmt.target) {
        const Address target = address(*stmt.target);
        at = target.isImage ? offset(target) : int64(0);
        if (isOpen) bounds = boundsOf(target);
    } else if (isOpen) {
        // Taken back: an empty array at 0.
        bounds.assign(m.types()[place.type].dimensions.size(), {int64(0), int64(-1)});
    }
    if (place.kind == tree::PlaceKind::Local && m_tree.locals[place.local].isInOut) {
        b.CreateStore(at, m_locals[place.local]);
        for (size_t d = 0; d < bounds.size() && d < m_localBounds[place.local].size(); ++d) {
            b.CreateStore(bounds[d].first, m_localBounds[place.local][d].first);
            b.CreateStore(bounds[d].second, m_localBounds[place.local][d].second);
        }
        // With a place in the frame it is written there as well, for the debugger and for protected parts.
        if (m_facts.frame.offsets[place.local] == kNoFrame) return;
        Address slot;
        slot.base = m_framePointer;
        slot.constant = m_facts.frame.offsets[place.local];
        b.CreateAlignedStore(at, pointer(slot), llvm::Align(1));
        watchPlace(image::WatchKind::Write, &stmt, slot, 8);
        return;
    }
    Address slot = place.kind == tree::PlaceKind::InOutSlot ? slotAddress(place) : address(place);
    b.CreateAlignedStore(at, pointer(slot), llvm::Align(1));
    watchPlace(image::WatchKind::Write, &stmt, slot, 8);
    for (auto [low, high] : bounds)
        for (Value* value : {low, high}) {
            slot.constant += 8;
            b.CreateAlignedStore(value, pointer(slot), llvm::Align(1));
        }
}

/// A row of ELSIFs ends in one block and is emitted without recursion, however long it is.
void FunctionEmitter::ifStatement(const Stmt& first) {
    Block* done = newBlock("done");
    for (const Stmt* stmt = &first; stmt; stmt = facts::elseIf(*stmt)) {
        if (stmt != &first) {
            setSite(*stmt);
            m_cause = stmt;
            watch(image::WatchKind::Statement, stmt);
        }
        const uint64_t top = m_temporaryTop;
        Value* condition = scalar(*stmt->a);
        Block* yes = newBlock("then");
        // Without ELSE the condition branches past the statement.
        Block* no = stmt->elseBody.empty() ? done : newBlock("else");
        b.CreateCondBr(condition, yes, no);
        enter(yes);
        watch(image::WatchKind::Arm, stmt, int64(1));
        body(stmt->body);
        jump(done);
        m_temporaryTop = top;
        if (no == done) break;
        enter(no);
        watch(image::WatchKind::Arm, stmt, int64(0));
        if (facts::elseIf(*stmt)) continue;
        body(stmt->elseBody);
        jump(done);
    }
    enter(done);
}

// Labels are constants: short ranges become cases of a switch, which LLVM makes a table of.
void FunctionEmitter::caseStatement(const Stmt& stmt) {
    // A switch with a case for each value of 0..1000000 would be a table of that size.
    constexpr uint64_t kExpanded = 64; // wider ranges are compared
    Value* selector = castInteger(scalar(*stmt.a), stmt.a->type, m.i64);
    const bool isUnsigned = m.types().family(stmt.a->type) == types::Family::Unsigned ||
                            m.types().family(stmt.a->type) == types::Family::Bits;
    Block* otherwise = newBlock("else");
    Block* done = newBlock("done");
    llvm::SwitchInst* choice = b.CreateSwitch(selector, otherwise);
    std::vector<Block*> arms;
    struct Wide {
        const tree::CaseRange* range;
        Block* arm;
    };
    std::vector<Wide> wide;
    std::set<int64_t> taken;
    for (const tree::CaseArm& arm : stmt.arms) {
        arms.push_back(newBlock("arm"));
        for (const tree::CaseRange& range : arm.ranges) {
            // Without a sign: from the least to the greatest number is more than a signed one can hold.
            const uint64_t count = static_cast<uint64_t>(range.high) - static_cast<uint64_t>(range.low);
            if (isUnsigned ? static_cast<uint64_t>(range.high) < static_cast<uint64_t>(range.low)
                           : range.high < range.low)
                continue;
            if (count >= kExpanded) {
                wide.push_back({&range, arms.back()});
                continue;
            }
            for (uint64_t i = 0; i <= count; ++i) {
                const auto value = static_cast<int64_t>(static_cast<uint64_t>(range.low) + i);
                // LLVM refuses the same value twice: enumerators may share a number.
                if (taken.insert(value).second) choice->addCase(b.getInt64(static_cast<uint64_t>(value)), arms.back());
            }
        }
    }
    // Comparisons of wide ranges come before ELSE, in the order of the text: the first that fits wins.
    enter(otherwise);
    for (const Wide& w : wide) {
        Value* span =
            int64(static_cast<int64_t>(static_cast<uint64_t>(w.range->high) - static_cast<uint64_t>(w.range->low)));
        Block* next = newBlock("range");
        // Unsigned: what is below the lower end wraps to a large distance, so that one compare asks for both ends.
        b.CreateCondBr(b.CreateICmpULE(b.CreateSub(selector, int64(w.range->low)), span), w.arm, next);
        enter(next);
    }
    watch(image::WatchKind::Arm, &stmt, int64(-1));
    body(stmt.elseBody);
    jump(done);
    for (size_t i = 0; i < stmt.arms.size(); ++i) {
        enter(arms[i]);
        watch(image::WatchKind::Arm, &stmt, int64(static_cast<int64_t>(i)));
        body(stmt.arms[i].body);
        jump(done);
    }
    enter(done);
}

} // namespace plc::codegen
