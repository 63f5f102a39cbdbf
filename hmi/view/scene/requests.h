// What a view asks for when it is operated. The player answers; a view alone changes nothing. Values.
#pragma once
#include "hmi/model/faceplate.h"
#include "hmi/model/value.h"

namespace plc::hmi {

enum class WriteKind {
    Write,
    Press, // a momentary button goes down; `released` is written when it has come up
    Release,
};

struct WriteRequest {
    ElementId element;
    QString target; // ST variable
    WriteKind kind = WriteKind::Write;
    Value value, released;
};

enum class EntryKind { Number, Text, Masked };

/// A value is to be typed: the player opens a keypad and writes the result to the target.
struct EntryRequest {
    ElementId element;
    QString target, title, unit, format, mask;
    EntryKind kind = EntryKind::Number;
    Value present;
    std::optional<double> minimum, maximum; // as shown, in the unit shown
    double factor = 1, offset = 0;          // shown = raw * factor + offset
    int maxLength = 0;
    bool isHidden = false;
    ValueKind valueKind = ValueKind::None;
    QRectF place; // of the element in the panel
};

/// One of several values is to be chosen from a list.
struct ChoiceRequest {
    ElementId element;
    QString target;
    QStringList texts;
    std::vector<Value> values;
    int present = -1;
    bool isLanguage = false; // values are language tags
    QRectF place;
};

enum class NavigationKind { Open, PopUp, Close, Back, Home };

/// Another panel is to be shown, in the place of the present one or over it.
struct NavigationRequest {
    NavigationKind kind = NavigationKind::Open;
    QString panel;
    Arguments arguments;
};

/// Somebody wants to log in or out; or was refused, and which roles would be let in.
struct AccessRequest {
    ElementId element;
    QString roles; // empty: asked for by hand
    bool isLogOut = false;
};

enum class RecipeRequestKind { Choose, Edit, Write, Read, Add, Remove };

/// A recipe is operated: another set chosen, a value of it typed, the set written to or read from the controller.
struct RecipeRequest {
    ElementId element;
    RecipeRequestKind kind = RecipeRequestKind::Choose;
    QString recipe, set, variable;
};

struct AcknowledgeRequest {
    bool all = true;
    size_t alarm = 0;
    QStringList classes;
};

/// More about one alarm: its help, its place, setting it aside.
struct AlarmDetailRequest {
    ElementId element;
    size_t alarm = 0;
};

/// A question that must be answered with yes before the request is passed on.
struct ConfirmRequest {
    QString question;
    WriteRequest write;
    bool isCritical = false; // confirmed by the password of who is logged in
};

} // namespace plc::hmi
