#include "hmi/designer/panel_designer.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/own_keys.h"
#include "editor/kit/theme.h"
#include "hmi/check/faceplate_check.h"
#include "hmi/check/standard_check.h"
#include "hmi/designer/array_arrangement_dialog.h"
#include "hmi/designer/array_dialog.h"
#include "hmi/designer/canvas/outline.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/context/keyed_text.h"
#include "hmi/designer/context/panel_variables.h"
#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"
#include "hmi/player/panel_player.h"
#include "runtime/base/read_json.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolTip>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::hmi {

namespace {
Panel panelNamed(DesignContext& context, const QString& name) {
    const NamedPanel* panel = context.project().find(name);
    return panel ? panel->panel : Panel();
}

/// "button1.text"; of the panel itself only the property.
QString placeOf(const Finding& finding) {
    const bool isBoth = !finding.element.isEmpty() && !finding.property.isEmpty();
    return finding.element + (isBoth ? QStringLiteral(".") : QString()) + finding.property;
}

/// There is a fix that needs no decision: an edit of the panel, or a key for a text.
bool canFix(const Finding& finding) { return !finding.fix.isEmpty() || finding.kind == FindingKind::HardCodedText; }
} // namespace

PanelDesigner::PanelDesigner(DesignContext& context, const QString& panelName, QWidget* parent)
    : QWidget(parent), m_context(context), m_name(panelName), m_document(panelNamed(context, panelName)),
      m_palette(new Palette), m_canvas(new DesignCanvas(m_document, m_selection, context)),
      m_sheet(new PropertySheet(m_document, m_selection, context)),
      m_outline(new Outline(m_document, m_selection, context)), m_findingList(new QTreeWidget),
      m_pages(new QStackedWidget), m_where(new QLabel) {
    m_sheet->setPanelName(panelName);
    m_canvas->setPanelName(panelName);
    m_palette->setFaceplates(context.project().panels);
    m_context.openDocument(panelName, &m_document);
    makeActions();
    new kit::OwnKeys(this);
    setFocusProxy(m_canvas);
    m_pages->addWidget(m_canvas);
    m_findingList->setHeaderLabels({tr("Issue"), tr("Element"), tr("Language")});
    m_findingList->setRootIsDecorated(false);
    m_findingList->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_findingList->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_findingList->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_findingList->header()->setStretchLastSection(false);
    auto* middle = new QSplitter(Qt::Vertical);
    middle->addWidget(m_pages);
    middle->addWidget(m_findingList);
    middle->setStretchFactor(0, 6); // the list gives way as well where there is little room
    middle->setStretchFactor(1, 1);
    middle->setSizes({600, 110});
    auto* left = new QSplitter(Qt::Vertical);
    left->addWidget(makeSources());
    left->addWidget(m_outline);
    m_outline->setAccessibleName(tr("Outline"));
    m_canvas->setAccessibleName(tr("Panel"));
    left->setStretchFactor(0, 3);
    left->setStretchFactor(1, 2);
    auto* splitter = new QSplitter;
    splitter->addWidget(left);
    splitter->addWidget(middle);
    splitter->addWidget(m_sheet);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({210, 760, 300});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeToolBar());
    layout->addWidget(splitter, 1);

    connect(m_palette, &Palette::elementChosen, this,
            [this](const Json& fields) { m_canvas->insertElements(Json::array({fields}), m_canvas->visibleCenter()); });
    connect(m_canvas, &DesignCanvas::refused, this, &PanelDesigner::sayRefusal);
    connect(m_canvas, &DesignCanvas::contextMenuRequested, this, &PanelDesigner::showMenu);
    connect(m_canvas, &DesignCanvas::pointerMoved, this, [this](QPointF at) {
        m_where->setText(QStringLiteral("%1, %2").arg(std::lround(at.x())).arg(std::lround(at.y())));
    });
    connect(m_canvas, &DesignCanvas::editRequested, this, [this](const ElementId& id) {
        // A double click edits what the element is about: its text, else its binding.
        const Element* element = m_document.panel().find(id);
        if (element && element->kind() == ElementKind::Faceplate &&
            m_context.project().find(element->text("panel"_text)))
            emit panelRequested(element->text("panel"_text));
        for (const char* key : {"text", "target", "value", "title", "state"})
            if (element && element->descriptor().property(key))
                return m_sheet->grid().editProperty(QString::fromLatin1(key));
    });
    connect(m_findingList, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const ElementId id = item->data(0, Qt::UserRole).toString();
        if (m_document.panel().find(id)) m_selection.set({id});
        if (const QString tag = item->text(2); !tag.isEmpty()) m_context.setLanguage(tag);
    });
    m_findingList->setAccessibleName(tr("Issues"));
    m_findingList->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_findingList, &QWidget::customContextMenuRequested, this, &PanelDesigner::showFindingMenu);
    connect(&m_document, &PanelDocument::changed, this, [this](const Touched& touched) {
        if (NamedPanel* panel = m_context.project().find(m_name)) panel->panel = m_document.panel();
        m_context.reportPanelEdited(m_name);
        if (m_player) m_player->follow(m_document.panel(), touched);
        m_checkTimer.start();
    });
    connect(&m_document.undoStack(), &QUndoStack::cleanChanged, this,
            [this](bool clean) { emit modifiedChanged(!clean); });
    connect(&m_context, &DesignContext::textsChanged, this, [this] {
        if (m_player) m_player->projectChanged();
        m_checkTimer.start();
    });
    connect(&m_context, &DesignContext::panelEdited, this, [this](const QString& name) {
        if (name == m_name) return;
        m_palette->setFaceplates(m_context.project().panels);
        m_sheet->refresh();
        if (m_player) m_player->follow(m_document.panel(), Touched{{}, true, false});
        m_checkTimer.start();
    });
    connect(&m_context, &DesignContext::languageChanged, this, [this] {
        if (m_player) m_player->setLanguage(m_context.language());
    });
    connect(&m_context, &DesignContext::programChanged, this, [this] {
        if (m_player && m_player->run() != m_context.run()) {
            m_player->setRun(m_context.run());
            showInPreview();
        }
        m_checkTimer.start();
    });
    connect(&m_context, &DesignContext::recordingChanged, this, &PanelDesigner::showInPreview);
    connect(&m_context, &DesignContext::positionChanged, this, [this] {
        if (m_player) m_player->setPosition(m_context.position());
    });
    connect(&m_selection, &Selection::changed, this, &PanelDesigner::updateActions);
    m_checkTimer.setSingleShot(true);
    m_checkTimer.setInterval(400);
    connect(&m_checkTimer, &QTimer::timeout, this, &PanelDesigner::checkNow);
    m_checkTimer.start();
    updateActions();
}

