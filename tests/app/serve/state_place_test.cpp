// Where a served controller keeps its state when nobody says where.
#include "app/serve/state_place.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace plc::serve {
namespace {

namespace fs = std::filesystem;

struct Places {
    QTemporaryDir folder;
    fs::path root = fs::canonical(folder.path().toStdString());
    fs::path project = root / "plant", installed = root / "usr/share/stepwise/examples/plant";
    Surroundings around{root / "usr/share/stepwise", {}, root / "home/.local/state"};
    Places() {
        fs::create_directories(project);
        fs::create_directories(installed);
    }
};

TEST(StatePlace, IsBesideAProjectOfTheUser) {
    const Places places;
    EXPECT_EQ(stateFolderOf(places.project, places.around), places.project / ".stepwise/serve");
}

TEST(StatePlace, OfAnInstalledExampleIsTheUsersAndTheSameAtEachStart) {
    const Places places;
    const fs::path state = stateFolderOf(places.installed, places.around);
    EXPECT_EQ(state.parent_path(), places.root / "home/.local/state/stepwise");
    EXPECT_TRUE(state.filename().string().starts_with("plant-")) << state;
    EXPECT_EQ(stateFolderOf(places.installed / ".", places.around), state);
    const fs::path link = places.root / "short";
    fs::create_directory_symlink(places.installed, link);
    EXPECT_EQ(stateFolderOf(link, places.around), state) << "through a link, too";
    fs::create_directories(places.root / "usr/share/stepwise/other/plant");
    EXPECT_NE(stateFolderOf(places.root / "usr/share/stepwise/other/plant", places.around), state);
}

TEST(StatePlace, OfAFolderWithALikeNameIsBesideIt) {
    const Places places;
    const fs::path like = places.root / "usr/share/stepwise-projects/plant";
    fs::create_directories(like);
    EXPECT_EQ(stateFolderOf(like, places.around), like / ".stepwise/serve");
}

TEST(StatePlace, IsTheServiceManagersWhereItGivesOne) {
    Places places;
    places.around.service = "/var/lib/stepwise/plant";
    EXPECT_EQ(stateFolderOf(places.project, places.around), "/var/lib/stepwise/plant");
}

TEST(StatePlace, WithoutAHomeStaysBesideTheProject) {
    Places places;
    places.around.user.clear();
    EXPECT_EQ(stateFolderOf(places.installed, places.around), places.installed / ".stepwise/serve");
}

} // namespace
} // namespace plc::serve
