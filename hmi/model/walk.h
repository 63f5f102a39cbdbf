// Goes over every binding and every text of an element, however deep it stands in records, so that checks, renames and
// used-by lists are written once. Pure functions, any thread.
#pragma once
#include "hmi/model/edit.h"

#include <functional>

namespace plc::hmi {

/// One value found in an element: the property it stands in, the row and field of a record, and its text.
struct Found {
    PropertyType type = PropertyType::String;
    std::string property; // key of the element's property
    int row = -1;         // row of a record
    std::string field;    // field of the row, or name of a value in texts
    QString text;
    std::string_view hint; // the type that a binding must have: "bool", "number", "text", "array", "any"

    /// "states[2].text", as the problem list shows it.
    QString place() const;
};

/// Expressions, targets, the values of texts and arguments (type Arguments; of text parameters too, but for keys).
/// Those that are empty are left out.
void forEachBinding(const Properties& properties, const std::function<void(const Found&)>& visit);
/// Texts that people see, as they stand ("@key" or the text itself).
void forEachText(const Properties& properties, const std::function<void(const Found&)>& visit);
/// Prefixes of text lists.
void forEachTextList(const Properties& properties, const std::function<void(const Found&)>& visit);

/// The edit that puts another text at each place where `replace` returns one.
Edit rewrite(const Panel& panel, const std::function<std::optional<QString>(const ElementId&, const Found&)>& replace);

} // namespace plc::hmi
