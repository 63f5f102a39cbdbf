#include "editor/trace/setup/trace_setup.h"

#include "editor/kit/errors.h"
#include "projects/storage/project_file.h"
#include "runtime/base/read_json.h"

#include <cmath>
#include <set>

namespace plc::trace {

namespace {

constexpr int Version = 1;

/// One enumeration, one table of its words.
template <class E> struct Word {
    E value;
    const char* text;
};
constexpr Word<ChannelStyle> Styles[] = {{ChannelStyle::Automatic, "automatic"},
                                         {ChannelStyle::Line, "line"},
                                         {ChannelStyle::Hold, "hold"},
                                         {ChannelStyle::Digital, "digital"}};
constexpr Word<ScaleMode> Modes[] = {
    {ScaleMode::Automatic, "automatic"}, {ScaleMode::Fit, "fit"}, {ScaleMode::Fixed, "fixed"}};
constexpr Word<TriggerEdge> Edges[] = {{TriggerEdge::Rising, "rising"},
                                       {TriggerEdge::Falling, "falling"},
                                       {TriggerEdge::Both, "both"},
                                       {TriggerEdge::Level, "level"}};
constexpr Word<TriggerMode> TriggerModes[] = {
    {TriggerMode::Off, "off"}, {TriggerMode::Single, "single"}, {TriggerMode::Repeated, "repeated"}};

constexpr Word<FigureKind> FigureKinds[] = {{FigureKind::None, "none"},
                                            {FigureKind::Xy, "xy"},
                                            {FigureKind::Spectrum, "spectrum"},
                                            {FigureKind::Response, "response"},
                                            {FigureKind::Runs, "runs"}};
constexpr Word<FigureWindow> FigureWindows[] = {
    {FigureWindow::Hann, "hann"}, {FigureWindow::FlatTop, "flat top"}, {FigureWindow::Rectangular, "rectangular"}};

/// What is wrong with a field of the object at `where`; empty: the whole.
Message in(const std::string& where, Message problem) {
    return where.empty() ? problem : errors::FieldOf(where, std::move(problem));
}

/// Reads fields of one object; the first that does not fit is the error.
class Reader {
public:
    Reader(const Json& json, std::string where, Message& problem)
        : m_json(json), m_where(std::move(where)), m_problem(problem) {}

