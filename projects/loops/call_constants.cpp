#include "projects/loops/call_constants.h"

#include "projects/loops/errors.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/syntax.h"
#include "runtime/compiler/sema/sema.h"

#include <algorithm>

namespace plc::loops {

namespace {

using lex::Token;
using lex::TokenKind;

/// The unit of this name, in namespaces too.
const syntax::Pou* pouNamed(const std::vector<syntax::Decl*>& declarations, std::string_view name) {
    for (const syntax::Decl* declaration : declarations) {
        if (declaration->pou && equalsIgnoringCase(declaration->pou->name.text, name)) return declaration->pou;
        if (!declaration->space) continue;
        if (const syntax::Pou* inner = pouNamed(declaration->space->declarations, name)) return inner;
    }
    return nullptr;
}

/// Calls of an instance as a row of tokens: the same in structured text, in lists and in the bodies of steps.
class Calls {
public:
    Calls(const syntax::SyntaxFile& file, const SourceText& source, SourceRange range)
        : m_source(source), m_file(file.file), m_tokens(file.tokens.tokens) {
        const auto before = [](const Token& token, uint32_t at) { return token.begin < at; };
        m_begin = static_cast<size_t>(std::lower_bound(m_tokens.begin(), m_tokens.end(), range.begin, before) -
                                      m_tokens.begin());
        m_end = static_cast<size_t>(std::lower_bound(m_tokens.begin(), m_tokens.end(), range.end, before) -
                                    m_tokens.begin());
    }
    [[nodiscard]] std::vector<CallConstant> of(std::string_view instance, const tuning::BlockForm& form) const {
        std::vector<CallConstant> out;
        for (size_t i = m_begin; i + 1 < m_end; ++i)
            if (is(i, instance) && m_tokens[i + 1].kind == TokenKind::LeftParen &&
                (i == m_begin || m_tokens[i - 1].kind != TokenKind::Dot))
                lookInto(i + 2, form, out);
        return out;
    }

private:
    [[nodiscard]] std::string_view textOf(size_t first, size_t last) const {
        return m_source.text().substr(m_tokens[first].begin, m_tokens[last].end - m_tokens[first].begin);
    }
    [[nodiscard]] bool is(size_t i, std::string_view name) const {
        return m_tokens[i].kind == TokenKind::Identifier && equalsIgnoringCase(textOf(i, i), name);
    }
    [[nodiscard]] bool endsArgument(size_t i) const {
        return m_tokens[i].kind == TokenKind::Comma || m_tokens[i].kind == TokenKind::RightParen;
    }
    void lookInto(size_t i, const tuning::BlockForm& form, std::vector<CallConstant>& out) const {
        for (int depth = 1; i + 2 < m_end && depth > 0; ++i) {
            const TokenKind kind = m_tokens[i].kind;
            if (kind == TokenKind::LeftParen) ++depth;
            if (kind == TokenKind::RightParen) --depth;
            if (depth != 1 || m_tokens[i + 1].kind != TokenKind::Assign) continue;
            for (const tuning::ParameterForm& parameter : form.parameters)
                if (is(i, parameter.member)) take(i + 2, parameter.member, out);
        }
    }
    /// 2.0, -2.0, T#2s, REAL#2.0 of which the number alone.
    void take(size_t first, std::string_view member, std::vector<CallConstant>& out) const {
        if (m_tokens[first].kind == TokenKind::TypedPrefix) ++first;
        size_t last = first;
        if (m_tokens[last].kind == TokenKind::Minus || m_tokens[last].kind == TokenKind::Plus) ++last;
        if (last + 1 >= m_tokens.size() || !lex::isLiteral(m_tokens[last].kind) || !endsArgument(last + 1)) return;
        const SourceRange range{m_file, m_tokens[first].begin, m_tokens[last].end};
        out.push_back({std::string(member), m_source.path(), range, std::string(textOf(first, last)),
                       m_source.lineColumn(range.begin).line});
    }
    const SourceText& m_source;
    FileId m_file;
    const std::vector<Token>& m_tokens;
    size_t m_begin = 0, m_end = 0;
};

} // namespace

std::vector<CallConstant> callConstants(const Loop& loop, const ProgramPointer& program) {
    const driver::Checked checked = driver::checkedOf(program);
    const size_t dot = loop.instance.rfind('.');
    if (!checked.analysis || !checked.sources || dot == std::string::npos) return {};
    const auto owner = program->layout.find(loop.instance.substr(0, dot));
    if (!owner) return {};
    const std::string name = (*program->layout.types)[owner->type].name;
    const std::string_view instance = std::string_view(loop.instance).substr(dot + 1);
    for (const auto& file : checked.analysis->files) {
        if (!file->library.empty()) continue;
        if (const syntax::Pou* pou = pouNamed(file->declarations, name))
            return Calls(*file, (*checked.sources)[file->file], pou->range).of(instance, *loop.form);
    }
    return {};
}

std::vector<ConstantEdit> editsFor(const Loop& loop, const ProgramPointer& program,
                                   const std::vector<tuning::ParameterValue>& parameters) {
    std::vector<ConstantEdit> out;
    for (CallConstant& place : callConstants(loop, program))
        for (const tuning::ParameterValue& parameter : parameters)
            if (parameter.member == place.member && parameter.text != place.text)
                out.push_back({std::move(place), parameter.text});
    return out;
}

Result<ProgramPointer> withConstants(const driver::BuildInput& input, const ProgramPointer& program,
                                     const std::vector<ConstantEdit>& edits) {
    driver::BuildInput changed = input;
    std::vector<ConstantEdit> backwards = edits;
    std::sort(backwards.begin(), backwards.end(),
              [](const ConstantEdit& a, const ConstantEdit& b) { return a.place.range.begin > b.place.range.begin; });
    for (const ConstantEdit& edit : backwards)
        for (driver::SourceFile& file : changed.files)
            if (file.path == edit.place.file && edit.place.range.end <= file.text.size())
                file.text.replace(edit.place.range.begin, edit.place.range.length(), edit.text);
    driver::Built built = driver::build(changed);
    if (!built.program || built.program->layout.imageSize != program->layout.imageSize)
        return Error{errors::TrialAcrossVersions(), ""};
    return ProgramPointer(std::move(built.program));
}

} // namespace plc::loops
