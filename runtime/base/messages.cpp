#include "runtime/base/messages.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace plc::errors {

namespace {

using messages::Argument;
using messages::Form;
using messages::ParameterKind;

constexpr const Form* kForms[] = {
#define PLC_MESSAGE(Row, Text, ...) &Row,
#include "runtime/base/messages.def"
};

const Form* formNamed(std::string_view name) {
    const auto it = std::find_if(std::begin(kForms), std::end(kForms), [&](const Form* f) { return f->name == name; });
    return it == std::end(kForms) ? nullptr : *it;
}

constexpr char kMark = '\x02'; // no text of a recording of older versions begins with it

void appendField(std::string& out, std::string_view field) { ((out += std::to_string(field.size())) += ':') += field; }

bool takeField(std::string_view& text, std::string_view& field) {
    size_t size = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), size);
    const auto digits = static_cast<size_t>(end - text.data());
    if (problem != std::errc() || digits >= text.size() || text[digits] != ':' || size > text.size() - digits - 1)
        return false;
    field = text.substr(digits + 1, size);
    text.remove_prefix(digits + 1 + size);
    return true;
}

std::string fieldOf(const Argument& argument) {
    struct Packer {
        std::string operator()(int64_t number) const { return std::to_string(number); }
        std::string operator()(uint64_t number) const { return std::to_string(number); }
        std::string operator()(double number) const {
            char digits[32];
            return std::string(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
        }
        std::string operator()(const std::string& text) const { return text; }
        std::string operator()(const std::vector<std::string>& names) const {
            std::string out;
            for (const std::string& name : names) appendField(out, name);
            return out;
        }
        std::string operator()(const Form* words) const { return packed(Message(*words, {})); }
        std::string operator()(const std::shared_ptr<const Message>& inner) const { return packed(*inner); }
    };
    return std::visit(Packer{}, argument);
}

template <class T> Argument numberOf(std::string_view text) {
    T number{};
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

Argument argumentOf(ParameterKind kind, std::string_view field) {
    switch (kind) {
    case ParameterKind::Integer:
        return field.starts_with('-') ? numberOf<int64_t>(field) : numberOf<uint64_t>(field);
    case ParameterKind::Real:
        return numberOf<double>(field);
    case ParameterKind::Names: {
        std::vector<std::string> names;
        for (std::string_view name; takeField(field, name);) names.emplace_back(name);
        return names;
    }
    case ParameterKind::Nested:
    case ParameterKind::Phrase:
        return std::make_shared<const Message>(unpacked(field));
    case ParameterKind::Thing:
        if (field.starts_with(kMark)) return std::make_shared<const Message>(unpacked(field));
        [[fallthrough]];
    case ParameterKind::Name:
    case ParameterKind::Path:
        return std::string(field);
    }
    return std::string(field);
}

} // namespace

Message withPlace(const Error& error) {
    return error.place.empty() ? error.message : About(error.place, error.message);
}

std::string packed(const Message& message) {
    if (message.isEmpty()) return {};
    if (formNamed(message.form()->name) != message.form()) return message.english();
    std::string out(1, kMark);
    appendField(out, message.form()->name);
    for (const Argument& argument : message.arguments()) appendField(out, fieldOf(argument));
    return out;
}

Message unpacked(std::string_view text) {
    if (text.empty()) return {};
    std::string_view rest = text.substr(1), field;
    const Form* form = text[0] == kMark && takeField(rest, field) ? formNamed(field) : nullptr;
    if (!form) return Plainly(text);
    std::vector<Argument> arguments;
    for (size_t i = 0; i < form->count; ++i) {
        if (!takeField(rest, field)) return Plainly(text);
        arguments.push_back(argumentOf(form->parameters[i], field));
    }
    return Message(*form, std::move(arguments));
}

Message ofSystem(int code) {
    switch (code) {
    case ENOENT:
        return NoSuchFile();
    case EACCES:
    case EPERM:
        return PermissionDenied();
    case ENOSPC:
#ifdef EDQUOT // not every system has quotas
    case EDQUOT:
#endif
        return NoSpaceLeft();
    case EISDIR:
        return IsAFolder();
    case ENOTDIR:
        return NotAFolder();
    case EROFS:
        return ReadOnlyFileSystem();
    case EIO:
        return InputOutputError();
    case ENAMETOOLONG:
        return FileNameTooLong();
    case EEXIST:
        return FileExists();
    case ENOTEMPTY:
        return FolderNotEmpty();
    case EMFILE:
    case ENFILE:
        return TooManyOpenFiles();
    case EFBIG:
        return FileTooLarge();
    default:
        return SystemSays(std::string(std::strerror(code)));
    }
}

} // namespace plc::errors
