#include "tests/runtime/compiler/codegen/tree_builder.h"

namespace plc::test {

namespace {
std::jmp_buf g_exit;
Bench* g_running = nullptr;
constexpr uint32_t kFrame = 64 * 1024;

void leave(image::RuntimeContext*) { std::longjmp(g_exit, 1); }
void usedUp(image::RuntimeContext* context) {
    ++g_running->refills;
    if (g_running->refill > 0) {
        context->loopBudget = g_running->refill;
        return;
    }
    context->fault = image::FaultCode::Watchdog;
    std::longjmp(g_exit, 1);
}
void atSite(image::RuntimeContext*, uint32_t site, uint32_t, uint32_t frame) {
    g_running->stops.push_back({site, frame});
}
} // namespace

Bench::Bench() : types(*(program.types = std::make_shared<TypeTable>())) {
    program.functions.resize(1);
    m_initial.resize(16 * 1024);
    program.layout.types = program.types;
    jit::setRuntimeSymbols({leave, usedUp, atSite});
}

uint32_t Bench::global(TypeId type, const std::string& name) {
    const types::Type& t = types[type];
    const uint32_t align = std::max(1u, t.align);
    m_next = (m_next + align - 1) / align * align;
    const uint32_t offset = m_next;
    m_next += std::max(1u, t.size);
    image::Root root;
    root.name = name;
    root.type = type;
    root.offset = offset;
    program.layout.roots.push_back(root);
    if (!t.initial.empty()) std::memcpy(m_initial.data() + offset, t.initial.data(), t.size);
    return offset;
}

uint32_t Bench::function(const std::string& name, TypeId result, TypeId instance) {
    tree::Function f;
    f.name = name;
    f.instanceType = instance;
    f.result = result;
    if (result != of(TypeKind::Void)) {
        tree::Local local;
        local.name = name;
        local.type = result;
        local.kind = tree::LocalKind::Result;
        f.resultLocal = 0;
        f.locals.push_back(local);
    }
    program.functions.push_back(std::move(f));
    return static_cast<uint32_t>(program.functions.size() - 1);
}

uint32_t Bench::local(uint32_t f, TypeId type, tree::LocalKind kind, const std::string& name) {
    tree::Local local;
    local.name = name;
    local.type = type;
    local.kind = kind;
    local.isInOut = kind == tree::LocalKind::InOut;
    fn(f).locals.push_back(local);
    return static_cast<uint32_t>(fn(f).locals.size() - 1);
}

Place* Bench::at(uint32_t offset, TypeId type) {
    auto* p = program.arena.make<Place>();
    p->kind = tree::PlaceKind::Absolute;
    p->offset = offset;
    p->type = type;
    return p;
}

Place* Bench::local(uint32_t index, TypeId type) {
    Place* p = at(0, type);
    p->kind = tree::PlaceKind::Local;
    p->local = index;
    return p;
}

Place* Bench::instance(uint32_t offset, TypeId type) {
    Place* p = at(offset, type);
    p->kind = tree::PlaceKind::Instance;
    return p;
}

Place* Bench::slot(uint32_t offset, TypeId type) {
    Place* p = at(offset, type);
    p->kind = tree::PlaceKind::InOutSlot;
    return p;
}

Place* Bench::field(Place* base, uint32_t offset, TypeId type) {
    Place* p = at(offset, type);
    p->kind = tree::PlaceKind::Field;
    p->base = base;
    return p;
}

Place* Bench::element(Place* array, std::vector<Expr*> indices) {
    Place* p = at(0, types[array->type].element);
    p->kind = tree::PlaceKind::Index;
    p->base = array;
    p->indices = std::move(indices);
    return p;
}

Place* Bench::bitOf(Place* base, int bit) {
    Place* p = at(0, of(TypeKind::Bool));
    p->kind = tree::PlaceKind::Bit;
    p->base = base;
    p->bit = static_cast<int16_t>(bit);
    return p;
}

Place* Bench::character(Place* text, Expr* index) {
    Place* p = at(0, of(TypeKind::Char));
    p->kind = tree::PlaceKind::TextIndex;
    p->base = text;
    p->indices = {index};
    return p;
}

Place* Bench::deref(Expr* pointer, TypeId type) {
    Place* p = at(0, type);
    p->kind = tree::PlaceKind::Deref;
    p->pointer = pointer;
    return p;
}

Expr* Bench::constant(TypeId type, int64_t value) {
    auto* e = program.arena.make<Expr>();
    e->kind = tree::ExprKind::Constant;
    e->type = type;
    e->value = {type, value};
    return e;
}

Expr* Bench::real(TypeId type, double value) {
    Expr* e = constant(type, 0);
    e->value = {type, value};
    return e;
}

Expr* Bench::textConstant(const std::string& text) {
    Expr* e = constant(types.string(static_cast<uint32_t>(text.size())), 0);
    e->value = {e->type, text};
    return e;
}

Expr* Bench::load(Place* place) {
    Expr* e = constant(place->type, 0);
    e->kind = tree::ExprKind::Load;
    e->place = place;
    return e;
}

Expr* Bench::binary(BinaryOp op, Expr* a, Expr* c) {
    Expr* e = constant(op >= BinaryOp::Equal ? of(TypeKind::Bool) : a->type, 0);
    e->kind = tree::ExprKind::Binary;
    e->binary = op;
    e->operandType = a->type;
    e->a = a;
    e->b = c;
    return e;
}

Expr* Bench::unary(library::UnaryOp op, Expr* a) {
    Expr* e = constant(a->type, 0);
    e->kind = tree::ExprKind::Unary;
    e->unary = op;
    e->a = a;
    return e;
}

Expr* Bench::convert(Expr* a, TypeId to, Place* ok) {
    Expr* e = constant(to, 0);
    e->kind = tree::ExprKind::Convert;
    e->a = a;
    e->ok = ok;
    return e;
}

Expr* Bench::intrinsic(library::Intrinsic which, TypeId type, std::vector<Expr*> operands, int64_t selector,
                       Place* ok) {
    Expr* e = constant(type, 0);
    e->kind = tree::ExprKind::Intrinsic;
    e->intrinsic = which;
    e->operands = std::move(operands);
    e->selector = selector;
    e->ok = ok;
    return e;
}

Expr* Bench::addressOf(Place* place, TypeId type) {
    Expr* e = constant(type, 0);
    e->kind = tree::ExprKind::AddressOf;
    e->place = place;
    return e;
}

Expr* Bench::call(uint32_t callee, std::vector<tree::CallArgument> arguments, Place* instance) {
    Expr* e = constant(fn(callee).result, 0);
    e->kind = tree::ExprKind::Call;
    e->call = program.arena.make<tree::Call>();
    e->call->callee = tree::FunctionId(callee);
    e->call->arguments = std::move(arguments);
    e->call->instance = instance;
    return e;
}

Stmt* Bench::statement(tree::StmtKind kind, Expr* a) {
    auto* s = program.arena.make<Stmt>();
    s->kind = kind;
    s->a = a;
    s->range = {FileId(0u), m_text, m_text + 5};
    m_text += 10;
    return s;
}

Stmt* Bench::assign(Place* place, Expr* value) {
    Stmt* s = statement(tree::StmtKind::Assign, value);
    s->place = place;
    return s;
}

Stmt* Bench::forLoop(Place* variable, Expr* a, Expr* c, Expr* step, std::vector<Stmt*> body) {
    Stmt* s = statement(tree::StmtKind::For, a);
    s->place = variable;
    s->operandType = variable->type;
    s->b = c;
    s->c = step;
    s->body = std::move(body);
    return s;
}

void Bench::prepare() {
    if (m_isPrepared) return;
    m_isPrepared = true;
    image::Layout& layout = program.layout;
    layout.dataEnd = m_next;
    layout.frameBegin = (m_next + 63) / 64 * 64;
    layout.imageSize = layout.frameBegin + kFrame;
    m_initial.resize(layout.imageSize);
    image::Task task;
    for (uint32_t f = 1; f < program.functions.size(); ++f) {
        bool hasParameters = false;
        for (const tree::Local& local : fn(f).locals)
            hasParameters = hasParameters || local.kind != tree::LocalKind::Local;
        if (!hasParameters && !fn(f).isAbstract) task.programs.push_back({0, f, 0, 0});
    }
    program.tasks.push_back(task);
    debug = facts::makeDebugMap(program);
    flags.assign(debug.sites.size() + 1, 0);
}

std::shared_ptr<const image::Code> Bench::code(codegen::Tier tier) {
    prepare();
    auto& code = m_code[static_cast<int>(tier)];
    if (!code) {
        auto made = jit::compile(program, {tier});
        EXPECT_TRUE(made) << (made ? "" : made.error().english());
        if (made) code = made.value();
    }
    return code;
}

void Bench::makeFresh() {
    prepare();
    m_image.assign(m_initial.size() + 128, std::byte{0});
    std::memcpy(image(), m_initial.data(), m_initial.size());
}

image::FaultCode Bench::run(uint32_t entry, codegen::Tier tier, bool isFresh) {
    const auto compiled = code(tier);
    if (!compiled || !compiled->entries[entry]) {
        ADD_FAILURE() << "no code";
        return image::FaultCode::Stopped;
    }
    if (isFresh) makeFresh();
    std::memset(static_cast<void*>(&context), 0, sizeof(context));
    context.image = image();
    context.dataBegin = 64;
    context.dataEnd = program.layout.dataEnd;
    context.frameTop = program.layout.frameBegin;
    context.imageSize = program.layout.imageSize;
    context.loopBudget = budget;
    context.siteFlags = flags.data();
    g_running = this;
    stops.clear();
    refills = 0;
    if (setjmp(g_exit) == 0) compiled->entries[entry](&context, image(), 0);
    return context.fault;
}

image::FaultCode Bench::runBoth(uint32_t entry) {
    const image::FaultCode quick = run(entry, codegen::Tier::Quick);
    const std::vector<std::byte> seen(image(), image() + program.layout.dataEnd);
    const int64_t left = context.loopBudget;
    const image::RuntimeContext quickContext = context;
    const image::FaultCode optimised = run(entry, codegen::Tier::Optimised);
    EXPECT_EQ(quick, optimised);
    EXPECT_EQ(quickContext.faultSite, context.faultSite);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(quickContext.faultDetail[i], context.faultDetail[i]);
    if (quick == image::FaultCode::None) {
        EXPECT_EQ(left, context.loopBudget);
    }
    EXPECT_EQ(0, std::memcmp(seen.data() + 64, image() + 64, seen.size() - 64)) << "the tiers left different images";
    return optimised;
}

} // namespace plc::test