PanelDesigner::~PanelDesigner() {
    delete m_sheet; // a choice that is open in it would still ask for the document
    m_context.closeDocument(&m_document);
    m_document.disconnect(this);
    m_document.undoStack().disconnect(this);
}

/// What is dragged onto the panel: elements, and where the program is known, its variables.
QWidget* PanelDesigner::makeSources() {
    if (!m_context.variables()) return m_palette;
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    tabs->setAccessibleName(tr("Elements"));
    tabs->addTab(m_palette, tr("Elements"));
    m_bindable = std::make_unique<PanelVariables>(m_context, m_document);
    m_variables = new kit::VariablePicker(*m_bindable);
    m_parametersListed = m_document.panel().at("parameters"_field);
    m_variables->layout()->setContentsMargins(4, 4, 4, 4);
    tabs->addTab(m_variables, tr("Variables"));
    connect(m_variables, &kit::VariablePicker::picked, this, [this](const QString& path) {
        m_canvas->insertVariables({path}, m_canvas->visibleCenter(),
                                  QApplication::keyboardModifiers() & Qt::ShiftModifier);
    });
    const auto reload = [this] {
        if (!m_variables->isVisible()) return;
        m_parametersListed = m_document.panel().at("parameters"_field);
        m_variables->reload();
    };
    connect(tabs, &QTabWidget::currentChanged, this, reload);
    connect(&m_context, &DesignContext::programChanged, this, reload);
    connect(&m_document, &PanelDocument::changed, this, [this, reload] {
        if (m_document.panel().at("parameters"_field) != m_parametersListed) reload();
    });
    return tabs;
}

// ---- clipboard

void PanelDesigner::copy() {
    if (m_selection.isEmpty()) return;
    const std::string text = copied(m_document.panel(), m_selection.ids()).dump();
    auto* mime = new QMimeData;
    mime->setData(kElementMime, QByteArray::fromStdString(text));
    mime->setText(QString::fromStdString(text));
    QApplication::clipboard()->setMimeData(mime);
}

void PanelDesigner::cut() {
    copy();
    m_document.perform(tr("Cut"), removeElements(m_document.panel(), m_selection.ids()));
}

