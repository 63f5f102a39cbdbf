// Loops, each pass paid from the budget. A FOR whose variable its body leaves alone is counted: the number of passes is
// known on entry and charged in portions, and the variable is a counter in a register.
#include "runtime/compiler/codegen/emitter.h"

namespace plc::codegen {

using tree::ExprKind;
using tree::Place;
using tree::PlaceKind;
using tree::Stmt;
using types::TypeKind;

namespace {
/// Units charged at once: few enough for a watchdog to be asked now and then, enough to cost nothing.
constexpr uint64_t kPortionUnits = 65'536;
/// 64-bit loops longer than this never end anyway.
constexpr int64_t kEndless = int64_t(1) << 62;
} // namespace

// CONTINUE goes to `next`, EXIT to `exit`; the end of the body goes to `next` as well.
void FunctionEmitter::loopBody(const std::vector<Stmt*>& statements, Block* exit, Block* next) {
    m_loops.push_back({exit, next});
    body(statements);
    m_loops.pop_back();
    jump(next);
}

void FunctionEmitter::whileLoop(const Stmt& stmt) {
    Block* head = newBlock("while");
    Block* pass = newBlock("pass");
    Block* done = newBlock("done");
    b.CreateBr(head);
    enter(head);
    // The head is entered from before and from the end of each pass.
    setSite(stmt); // every pass: a breakpoint on the condition stops each time
    watch(image::WatchKind::Statement, &stmt);
    Value* condition = scalar(*stmt.a);
    b.CreateCondBr(condition, pass, done);
    enter(pass);
    chargeUnits(m.facts.work().ofPass(stmt));
    watch(image::WatchKind::Pass, &stmt);
    loopBody(stmt.body, done, head);
    enter(done);
}

void FunctionEmitter::repeatLoop(const Stmt& stmt) {
    // The condition is written at the end, so its site is that of UNTIL.
    const uint32_t site = m_site;
    Block* pass = newBlock("repeat");
    Block* until = newBlock("until");
    Block* done = newBlock("done");
    b.CreateBr(pass);
    enter(pass);
    chargeUnits(m.facts.work().ofPass(stmt));
    watch(image::WatchKind::Pass, &stmt);
    loopBody(stmt.body, done, until);
    enter(until);
    m_site = site;
    Value* condition = scalar(*stmt.a);
    b.CreateCondBr(condition, done, pass);
    enter(done);
}

// ---------------------------------------------------------------- FOR

namespace {
/// Looks for anything in a loop's body that could write the loop's variable.
class WriteFinder : public Walker {
public:
    WriteFinder(const tree::Program& program, const ProgramFacts& facts, const tree::Function& function,
                const Place& variable)
        : m_program(program), m_facts(facts), m_function(function), m_root(rootOf(variable)) {
        m_isLocal = m_root.kind == PlaceKind::Local;
        extentOf(*program.types, variable, m_extent);
    }
    // In doubt it is found: a counter that is written behind the emitter's back would be a wrong program, a stepped
    // loop is only slower.
    bool found = false;

protected:
    void onPlace(const Place& place, Use use) override {
        if (use == Use::Read || place.kind == PlaceKind::Temporary) return;
        const Place& root = rootOf(place);
        if (m_isLocal) {
            // Its address never leaves (then it is no counter): only a direct write counts.
            if (root.kind == PlaceKind::Local && root.local == m_root.local) found = true;
            return;
        }
        // Locals of this function are apart from what the loop counts in, which is none of them.
        if (root.kind == PlaceKind::Local && !m_function.locals[root.local].isInOut) return;
        WriteSummary::Extent extent;
        if (root.kind == PlaceKind::Local || !extentOf(*m_program.types, place, extent)) found = true;
        // One is absolute, the other relative to THIS: they meet only where a block is.
        else if (root.kind != m_root.kind)
            found = found || mayMeet(root, extent);
        else if (extent.begin < m_extent.end && m_extent.begin < extent.end)
            found = true;
    }
    void onExpr(const tree::Expr& expr) override {
        // A local whose address is not taken is out of every callee's reach.
        if (expr.kind != ExprKind::Call || !expr.call || m_isLocal) return;
        if (expr.call->dispatch != tree::Call::Dispatch::Direct) {
            found = true;
            return;
        }
        // Its THIS and its IN_OUTs are places of this call and looked at as such.
        const WriteSummary& writes = m_facts[expr.call->callee.value].writes;
        // A callee that writes through pointers may write anything.
        found = found || writes.anything;
        for (const WriteSummary::Extent& extent : writes.absolutes) {
            if (m_root.kind == PlaceKind::Absolute)
                found = found || (extent.begin < m_extent.end && m_extent.begin < extent.end);
            else
                found = found || holdsBlocks(extent);
        }
    }

private:
    /// THIS may lie where an absolute place lies, if that is within an instance.
    bool mayMeet(const Place& root, const WriteSummary::Extent& extent) const {
        if (root.kind == PlaceKind::Absolute) return holdsBlocks(extent);
        return holdsBlocks(m_extent); // the variable is absolute, the write relative to THIS
    }
    bool holdsBlocks(const WriteSummary::Extent& extent) const {
        for (const image::Root& r : m_program.layout.roots) {
            const uint32_t end = r.offset + std::max(1u, (*m_program.types)[r.type].size);
            if (extent.begin < end && r.offset < extent.end && !m_program.types->isText(r.type) &&
                m_program.types->isAggregate(r.type) && mayHoldBlock(r.type))
                return true;
        }
        return false;
    }
    // THIS can only be where a block is declared, alone or as a part of something.
    bool mayHoldBlock(types::TypeId id) const {
        const types::Type& type = (*m_program.types)[id];
        if (type.kind == TypeKind::Block) return true;
        if (type.kind == TypeKind::Array) return mayHoldBlock(type.element);
        for (const types::Field& field : type.fields)
            if (mayHoldBlock(field.type)) return true;
        return false;
    }
    const tree::Program& m_program;
    const ProgramFacts& m_facts;
    const tree::Function& m_function;
    const Place& m_root;
    bool m_isLocal = false;
    WriteSummary::Extent m_extent;
};
} // namespace

// A variable at a place that is not fixed (behind a pointer, an element with a variable index) may be anywhere.
bool FunctionEmitter::mayChange(const Place& variable, const std::vector<Stmt*>& statements) {
    for (const Place* p = &variable; p; p = p->base)
        if (p->kind != PlaceKind::Absolute && p->kind != PlaceKind::Instance && p->kind != PlaceKind::Local &&
            p->kind != PlaceKind::Field)
            return true;
    // Its byte is shared with others.
    if (variable.bit >= 0) return true;
    const Place& root = rootOf(variable);
    if (root.kind == PlaceKind::Local) {
        const tree::Local& local = m_tree.locals[root.local];
        if (local.isInOut) return true;
        if (m.isQuick() ? local.isAddressTaken : m_facts.frame.offsets[root.local] != kNoFrame && local.isAddressTaken)
            return true;
        if (!m.isScalar(local.type)) return true;
    }
    WriteFinder finder(m.program, m.facts, m_tree, variable);
    finder.walkBody(statements);
    return finder.found;
}

const FunctionEmitter::Counter* FunctionEmitter::counterOf(const Place& place) const {
    // The innermost loop with this variable; nested loops with the same one are not counted, because one writes the
    // other's.
    for (auto it = m_counters.rbegin(); it != m_counters.rend(); ++it) {
        const Place* a = it->variable;
        const Place* c = &place;
        while (a && c && a->kind == c->kind && a->offset == c->offset && a->local == c->local && a->bit == c->bit) {
            a = a->base;
            c = c->base;
        }
        if (!a && !c) return &*it;
    }
    return nullptr;
}

llvm::Value* FunctionEmitter::widen(const ForLoop& loop, Value* value) {
    return loop.isSigned ? b.CreateSExt(value, m.i64) : b.CreateZExt(value, m.i64);
}

// Start, end and step are computed once, before the variable is written: FOR i := i TO i + 3 reads the old i.
void FunctionEmitter::forLoop(const Stmt& stmt) {
    const types::TypeId type = stmt.place->type;
    const types::TypeId counted = stmt.operandType.isValid() ? stmt.operandType : type;
    auto* narrow = llvm::cast<llvm::IntegerType>(m.scalarType(type));
    const auto isSignedFamily = [&](types::TypeId id) {
        return m.types().family(id) == types::Family::Signed || m.types().family(id) == types::Family::Duration;
    };
    // The three are computed in the type the loop counts in, which may be wider than the variable's (BY -1 with an
    // unsigned one).
    const auto value = [&](const tree::Expr* expr) -> Value* {
        return expr ? castInteger(scalar(*expr), expr->type.isValid() ? expr->type : counted, m.i64) : int64(1);
    };
    ForLoop loop{stmt,    {},      narrow, isSignedFamily(type), narrow->getBitWidth() < 64 || isSignedFamily(counted),
                 nullptr, nullptr, nullptr};
    loop.first = value(stmt.a);
    loop.last = value(stmt.b);
    loop.step = value(stmt.c);
    if (stmt.c && stmt.c->kind == ExprKind::Constant && std::holds_alternative<int64_t>(stmt.c->value.data))
        // As a constant, also when it was converted: its sign decides which comparison is emitted.
        loop.step = int64(stmt.c->value.integer());
    const unsigned bits = narrow->getBitWidth();
    if (bits < 64) {
        const int64_t low = loop.isSigned ? -(int64_t(1) << (bits - 1)) : 0;
        const int64_t high = loop.isSigned ? (int64_t(1) << (bits - 1)) - 1 : (int64_t(1) << bits) - 1;
        if (m.types()[m.types().storage(counted)].size * 8 > bits) {
            loop.first = widen(loop, b.CreateTrunc(loop.first, narrow));
            // a limit that the variable cannot reach would never be passed: it is brought into its range
            loop.last = b.CreateSelect(b.CreateICmpSLT(loop.last, int64(low)), int64(low), loop.last);
            loop.last = b.CreateSelect(b.CreateICmpSGT(loop.last, int64(high)), int64(high), loop.last);
        }
    }
    // Once, in front of the loop: FOR a[i] := … with i changed inside counts the same element on (7.3.3.4.2).
    loop.variable = address(*stmt.place);
    storeCounter(loop, loop.first);
    // A label makes it possible to jump into the body: then nothing may be known that only the way through the head
    // makes true.
    if (m_tree.labelCount > 0 || m_facts.hasTry || mayChange(*stmt.place, stmt.body))
        steppedLoop(loop);
    else
        countedLoop(loop);
}

std::pair<llvm::Value*, llvm::Value*> FunctionEmitter::stepped(const ForLoop& loop, Value* value64) {
    if (loop.type->getBitWidth() < 64) {
        // Below 64 bits the sum cannot overflow: leaving the range of the type is a comparison.
        Value* next = b.CreateAdd(value64, loop.step);
        const unsigned bits = loop.type->getBitWidth();
        const int64_t low = loop.isSigned ? -(int64_t(1) << (bits - 1)) : 0;
        const int64_t high = loop.isSigned ? (int64_t(1) << (bits - 1)) - 1 : (int64_t(1) << bits) - 1;
        return {next, b.CreateICmpULE(b.CreateSub(next, int64(low)), int64(high - low))};
    }
    Value* next = b.CreateAdd(value64, loop.step);
    // In 64 bits an overflow shows as a step in the wrong direction.
    Value* isUp = b.CreateICmpSGT(loop.step, int64(0));
    using P = llvm::CmpInst;
    Value* above = b.CreateICmp(loop.isSigned ? P::ICMP_SGT : P::ICMP_UGT, next, value64);
    Value* below = b.CreateICmp(loop.isSigned ? P::ICMP_SLT : P::ICMP_ULT, next, value64);
    return {next, b.CreateSelect(isUp, above, below)};
}

void FunctionEmitter::storeCounter(const ForLoop& loop, Value* value64) {
    store(loop.variable, b.CreateTrunc(value64, loop.type));
}

Range FunctionEmitter::counterRange(const ForLoop& loop) const {
    // What an index check may rely on inside of the body.
    Range range;
    const unsigned bits = loop.type->getBitWidth();
    if (bits < 64) {
        range.low = loop.isSigned ? -(int64_t(1) << (bits - 1)) : 0;
        range.high = loop.isSigned ? (int64_t(1) << (bits - 1)) - 1 : (int64_t(1) << bits) - 1;
    } else if (!loop.isSigned) {
        return range;
    }
    const auto* step = llvm::dyn_cast<llvm::ConstantInt>(loop.step);
    if (!step) return range;
    const bool isUp = !step->isNegative();
    const auto* low = llvm::dyn_cast<llvm::ConstantInt>(isUp ? loop.first : loop.last);
    const auto* high = llvm::dyn_cast<llvm::ConstantInt>(isUp ? loop.last : loop.first);
    if (low) range.low = low->getSExtValue();
    if (high) range.high = high->getSExtValue();
    return range;
}

/// Two loops in one another: the inner one makes the passes of a portion, the outer one pays for a portion at once. A
/// charge in every pass would keep the optimiser from unrolling and vectorising.
void FunctionEmitter::countedLoop(const ForLoop& loop) {
    using P = llvm::CmpInst;
    // BY 0 would never end: no pass is made
    Value* isUp = b.CreateICmpSGT(loop.step, int64(0));
    Value* isZero = b.CreateICmpEQ(loop.step, int64(0));
    Value* upwards = b.CreateICmp(loop.comparesSigned ? P::ICMP_SLE : P::ICMP_ULE, loop.first, loop.last);
    Value* downwards = b.CreateICmp(loop.comparesSigned ? P::ICMP_SGE : P::ICMP_UGE, loop.first, loop.last);
    Value* enters = b.CreateAnd(b.CreateSelect(isUp, upwards, downwards), b.CreateNot(isZero));
    Value* distance = b.CreateSelect(isUp, b.CreateSub(loop.last, loop.first), b.CreateSub(loop.first, loop.last));
    // |BY|: the least number is its own negative, and as an unsigned divisor it is right.
    Value* pace = b.CreateSelect(isUp, loop.step, b.CreateNeg(loop.step));
    const auto* knownPace = llvm::dyn_cast<llvm::ConstantInt>(pace);
    // unsigned: the distance between two signed numbers may need all 64 bits
    // Passes behind the first one.
    Value* more =
        knownPace && knownPace->isOne() ? distance : b.CreateUDiv(distance, b.CreateSelect(isZero, int64(1), pace));
    if (loop.type->getBitWidth() == 64)
        more = b.CreateSelect(b.CreateICmpULT(more, int64(kEndless)), more, int64(kEndless));

    // Three slots that mem2reg turns into registers.
    llvm::AllocaInst* counter = newSlot(m.i64, "counter");
    llvm::AllocaInst* left = newSlot(m.i64, "left");   // in this portion
    llvm::AllocaInst* later = newSlot(m.i64, "later"); // behind it
    const auto* known = llvm::dyn_cast<llvm::ConstantInt>(more);
    const uint64_t ofPass = m.facts.work().ofPass(loop.stmt);
    const auto portionPasses = static_cast<int64_t>(std::max<uint64_t>(1, kPortionUnits / ofPass));
    // FOR i := 1 TO 10: paid for at once, and the outer loop is not there.
    const bool inPortions = !known || known->getZExtValue() >= static_cast<uint64_t>(portionPasses);

    Block* portion = newBlock("portion");
    Block* pass = newBlock("for");
    Block* next = newBlock("next");
    Block* again = newBlock("again");
    Block* finished = newBlock("finished");
    Block* done = newBlock("done");
    b.CreateStore(loop.first, counter);
    b.CreateStore(more, later);
    b.CreateCondBr(enters, portion, done);

    enter(portion);
    Value* behind = b.CreateLoad(m.i64, later);
    Value* taken = behind;
    if (inPortions)
        // portionPasses - 1: the pass that is entered first is counted apart.
        taken = b.CreateSelect(b.CreateICmpULT(behind, int64(portionPasses)), behind, int64(portionPasses - 1));
    else
        taken = more;
    b.CreateStore(taken, left);
    if (inPortions) b.CreateStore(b.CreateSub(behind, taken), later);
    charge(b.CreateMul(b.CreateAdd(taken, int64(1)), int64(static_cast<int64_t>(ofPass))));
    b.CreateBr(pass);

    enter(pass);
    watch(image::WatchKind::Pass, &loop.stmt);
    // nothing in the body writes the variable: reading it is reading the counter, whose range spares index checks
    if (!m.isQuick()) m_counters.push_back({loop.stmt.place, counter, counterRange(loop)});
    loopBody(loop.stmt.body, done, next);
    if (!m.isQuick()) m_counters.pop_back();

    enter(next);
    Value* remaining = b.CreateLoad(m.i64, left);
    Block* portionEnd = inPortions ? newBlock("portion_end") : finished;
    b.CreateCondBr(b.CreateICmpSLE(remaining, int64(0)), portionEnd, again);
    enter(again);
    b.CreateStore(b.CreateSub(remaining, int64(1)), left);
    Value* following = b.CreateAdd(b.CreateLoad(m.i64, counter), loop.step);
    b.CreateStore(following, counter);
    storeCounter(loop, following);
    b.CreateBr(pass);
    if (inPortions) {
        enter(portionEnd);
        Value* rest = b.CreateLoad(m.i64, later);
        Block* more2 = newBlock("next_portion");
        b.CreateCondBr(b.CreateICmpSLE(rest, int64(0)), finished, more2);
        enter(more2);
        b.CreateStore(b.CreateSub(rest, int64(1)), later);
        Value* first = b.CreateAdd(b.CreateLoad(m.i64, counter), loop.step);
        b.CreateStore(first, counter);
        storeCounter(loop, first);
        b.CreateBr(portion);
    }

    // One step past the limit, where the type has such a value.
    enter(finished);
    Value* lastValue = b.CreateLoad(m.i64, counter);
    // FOR i := 1 TO 10 leaves 11 in i, as a loop that is written out would; at the end of the type it keeps the last
    // value.
    auto [past, exists] = stepped(loop, lastValue);
    storeCounter(loop, b.CreateSelect(exists, past, lastValue));
    b.CreateBr(done);
    enter(done);
}

/// The body (or something it calls) may write the variable: every pass reads it again and is charged by itself.
void FunctionEmitter::steppedLoop(const ForLoop& loop) {
    using P = llvm::CmpInst;
    // Slots and not values: a jump into the body from elsewhere does not pass the head that computed them.
    llvm::AllocaInst* last = newSlot(m.i64, "last");
    llvm::AllocaInst* step = newSlot(m.i64, "step");
    b.CreateStore(loop.last, last);
    b.CreateStore(loop.step, step);
    const bool hasLabels = m_tree.labelCount > 0;
    const auto here = [&] {
        ForLoop now = loop;
        now.last = b.CreateLoad(m.i64, last);
        now.step = llvm::isa<llvm::ConstantInt>(loop.step) ? loop.step : b.CreateLoad(m.i64, step);
        // The address was computed at the head as well.
        if (hasLabels) now.variable = address(*loop.stmt.place);
        return now;
    };
    Block* head = newBlock("for");
    Block* pass = newBlock("pass");
    Block* next = newBlock("next");
    Block* advance = newBlock("advance");
    Block* done = newBlock("done");
    b.CreateCondBr(b.CreateICmpEQ(loop.step, int64(0)), done, head);
    enter(head);
    // Read from memory in each pass: the body may have set it.
    const ForLoop atHead = here();
    Value* current = widen(loop, load(atHead.variable));
    Value* isUp = b.CreateICmpSGT(atHead.step, int64(0));
    Value* upwards = b.CreateICmp(loop.comparesSigned ? P::ICMP_SLE : P::ICMP_ULE, current, atHead.last);
    Value* downwards = b.CreateICmp(loop.comparesSigned ? P::ICMP_SGE : P::ICMP_UGE, current, atHead.last);
    b.CreateCondBr(b.CreateSelect(isUp, upwards, downwards), pass, done);
    enter(pass);
    chargeUnits(m.facts.work().ofPass(loop.stmt));
    watch(image::WatchKind::Pass, &loop.stmt);
    loopBody(loop.stmt.body, done, next);
    enter(next);
    const ForLoop atNext = here();
    auto [past, exists] = stepped(atNext, widen(loop, load(atNext.variable)));
    b.CreateCondBr(exists, advance, done);
    enter(advance);
    storeCounter(atNext, past);
    b.CreateBr(head);
    enter(done);
}

} // namespace plc::codegen