    void text(const char* key, std::string& out) const {
        take(key, phrases::AText(), [&](const Json& v) { return v.is_string() && (out = v.get<std::string>(), true); });
    }
    void flag(const char* key, bool& out) const {
        take(key, phrases::OneOf({{"true"}}, Verbatim("false")),
             [&](const Json& v) { return v.is_boolean() && (out = v.get<bool>(), true); });
    }
    void number(const char* key, double& out, double least = -1e300, double most = 1e300) const {
        take(key, phrases::ANumber(), [&](const Json& v) {
            return v.is_number() && v.get<double>() >= least && v.get<double>() <= most &&
                   (out = v.get<double>(), true);
        });
    }
    template <class T> void whole(const char* key, T& out, int64_t least, int64_t most) const {
        take(key, phrases::AnInteger(), [&](const Json& v) {
            return v.is_number_integer() && v.get<int64_t>() >= least && v.get<int64_t>() <= most &&
                   (out = static_cast<T>(v.get<int64_t>()), true);
        });
    }
    /// Seconds in the file, nanoseconds here.
    void time(const char* key, int64_t& out, double least = 0) const {
        take(key, phrases::ANumberOfSeconds(), [&](const Json& v) {
            if (!v.is_number() || v.get<double>() < least || v.get<double>() > 9e9) return false;
            out = std::llround(v.get<double>() * 1e9);
            return true;
        });
    }
    template <class E, size_t N> void word(const char* key, E& out, const Word<E> (&words)[N]) const {
        std::vector<std::string> choices;
        for (const Word<E>& w : words) choices.emplace_back(w.text);
        take(key, phrases::AnyOf(std::move(choices)), [&](const Json& v) {
            if (!v.is_string()) return false;
            for (const Word<E>& w : words)
                if (v.get<std::string>() == w.text) return out = w.value, true;
            return false;
        });
    }
    template <class Use> void take(const char* key, messages::Phrase wanted, Use&& use) const {
        const auto it = m_json.find(key);
        if (it == m_json.end() || use(*it) || !m_problem.isEmpty()) return;
        m_problem = in(m_where, errors::FieldMustBe(Verbatim(key), std::move(wanted)));
    }

private:
    const Json& m_json;
    std::string m_where;
    Message& m_problem;
};

Json seconds(int64_t time) {
    if (time % 1'000'000'000 == 0) return time / 1'000'000'000;
    return static_cast<double>(time) / 1e9;
}

Json shortest(double value) {
    if (value == std::floor(value) && std::abs(value) < 9e15) return static_cast<int64_t>(value);
    return value;
}

template <class E, size_t N> const char* wordOf(E value, const Word<E> (&words)[N]) {
    for (const Word<E>& w : words)
        if (w.value == value) return w.text;
    return words[0].text;
}

/// Builds an object in canonical order and puts the fields we do not know back behind those they followed.
class Writer {
public:
    explicit Writer(const Json& origin) : m_origin(origin.is_object() ? origin : Json::object()) {}

    /// Left out when it has its default and was not written in the file either.
    void put(const char* key, Json value, const Json& standard) {
        m_known.insert(key);
        if (value == standard && !m_origin.contains(key)) return;
        m_fields.emplace_back(key, std::move(value));
    }
    void put(const char* key, Json value) {
        m_known.insert(key);
        m_fields.emplace_back(key, std::move(value));
    }
    void skip(const char* key) { m_known.insert(key); }

    Json finish() const {
        Json out = Json::object();
        std::string after; // the known field that unknown ones follow
        std::vector<std::pair<std::string, std::vector<std::pair<std::string, Json>>>> unknown = {{"", {}}};
        for (const auto& [key, value] : m_origin.items()) {
            if (m_known.count(key))
                unknown.push_back({key, {}});
            else
                unknown.back().second.emplace_back(key, value);
        }
        auto emitUnknown = [&](const std::string& behind) {
            for (auto& [anchor, fields] : unknown)
                if (anchor == behind) {
                    for (auto& [key, value] : fields) out[key] = value;
                    fields.clear();
                }
        };
        emitUnknown("");
        for (const auto& [key, value] : m_fields) {
            out[key] = value;
            emitUnknown(key);
        }
        for (auto& [anchor, fields] : unknown) // their field has left
            for (auto& [key, value] : fields) out[key] = value;
        return out;
    }

private:
    Json m_origin;
    std::set<std::string> m_known;
    std::vector<std::pair<std::string, Json>> m_fields;
};

Json channelJson(const ChannelSetup& c) {
    const ChannelSetup standard;
    Writer w(c.origin);
    w.put("expression", c.expression);
    w.put("label", c.label, standard.label);
    w.put("chart", c.chart, standard.chart);
    w.put("axis", c.axis, standard.axis);
    w.put("color", c.color, standard.color);
    w.put("width", shortest(c.width), shortest(standard.width));
    w.put("style", wordOf(c.style, Styles), "automatic");
    w.put("scale", shortest(c.scale), 1);
    w.put("offset", shortest(c.offset), 0);
    w.put("unit", c.unit, standard.unit);
    w.put("recording", c.recording, standard.recording);
    w.put("visible", c.isVisible, true);
    return w.finish();
}

ChannelSetup channelSetupOf(const Json& json, const std::string& where, Message& problem) {
    ChannelSetup c;
    c.origin = json;
    const Reader r(json, where, problem);
    r.text("expression", c.expression);
    r.text("label", c.label);
    r.whole("chart", c.chart, 0, 63);
    r.whole("axis", c.axis, 0, 15);
    r.text("color", c.color);
    r.number("width", c.width, 0.1, 20);
    r.word("style", c.style, Styles);
    r.number("scale", c.scale);
    r.number("offset", c.offset);
    r.text("unit", c.unit);
    r.text("recording", c.recording);
    r.flag("visible", c.isVisible);
    if (c.expression.empty() && problem.isEmpty()) problem = in(where, errors::FieldMissing(Verbatim("expression")));
    return c;
}

Json axisJson(const AxisSetup& a) {
    Writer w(a.origin);
    w.put("title", a.title, "");
    w.put("unit", a.unit, "");
    w.put("mode", wordOf(a.mode, Modes), "automatic");
    w.put("min", shortest(a.minimum), 0);
    w.put("max", shortest(a.maximum), 100);
    w.put("right", a.isOnRight, false);
    return w.finish();
}

AxisSetup axisOf(const Json& json, const std::string& where, Message& problem) {
    AxisSetup a;
    a.origin = json;
    const Reader r(json, where, problem);
    r.text("title", a.title);
    r.text("unit", a.unit);
    r.word("mode", a.mode, Modes);
    r.number("min", a.minimum);
    r.number("max", a.maximum);
    r.flag("right", a.isOnRight);
    return a;
}

Json chartJson(const ChartSetup& c) {
    Writer w(c.origin);
    w.put("title", c.title, "");
    w.put("weight", shortest(c.weight), 1);
    Json axes = Json::array();
    for (const AxisSetup& axis : c.axes) axes.push_back(axisJson(axis));
    w.put("axes", std::move(axes), Json::array({Json::object()}));
    return w.finish();
}

template <class T, class Read>
std::vector<T> listOf(const Json& json, const char* key, const std::string& where, Message& problem, Read&& read) {
    std::vector<T> out;
    const auto it = json.find(key);
    if (it == json.end()) return out;
    if (!it->is_array()) {
        if (problem.isEmpty()) problem = in(where, errors::FieldMustBe(Verbatim(key), phrases::AList()));
        return out;
    }
    size_t index = 0;
    for (const Json& item : *it) {
        const std::string place = (where.empty() ? "" : where + ".") + key + "[" + std::to_string(index++) + "]";
        if (item.is_object())
            out.push_back(read(item, place, problem));
        else if (problem.isEmpty())
            problem = errors::FieldMustBe(place, phrases::AnObject());
    }
    return out;
}

ChartSetup chartOf(const Json& json, const std::string& where, Message& problem) {
    ChartSetup c;
    c.origin = json;
    const Reader r(json, where, problem);
    r.text("title", c.title);
    r.number("weight", c.weight, 0.05, 100);
    c.axes = listOf<AxisSetup>(json, "axes", where, problem, axisOf);
    if (c.axes.empty()) c.axes.push_back({});
    return c;
}

Json triggerJson(const TriggerSetup& t) {
    const TriggerSetup standard;
    Writer w(t.origin);
    w.put("expression", t.expression, "");
    w.put("edge", wordOf(t.edge, Edges), "rising");
    w.put("mode", wordOf(t.mode, TriggerModes), "off");
    w.put("before", seconds(t.before), seconds(standard.before));
    w.put("after", seconds(t.after), seconds(standard.after));
    return w.finish();
}

TriggerSetup triggerOf(const Json& json, const std::string& where, Message& problem) {
    TriggerSetup t;
    t.origin = json;
    const Reader r(json, where, problem);
    r.text("expression", t.expression);
    r.word("edge", t.edge, Edges);
    r.word("mode", t.mode, TriggerModes);
    r.time("before", t.before);
    r.time("after", t.after);
    return t;
}

Json figureJson(const FigureSetup& f) {
    Writer w(f.origin);
    w.put("kind", wordOf(f.kind, FigureKinds), "none");
    w.put("x", f.x, "");
    w.put("window", wordOf(f.window, FigureWindows), "hann");
    w.put("logarithmic", f.isLogarithmic, true);
    return w.finish();
}

FigureSetup figureOf(const Json& json, const std::string& where, Message& problem) {
    FigureSetup f;
    f.origin = json;
    const Reader r(json, where, problem);
    r.word("kind", f.kind, FigureKinds);
    r.text("x", f.x);
    r.word("window", f.window, FigureWindows);
    r.flag("logarithmic", f.isLogarithmic);
    return f;
}

Json noteJson(const NoteSetup& n) {
    Writer w(n.origin);
    w.put("time", seconds(n.time));
    if (n.value)
        w.put("value", shortest(*n.value));
    else
        w.skip("value");
    w.put("chart", n.chart, 0);
    w.put("text", n.text);
    return w.finish();
}

NoteSetup noteOf(const Json& json, const std::string& where, Message& problem) {
    NoteSetup n;
    n.origin = json;
    const Reader r(json, where, problem);
    r.time("time", n.time, -9e9);
    if (json.contains("value")) {
        double value = 0;
        r.number("value", value);
        n.value = value;
    }
    r.whole("chart", n.chart, 0, 63);
    r.text("text", n.text);
    return n;
}

/// Channels must name charts and axes that exist.
void mendReferences(TraceSetup& setup) {
    for (ChannelSetup& channel : setup.channels) {
        if (channel.chart >= static_cast<int>(setup.charts.size()))
            setup.charts.resize(static_cast<size_t>(channel.chart) + 1);
        ChartSetup& chart = setup.charts[static_cast<size_t>(channel.chart)];
        if (channel.axis >= static_cast<int>(chart.axes.size()))
            chart.axes.resize(static_cast<size_t>(channel.axis) + 1);
    }
}

} // namespace

Result<TraceSetup> readSetup(std::string_view text, const std::string& place) {
    const JsonText<Json> read = readJson<Json>(text);
    if (!read.isGood()) return Error{errors::TraceNotJson(read.line), place};
    const Json& json = read.value;
    if (!json.is_object()) return Error{errors::TraceNotObject(), place};
    TraceSetup setup;
    setup.origin = json;
    Message problem;
    const Reader r(json, "", problem);
    int version = Version;
    r.whole("version", version, 1, 1'000'000);
    if (version > Version) return Error{errors::TraceTooNew(version), place};
    r.text("title", setup.title);
    r.time("span", setup.span, 1e-9);
    r.whole("every", setup.every, 1, 1'000'000'000);
    r.text("condition", setup.condition);
    r.text("compareWith", setup.compareWith);
    if (json.contains("compareShift")) r.time("compareShift", setup.compareShift, -9e9);
    r.flag("table", setup.hasTable);
    auto cursor = [&](const char* key, std::optional<int64_t>& out) {
        int64_t time = 0;
        if (!json.contains(key)) return;
        r.time(key, time, -9e9);
        out = time;
    };
    cursor("cursorA", setup.cursorA);
    cursor("cursorB", setup.cursorB);
    if (const auto it = json.find("trigger"); it != json.end() && it->is_object())
        setup.trigger = triggerOf(*it, "trigger", problem);
    setup.charts = listOf<ChartSetup>(json, "charts", "", problem, chartOf);
    if (setup.charts.empty()) setup.charts.push_back({});
    setup.channels = listOf<ChannelSetup>(json, "channels", "", problem, channelSetupOf);
    if (const auto it = json.find("figure"); it != json.end() && it->is_object())
        setup.figure = figureOf(*it, "figure", problem);
    setup.notes = listOf<NoteSetup>(json, "notes", "", problem, noteOf);
    if (!problem.isEmpty()) return Error{errors::TraceInvalid(problem), place};
    mendReferences(setup);
    return setup;
}

std::string writeSetup(const TraceSetup& setup) {
    const TraceSetup standard;
    Writer w(setup.origin);
    w.put("version", Version);
    w.put("title", setup.title, "");
    w.put("span", seconds(setup.span), seconds(standard.span));
    w.put("every", setup.every, 1u);
    w.put("condition", setup.condition, "");
    w.put("compareWith", setup.compareWith, "");
    w.put("compareShift", seconds(setup.compareShift), 0.0);
    w.put("table", setup.hasTable, false);
    if (setup.cursorA)
        w.put("cursorA", seconds(*setup.cursorA));
    else
        w.skip("cursorA");
    if (setup.cursorB)
        w.put("cursorB", seconds(*setup.cursorB));
    else
        w.skip("cursorB");
    w.put("trigger", triggerJson(setup.trigger), Json::object());
    Json charts = Json::array(), channels = Json::array();
    for (const ChartSetup& chart : setup.charts) charts.push_back(chartJson(chart));
    for (const ChannelSetup& channel : setup.channels) channels.push_back(channelJson(channel));
    w.put("charts", std::move(charts), Json::array({Json::object()}));
    w.put("channels", std::move(channels));
    w.put("figure", figureJson(setup.figure), Json::object());
    Json notes = Json::array();
    for (const NoteSetup& note : setup.notes) notes.push_back(noteJson(note));
    w.put("notes", std::move(notes), Json::array());
    return w.finish().dump(2) + "\n";
}

void forEachExpression(TraceSetup& setup, const std::function<void(std::string& expression)>& visit) {
    const auto look = [&](std::string& expression) {
        if (!expression.empty()) visit(expression);
    };
    for (ChannelSetup& channel : setup.channels)
        if (channel.recording.empty()) look(channel.expression);
    look(setup.condition);
    look(setup.trigger.expression);
    look(setup.figure.x);
}

Result<TraceSetup> loadSetup(const std::string& path) {
    const auto text = projects::readFile(path);
    if (!text) return text.error();
    return readSetup(*text, path);
}

Result<void> saveSetup(const TraceSetup& setup, const std::string& path) {
    return projects::writeFileAtomically(path, writeSetup(setup));
}

TraceSetup setupOf(const std::vector<std::string>& expressions) {
    TraceSetup setup;
    for (const std::string& expression : expressions) {
        ChannelSetup channel;
        channel.expression = expression;
        setup.channels.push_back(std::move(channel));
    }
    return setup;
}

} // namespace plc::trace