void PanelDesigner::paste(bool inPlace) {
    const QMimeData* mime = QApplication::clipboard()->mimeData();
    if (!mime || !mime->hasFormat(kElementMime)) return;
    const Json elements = readJson<Json>(mime->data(kElementMime).toStdString()).value;
    ElementIds added;
    const std::optional<QPointF> at = inPlace ? std::optional(boundsOf(elements).topLeft()) : std::nullopt;
    m_document.perform(tr("Paste"), pasted(m_document.panel(), elements, at, &added));
    m_selection.set(added);
}

void PanelDesigner::duplicate() {
    ElementIds added;
    m_document.perform(tr("Duplicate"),
                       pasted(m_document.panel(), copied(m_document.panel(), m_selection.ids()), std::nullopt, &added));
    m_selection.set(added);
}

void PanelDesigner::duplicateAsArray() {
    QString example;
    for (const ElementId& id : m_selection.ids())
        forEachBinding(*m_document.panel().find(id), [&](const Found& found) {
            if (example.isEmpty() && found.text.contains(u'[')) example = found.text;
        });
    ArrayDialog dialog(m_arrayLayout, example, this);
    if (dialog.exec() != QDialog::Accepted) return;
    m_arrayLayout = dialog.layoutChosen();
    ElementIds added;
    m_document.perform(tr("Duplicate as array"),
                       duplicatedAsArray(m_document.panel(), m_selection.ids(), m_arrayLayout, &added));
    ElementIds all = m_selection.ids();
    all.insert(all.end(), added.begin(), added.end());
    m_selection.set(all);
}

const Element* PanelDesigner::selectedFaceplate() const {
    if (m_selection.ids().size() != 1) return nullptr;
    const Element* element = m_document.panel().find(m_selection.ids().front());
    return element && element->kind() == ElementKind::Faceplate ? element : nullptr;
}

void PanelDesigner::arrangeOverArray() {
    const Element* faceplate = selectedFaceplate();
    if (!faceplate) return;
    const ElementId id = faceplate->id();
    ArrayArrangementDialog dialog(m_document.panel(), *faceplate, m_context, this);
    if (dialog.exec() != QDialog::Accepted) return;
    ElementIds all{id};
    m_document.perform(tr("Arrange over array"), arrangedOverArray(m_document.panel(), id, dialog.arrangement(), &all));
    m_selection.set(all);
}

/// What the canvas cannot do is said at the pointer.
void PanelDesigner::sayRefusal(const QString& reason) {
    QToolTip::showText(QCursor::pos(), reason, m_canvas);
    emit refused(reason);
}

void PanelDesigner::group() {
    ElementId id;
    m_document.perform(tr("Group"), makeGroup(m_document.panel(), m_selection.ids(), &id));
    m_selection.set({id});
}

void PanelDesigner::layOut(const char* layout) {
    if (m_selection.ids().empty()) return;
    ElementId id;
    m_document.perform(tr("Lay out"), hmi::layOut(m_document.panel(), m_selection.ids(), layout, &id));
    m_selection.set({id});
}

void PanelDesigner::ungroup() {
    ElementIds inside;
    for (const ElementId& id : m_selection.ids())
        for (const ElementId& child : m_document.panel().childrenOf(id)) inside.push_back(child);
    m_document.perform(tr("Ungroup"), dissolveGroups(m_document.panel(), m_selection.ids()));
    m_selection.set(inside);
}

void PanelDesigner::selectAll() {
    ElementIds ids;
    for (const Element& element : m_document.panel().elements())
        if (element.parent().isEmpty() && !element.isSet("locked"_flag)) ids.push_back(element.id());
    m_selection.set(ids);
}

// ---- preview, check, save

void PanelDesigner::setLive(bool live) {
    m_actions[QStringLiteral("live")]->setChecked(live);
    if (live == isLive()) return;
    if (!live) {
        m_pages->setCurrentWidget(m_canvas);
        m_player.reset();
        return;
    }
    m_player = std::make_unique<PanelPlayer>(m_context.project(), m_context.run());
    // A faceplate by itself shows the first thing that it stands for.
    if (const auto given = argumentsGiven(m_context.checkInput(), m_name); !given.empty())
        m_player->setArguments(given.front());
    m_player->showPanel(m_name, m_document.panel());
    m_player->setLanguage(m_context.language());
    showInPreview();
    connect(m_player.get(), &PanelPlayer::languageChanged, &m_context, &DesignContext::setLanguage);
    m_pages->addWidget(m_player.get());
    m_pages->setCurrentWidget(m_player.get());
}

