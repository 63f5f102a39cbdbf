// Builds checked trees by hand for tests of code generation, compiles them in both tiers and runs them on a small
// image. Owned by each test.
#pragma once
#include "runtime/compiler/facts/debug_map.h"
#include "runtime/compiler/jit/jit.h"

#include <gtest/gtest.h>

#include <csetjmp>
#include <cstring>

namespace plc::test {

using library::BinaryOp;
using tree::Expr;
using tree::Place;
using tree::Stmt;
using types::TypeId;
using types::TypeKind;
using types::TypeTable;

inline TypeId of(TypeKind kind) { return TypeTable::of(kind); }

/// Globals from offset 64 on, one function after the other, run through the JIT.
class Bench {
public:
    Bench();
    // Declaring.
    uint32_t global(TypeId type, const std::string& name = "g");
    uint32_t function(const std::string& name, TypeId result = of(TypeKind::Void), TypeId instance = {});
    tree::Function& fn(uint32_t f) { return program.functions[f]; }
    uint32_t local(uint32_t f, TypeId type, tree::LocalKind kind, const std::string& name = "l");

    // Places.
    Place* at(uint32_t offset, TypeId type);
    Place* local(uint32_t index, TypeId type);
    Place* instance(uint32_t offset, TypeId type);
    Place* slot(uint32_t offset, TypeId type);
    Place* field(Place* base, uint32_t offset, TypeId type);
    Place* element(Place* array, std::vector<Expr*> indices);
    Place* bitOf(Place* base, int bit);
    Place* character(Place* text, Expr* index);
    Place* deref(Expr* pointer, TypeId type);

    // Expressions.
    Expr* constant(TypeId type, int64_t value);
    Expr* real(TypeId type, double value);
    Expr* textConstant(const std::string& text);
    Expr* load(Place* place);
    Expr* binary(BinaryOp op, Expr* a, Expr* b);
    Expr* unary(library::UnaryOp op, Expr* a);
    Expr* convert(Expr* a, TypeId to, Place* ok = nullptr);
    Expr* intrinsic(library::Intrinsic which, TypeId type, std::vector<Expr*> operands, int64_t selector = -1,
                    Place* ok = nullptr);
    Expr* addressOf(Place* place, TypeId type);
    Expr* call(uint32_t callee, std::vector<tree::CallArgument> arguments = {}, Place* instance = nullptr);

    // Statements; each gets its own range, so its own site.
    Stmt* assign(Place* place, Expr* value);
    Stmt* statement(tree::StmtKind kind, Expr* a = nullptr);
    Stmt* forLoop(Place* variable, Expr* a, Expr* b, Expr* c, std::vector<Stmt*> body);
    void add(uint32_t f, Stmt* stmt) { fn(f).body.push_back(stmt); }

    /// Runs `entry` on a fresh image, or on the one there is.
    image::FaultCode run(uint32_t entry, codegen::Tier tier, bool isFresh = true);
    /// In both tiers, which must agree about fault and image; leaves the optimised tier's image.
    image::FaultCode runBoth(uint32_t entry);
    template <class T> T get(uint32_t offset) const {
        T value;
        std::memcpy(&value, image() + offset, sizeof(T));
        return value;
    }
    template <class T> void set(uint32_t offset, T value) { std::memcpy(m_initial.data() + offset, &value, sizeof(T)); }
    std::string text(uint32_t offset) const { return reinterpret_cast<const char*>(image() + offset); }
    void makeFresh();
    std::byte* image() const {
        return const_cast<std::byte*>(m_image.data()) + 64 - reinterpret_cast<uintptr_t>(m_image.data()) % 64;
    }

    tree::Program program;
    TypeTable& types;
    image::RuntimeContext context;
    std::vector<std::pair<uint32_t, uint32_t>> stops; // sites stopped at, frames
    std::vector<uint8_t> flags;
    int64_t budget = 1'000'000;
    int refills = 0;
    int64_t refill = 0; // given by budgetUsedUp; 0 = watchdog
    std::shared_ptr<const image::Code> code(codegen::Tier tier);
    facts::DebugMap debug;

private:
    void prepare();
    std::vector<std::byte> m_image, m_initial;
    std::shared_ptr<const image::Code> m_code[2];
    uint32_t m_next = 64;
    uint32_t m_text = 0;
    bool m_isPrepared = false;
};

} // namespace plc::test
