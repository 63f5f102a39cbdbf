#include "hmi/designer/editors/people_editor.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "hmi/designer/editors/choice_cell.h"
#include "hmi/designer/editors/edit_bar.h"
#include "hmi/designer/editors/password_dialog.h"
#include "hmi/model/errors.h"
#include "hmi/people/log_in.h"
#include "hmi/people/password.h"

#include <QAction>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QSpinBox>
#include <QSplitter>
#include <QTableWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::hmi {

namespace {

QTableWidget* tableWith(const QStringList& heads, const QString& name) {
    auto* table = new QTableWidget;
    table->setColumnCount(static_cast<int>(heads.size()));
    table->setHorizontalHeaderLabels(heads);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->verticalHeader()->hide();
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setAccessibleName(name);
    return table;
}

/// With what can be done to its table, in words: five pictures in one bar told nobody which of the two they were for.
QWidget* boxed(const QString& title, QToolBar* bar, QWidget* content) {
    auto* box = new QGroupBox(title);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(2);
    layout->addWidget(bar);
    layout->addWidget(content);
    return box;
}

QToolBar* barInWords() {
    auto* bar = new QToolBar;
    bar->setIconSize(QSize(16, 16));
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    return bar;
}

bool isSame(const QString& a, const QString& b) { return a.compare(b, Qt::CaseInsensitive) == 0; }

/// What was added is seen, and its name can be typed at once.
void nameCurrent(QTableWidget& table) {
    table.scrollToItem(table.currentItem());
    table.setFocus();
    table.editItem(table.currentItem());
}

} // namespace