/// The preview shows what the rest of the studio shows.
void PanelDesigner::showInPreview() {
    if (!m_player) return;
    m_player->setRecording(m_context.recording());
    m_player->setPosition(m_context.position());
}

void PanelDesigner::checkNow() {
    m_checkTimer.stop();
    m_findings = checkPanel(m_context.checkInput(), NamedPanel{m_name, m_document.panel()});
    m_canvas->setFindings(m_findings);
    action(QStringLiteral("fix-all"))->setEnabled(std::any_of(m_findings.begin(), m_findings.end(), canFix));
    showFindings();
    emit findingsChanged();
}

void PanelDesigner::showFindings() {
    m_findingList->clear();
    for (const Finding& finding : m_findings) {
        auto* item = new QTreeWidgetItem(m_findingList,
                                         {finding.code() + QStringLiteral("  ") + kit::messageText(finding.message),
                                          placeOf(finding), finding.language});
        item->setIcon(0, kit::icon(finding.isError ? kit::Icon::Error : kit::Icon::Warning));
        item->setData(0, Qt::UserRole, finding.element);
        const QString why = kit::messageText(finding.why);
        item->setToolTip(0, kit::messageText(finding.message) + (why.isEmpty() ? why : QStringLiteral("\n\n") + why));
    }
    // A column that no issue needs leaves its room to the sentences.
    const auto isEmpty = [&](auto text) {
        return std::ranges::all_of(m_findings, [&](const Finding& finding) { return text(finding).isEmpty(); });
    };
    m_findingList->setColumnHidden(1, isEmpty(placeOf));
    m_findingList->setColumnHidden(2, isEmpty([](const Finding& finding) { return finding.language; }));
    m_findingList->resizeColumnToContents(1);
}

void PanelDesigner::fixFinding(size_t index) {
    if (index < m_findings.size() && canFix(m_findings[index])) {
        const Finding finding = m_findings[index];
        kit::MacroScope macro(m_document.undoStack(), tr("Fix Issue"));
        m_document.perform(tr("Fix Issue"), finding.fix);
        moveToTexts({finding});
    }
    checkNow();
}

void PanelDesigner::fixAll() {
    const QString file = QStringLiteral("hmi/%1.panel.json").arg(m_name);
    if (std::any_of(m_findings.begin(), m_findings.end(), canFix)) {
        const std::vector<Finding> findings = m_findings;
        kit::MacroScope macro(m_document.undoStack(), tr("Fix All Issues"));
        m_document.perform(tr("Fix All Issues"), fixesOf(findings, file, m_document.panel()));
        moveToTexts(findings);
    }
    checkNow();
}

void PanelDesigner::moveToTexts(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) // one after the other: two may be about parts of the same property
        m_document.perform(tr("Fix Issue"),
                           keyedText(finding, m_document.panel(), m_name, m_context, m_document.undoStack()));
}

void PanelDesigner::showFindingMenu(QPoint at) {
    const int row = m_findingList->indexOfTopLevelItem(m_findingList->itemAt(at));
    const bool isFinding = row >= 0 && row < static_cast<int>(m_findings.size());
    QMenu menu;
    QAction* fix = menu.addAction(tr("Fix Issue"), this, [this, row] { fixFinding(static_cast<size_t>(row)); });
    fix->setEnabled(isFinding && canFix(m_findings[static_cast<size_t>(row)]));
    menu.addAction(action(QStringLiteral("fix-all")));
    if (isFinding && !m_findings[static_cast<size_t>(row)].why.isEmpty()) {
        const Message why = m_findings[static_cast<size_t>(row)].why;
        menu.addAction(tr("Explain Issue"), this, [this, why, at] {
            QToolTip::showText(m_findingList->viewport()->mapToGlobal(at), kit::messageText(why), m_findingList);
        });
    }
    menu.exec(m_findingList->viewport()->mapToGlobal(at));
}

Result<void> PanelDesigner::save() {
    if (auto saved = savePanel(m_context.project(), NamedPanel{m_name, m_document.panel()}); !saved) return saved;
    if (auto saved = m_context.save(); !saved) return saved;
    m_document.setClean();
    return {};
}

void PanelDesigner::reload(const Panel& panel) {
    m_document.reset(panel);
    m_selection.prune(panel);
}

} // namespace plc::hmi
