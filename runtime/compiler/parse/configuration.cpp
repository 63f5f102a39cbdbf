#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

/// CONFIGURATION … END_CONFIGURATION (IEC 61131-3, 2.7)
ConfigurationDecl* Parser::parseConfiguration() {
    ConfigurationDecl* configuration = make<ConfigurationDecl>();
    const size_t first = mark();
    const Token opening = peek();
    advance();
    configuration->name = takeName();
    const OpenBlock open(*this, TokenKind::EndConfiguration);
    ResourceDecl* direct = make<ResourceDecl>();
    parseResourceParts(*direct, configuration, TokenKind::EndConfiguration);
    if (!direct->tasks.empty() || !direct->programs.empty())
        configuration->resources.insert(configuration->resources.begin(), direct);
    expectEnd(TokenKind::EndConfiguration, opening);
    take(TokenKind::Semicolon);
    configuration->range = rangeFrom(first);
    direct->range = configuration->range;
    return configuration;
}

/// Sections, tasks and programs; a configuration also has resources.
void Parser::parseResourceParts(ResourceDecl& resource, ConfigurationDecl* configuration, TokenKind end) {
    while (!atEnd() && !at(end)) {
        if (take(TokenKind::Semicolon)) continue;
        if (atVarSection()) {
            (configuration ? configuration->sections : resource.sections).push_back(parseVarSection());
        } else if (at(SoftWord::Task)) {
            resource.tasks.push_back(parseTask());
        } else if (at(TokenKind::Program)) {
            resource.programs.push_back(parseProgramInstance());
        } else if (at(SoftWord::Resource) && configuration) {
            ResourceDecl* inner = make<ResourceDecl>();
            const size_t first = mark();
            const Token opening = peek();
            advance();
            inner->name = takeName();
            if (take(SoftWord::On)) inner->on = takeName(phrases::AProcessorsName());
            const OpenBlock open(*this, TokenKind::EndResource);
            parseResourceParts(*inner, nullptr, TokenKind::EndResource);
            expectEnd(TokenKind::EndResource, opening);
            inner->range = rangeFrom(first);
            configuration->resources.push_back(inner);
        } else if (atStatementEnd() || atAny({TokenKind::Function, TokenKind::FunctionBlock, TokenKind::TypeWord}) ||
                   atDeclaration()) {
            return;
        } else {
            expected(configuration ? phrases::OneOf({{"RESOURCE", "TASK"}}, Verbatim("PROGRAM"))
                                   : phrases::OneOf({{"TASK"}}, Verbatim("PROGRAM")));
            do advance();
            while (!atEnd() && !at(TokenKind::Semicolon) && !atStatementEnd() && !atVarSection() &&
                   !at(TokenKind::Program) && !(at(SoftWord::Task) && kind(1) == TokenKind::Identifier) &&
                   !at(SoftWord::Resource));
            m_lastErrorAt = SIZE_MAX;
        }
    }
}

/// TASK name (INTERVAL := T#10ms, PRIORITY := 1);
TaskDecl* Parser::parseTask() {
    TaskDecl* task = make<TaskDecl>();
    task->pragmas = pragmasHere();
    const size_t first = mark();
    advance();
    task->name = takeName(phrases::ATasksName());
    if (take(TokenKind::LeftParen)) {
        std::vector<Argument> arguments;
        parseArguments(arguments, TokenKind::RightParen);
        for (Argument& argument : arguments) {
            if (equalsIgnoringCase(argument.name.text, "INTERVAL"))
                task->interval = argument.value;
            else if (equalsIgnoringCase(argument.name.text, "SINGLE"))
                task->single = argument.value;
            else if (equalsIgnoringCase(argument.name.text, "PRIORITY"))
                task->priority = argument.value;
            else
                task->others.push_back(std::move(argument));
        }
    } else if (task->name.isValid()) {
        expected(Verbatim("("));
    }
    if (!take(TokenKind::Semicolon)) {
        if (m_lastErrorAt != m_at)
            missingSemicolon(false);
        else
            skipTo({TokenKind::Semicolon, TokenKind::EndResource, TokenKind::EndConfiguration, TokenKind::Program});
    }
    task->range = rangeFrom(first);
    return task;
}

/// PROGRAM RETAIN name WITH task : Type (in := x, out => y, block WITH task);
ProgramInstance* Parser::parseProgramInstance() {
    ProgramInstance* instance = make<ProgramInstance>();
    instance->pragmas = pragmasHere();
    const size_t first = mark();
    advance();
    if (at(TokenKind::Identifier) && kind(1) == TokenKind::Identifier && peek(1).soft != SoftWord::With) {
        if (take(SoftWord::Retain))
            instance->retain = true;
        else if (take(SoftWord::NonRetain))
            instance->nonRetain = true;
    }
    instance->name = takeName(phrases::AProgramInstancesName());
    if (take(SoftWord::With)) instance->task = takeName(phrases::ATasksName());
    if (expect(TokenKind::Colon)) instance->type = takePath();
    if (take(TokenKind::LeftParen)) {
        // block WITH task is told apart first; the rest are connections
        while (!at(TokenKind::RightParen) && !atEnd() && !at(TokenKind::Semicolon)) {
            if (atName() && peek(1).soft == SoftWord::With) {
                Argument argument;
                const size_t at = mark();
                argument.name = takeName();
                advance();
                const Name task = takeName(phrases::ATasksName());
                argument.value = makeName(task);
                argument.range = rangeFrom(at);
                instance->blockTasks.push_back(std::move(argument));
            } else {
                Argument argument;
                const size_t at = mark();
                argument.name = takeName(phrases::AnInputOrOutput());
                Path rest;
                while (take(TokenKind::Dot)) argument.name = takeName();
                if (!argument.name.isValid()) break;
                if (take(TokenKind::Output))
                    argument.kind = ArgumentKind::Output;
                else if (take(TokenKind::Assign))
                    argument.kind = ArgumentKind::Input;
                else
                    expected(phrases::OneOf({{":="}}, Verbatim("=>")));
                if (!atAny({TokenKind::Comma, TokenKind::RightParen})) argument.value = parseExpression();
                argument.range = rangeFrom(at);
                instance->connections.push_back(std::move(argument));
            }
            if (!take(TokenKind::Comma)) break;
        }
        if (!take(TokenKind::RightParen)) {
            expected(Verbatim(")"));
            skipTo({TokenKind::Semicolon, TokenKind::EndResource, TokenKind::EndConfiguration});
        }
    }
    if (!take(TokenKind::Semicolon)) {
        if (m_lastErrorAt != m_at)
            missingSemicolon(false);
        else {
            skipTo({TokenKind::Semicolon, TokenKind::EndResource, TokenKind::EndConfiguration, TokenKind::Program});
            m_lastErrorAt = SIZE_MAX;
        }
    }
    instance->range = rangeFrom(first);
    return instance;
}

} // namespace plc::parse