PeopleEditor::PeopleEditor(DesignContext& context, QWidget* parent)
    : QWidget(parent), m_context(context),
      m_users(tableWith({tr("User"), tr("Roles"), tr("Language"), tr("Start panel"), tr("Password")}, tr("Users"))),
      m_roles(tableWith({tr("Role"), tr("Title"), tr("Start panel")}, tr("Roles"))), m_timeout(new QSpinBox),
      m_problem(new QLabel) {
    QToolBar* bar = makeEditBar(m_undo, this);
    QToolBar *forUsers = barInWords(), *forRoles = barInWords();
    forUsers->addAction(kit::icon(kit::Icon::User), tr("Add a User"), this, [this] {
        addUser();
        nameCurrent(*m_users);
    });
    forUsers->addAction(kit::icon(kit::Icon::Lock), tr("Set Password…"), this, &PeopleEditor::askForPassword);
    forUsers->addAction(kit::icon(kit::Icon::Remove), tr("Remove User"), this, &PeopleEditor::removeSelectedUser);
    forRoles->addAction(kit::icon(kit::Icon::Layers), tr("Add a Role"), this, [this] {
        addRole();
        nameCurrent(*m_roles);
    });
    forRoles->addAction(kit::icon(kit::Icon::Remove), tr("Remove Role"), this, &PeopleEditor::removeSelectedRole);
    m_timeout->setRange(0, 86'400);
    m_timeout->setSuffix(tr(" s"));
    m_timeout->setSpecialValueText(tr("never"));
    m_timeout->setKeyboardTracking(false); // one undo step a number, not one a digit
    m_timeout->setAccessibleName(tr("Logged out after"));
    bar->addWidget(new QLabel(tr("Logged out after ")));
    bar->addWidget(m_timeout);
    m_problem->setWordWrap(true);
    m_problem->setMargin(4);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(boxed(tr("Users"), forUsers, m_users));
    splitter->addWidget(boxed(tr("Roles"), forRoles, m_roles));
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(splitter, 1);
    layout->addWidget(m_problem);
    setFocusProxy(m_users);

    offerChoices();
    connect(m_users, &QTableWidget::cellChanged, this,
            [this](int row, int column) { commitUser(row, column, m_users->item(row, column)->text()); });
    connect(m_roles, &QTableWidget::cellChanged, this,
            [this](int row, int column) { commitRole(row, column, m_roles->item(row, column)->text()); });
    connect(m_users, &QTableWidget::cellDoubleClicked, this, [this](int, int column) {
        if (column == Password) askForPassword();
    });
    connect(m_timeout, &QSpinBox::valueChanged, this,
            [this](int seconds) { edit(tr("Logged Out After"), [&](PeopleFile& file) { file.setTimeout(seconds); }); });
    connect(&m_context, &DesignContext::peopleTaken, &m_undo, &QUndoStack::clear); // its steps are of another file
    connect(&m_context, &DesignContext::peopleChanged, this, &PeopleEditor::rebuild);
    connect(&m_context, &DesignContext::textsChanged, this, &PeopleEditor::rebuild);
    rebuild();
}

/// What the project has is chosen rather than typed.
void PeopleEditor::offerChoices() {
    using Takes = ChoiceCell::Takes;
    const auto choose = [](QTableWidget& table, int column, Takes takes, std::function<QStringList()> choices) {
        table.setItemDelegateForColumn(column, new ChoiceCell(std::move(choices), takes, &table));
    };
    const auto panels = [this] {
        QStringList out{QString()};
        for (const NamedPanel& panel : m_context.project().panels)
            if (parametersOf(panel.panel).empty() && panel.name != m_context.project().frame) out += panel.name;
        return out;
    };
    choose(*m_users, Roles, Takes::Several, [this] {
        QStringList out;
        for (const Role& role : m_context.project().people.roles()) out += role.name;
        return out;
    });
    choose(*m_users, Language, Takes::One,
           [this] { return QStringList{QString()} + m_context.project().texts.settings().languages; });
    choose(*m_users, StartPanel, Takes::One, panels);
    choose(*m_roles, RoleStartPanel, Takes::One, panels);
}

QString PeopleEditor::problem() const { return m_problem->text(); }

void PeopleEditor::tell(const Message& problem) { m_problem->setText(kit::messageText(problem)); }

/// What was typed is not taken: the cell has its old text again, and the reason is said.
void PeopleEditor::refuse(const Message& why) {
    rebuild();
    tell(why);
}

bool PeopleEditor::isPanel(const QString& name) const { return name.isEmpty() || m_context.project().find(name); }

bool PeopleEditor::isLanguage(const QString& tag) const {
    return tag.isEmpty() || m_context.project().texts.settings().languages.contains(tag);
}

void PeopleEditor::edit(const QString& title, const std::function<void(PeopleFile&)>& change,
                        const DesignContext::NamesInPanels& names) {
    const PeopleFile before = m_context.project().people;
    PeopleFile after = before;
    change(after);
    if (after.write() == before.write()) return rebuild();
    m_undo.push(m_context.newEdit(
        title, [this, after] { m_context.setPeople(after); }, [this, before] { m_context.setPeople(before); }, names));
}

void PeopleEditor::addUser() {
    edit(tr("Add a User"), [](PeopleFile& file) {
        User user;
        user.name = QStringLiteral("user");
        for (int i = 2; file.find(user.name); ++i) user.name = QStringLiteral("user%1").arg(i);
        if (!file.roles().empty()) user.roles = QStringList{file.roles().front().name};
        file.setUser(user);
    });
    m_users->setCurrentCell(m_users->rowCount() - 1, Name);
}

void PeopleEditor::addRole() {
    edit(tr("Add a Role"), [](PeopleFile& file) {
        QString name = QStringLiteral("role");
        for (int i = 2; file.role(name); ++i) name = QStringLiteral("role%1").arg(i);
        file.setRole({name, {}, {}});
    });
    m_roles->setCurrentCell(m_roles->rowCount() - 1, RoleName);
}

void PeopleEditor::removeSelectedUser() {
    const int row = m_users->currentRow();
    if (row < 0) return;
    edit(tr("Remove User"), [&](PeopleFile& file) { file.users().erase(file.users().begin() + row); });
}

/// Who has the role loses it: a name that no role has would cost the whole file.
void PeopleEditor::removeSelectedRole() {
    const int row = m_roles->currentRow();
    if (row < 0) return;
    edit(tr("Remove Role"), [&](PeopleFile& file) {
        const QString name = file.roles()[static_cast<size_t>(row)].name;
        file.roles().erase(file.roles().begin() + row);
        for (User& user : file.users()) user.roles.removeIf([&](const QString& one) { return isSame(one, name); });
    });
}

bool PeopleEditor::setPassword(int row, const QString& password) {
    const std::vector<User>& users = m_context.project().people.users();
    if (row < 0 || row >= static_cast<int>(users.size())) return false;
    if (Message weakness = weaknessOf(password, users[static_cast<size_t>(row)].name); !weakness.isEmpty()) {
        tell(weakness);
        return false;
    }
    const Result<QString> hash = hashOf(password);
    if (!hash) {
        tell(hash.error().message);
        return false;
    }
    edit(tr("Set Password"), [&](PeopleFile& file) { file.users()[static_cast<size_t>(row)].password = *hash; });
    return true;
}

void PeopleEditor::askForPassword() {
    const int row = m_users->currentRow();
    if (row < 0) return;
    PasswordDialog dialog(m_users->item(row, Name)->text(), this);
    if (dialog.exec() == QDialog::Accepted) (void)setPassword(row, dialog.password());
}

void PeopleEditor::setRoles(int row, const QString& text) {
    const QStringList wanted = LogIn::rolesOf(text);
    for (const QString& one : wanted)
        if (!m_context.project().people.role(one)) return refuse(errors::NoSuchRole(toUtf8(one)));
    edit(tr("Roles"), [&](PeopleFile& file) { file.users()[static_cast<size_t>(row)].roles = wanted; });
}

void PeopleEditor::commitUser(int row, int column, const QString& typed) {
    const QString text = typed.trimmed();
    const PeopleFile& people = m_context.project().people;
    if (row < 0 || row >= static_cast<int>(people.users().size())) return;
    if (column == Roles) return setRoles(row, text);
    const User* other = people.find(text);
    if (column == Name && (text.isEmpty() || (other && other != &people.users()[static_cast<size_t>(row)])))
        return refuse(text.isEmpty() ? errors::UserWithoutName() : errors::UserTwice(toUtf8(text)));
    if (column == Language && !isLanguage(text)) return refuse(errors::NoLanguage(toUtf8(text)));
    if (column == StartPanel && !isPanel(text)) return refuse(errors::NoPanel(toUtf8(text)));
    edit(m_users->horizontalHeaderItem(column)->text(), [&](PeopleFile& file) {
        User& user = file.users()[static_cast<size_t>(row)];
        if (column == Name) user.name = text;
        if (column == Language) user.language = text;
        if (column == StartPanel) user.startPanel = text;
    });
}

void PeopleEditor::commitRole(int row, int column, const QString& typed) {
    const QString text = typed.trimmed();
    const PeopleFile& people = m_context.project().people;
    if (row < 0 || row >= static_cast<int>(people.roles().size())) return;
    const Role before = people.roles()[static_cast<size_t>(row)];
    if (column == RoleName && (text.isEmpty() || (people.role(text) && !isSame(text, before.name))))
        return refuse(text.isEmpty() ? errors::RoleWithoutName() : errors::RoleTwice(toUtf8(text)));
    if (column == RoleName) return renameRole(row, text);
    if (column == RoleStartPanel && !isPanel(text)) return refuse(errors::NoPanel(toUtf8(text)));
    std::optional<kit::MacroScope> macro;
    QString title;
    if (column == RoleTitle) { // the text goes into the table of texts: one step with its key
        macro.emplace(m_undo, m_roles->horizontalHeaderItem(column)->text());
        title = m_context.storeText(before.title, text, QStringLiteral("role"), m_undo);
    }
    edit(m_roles->horizontalHeaderItem(column)->text(), [&](PeopleFile& file) {
        Role& role = file.roles()[static_cast<size_t>(row)];
        if (column == RoleTitle) role.title = title;
        if (column == RoleStartPanel) role.startPanel = text;
    });
}

/// Users who have it and elements that are kept for it follow, in the same step: else nobody could press them.
void PeopleEditor::renameRole(int row, const QString& name) {
    const QString old = m_context.project().people.roles()[static_cast<size_t>(row)].name;
    const auto renamed = [&](QStringList roles) {
        for (QString& one : roles)
            if (isSame(one, old)) one = name;
        return roles;
    };
    const auto names = m_context.namesToRename("access", [&](const QString& access) {
        const QStringList roles = LogIn::rolesOf(access), now = renamed(roles);
        return now == roles ? access : now.join(QStringLiteral(", "));
    });
    edit(
        tr("Rename Role"),
        [&](PeopleFile& file) {
            file.roles()[static_cast<size_t>(row)].name = name;
            for (User& user : file.users()) user.roles = renamed(user.roles);
        },
        names);
}

void PeopleEditor::rebuild() {
    const PeopleFile& people = m_context.project().people;
    const QSignalBlocker quietUsers(m_users), quietRoles(m_roles), quietTimeout(m_timeout);
    const auto fill = [](QTableWidget& table, int row, const QStringList& cells) {
        for (int k = 0; k < cells.size(); ++k) { // the items stay: one of them may be what is being edited
            if (!table.item(row, k)) table.setItem(row, k, new QTableWidgetItem);
            table.item(row, k)->setText(cells[k]);
        }
    };
    m_users->setRowCount(static_cast<int>(people.users().size()));
    for (int row = 0; row < m_users->rowCount(); ++row) {
        const User& one = people.users()[static_cast<size_t>(row)];
        fill(*m_users, row,
             {one.name, one.roles.join(QStringLiteral(", ")), one.language, one.startPanel,
              one.password.isEmpty() ? tr("none: cannot log in") : tr("set")});
        m_users->item(row, Password)->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    }
    m_roles->setRowCount(static_cast<int>(people.roles().size()));
    for (int row = 0; row < m_roles->rowCount(); ++row) {
        const Role& one = people.roles()[static_cast<size_t>(row)];
        fill(*m_roles, row, {one.name, m_context.shownText(one.title), one.startPanel});
    }
    m_timeout->setValue(people.timeout());
    m_problem->setText(people.isEmpty()
                           ? tr("Without users, everybody may do everything. Add a role, then a user with a password.")
                           : tr("To restrict an element to some users, set its property \"Only for the roles\"."));
}

} // namespace plc::hmi
