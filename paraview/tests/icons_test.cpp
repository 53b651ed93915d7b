// Icons in a process with Qt, like ParaView's client.
#include <QFile>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPVPluginLoader.h>

namespace {

/// The icons that the filters name.
std::vector<std::string> named_icons() {
  std::ifstream file(BRINDLE_FILTERS);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex icon("icon=\"([^\"]*)\"");
  std::vector<std::string> names;
  for (std::sregex_iterator found(text.begin(), text.end(), icon), end; found != end; ++found) {
    names.push_back((*found)[1]);
  }
  return names;
}

bool exists(const std::string& resource) { return QFile::exists(QString::fromStdString(resource)); }

// Loading the plugin also loads the icons of its filters.
TEST(Icons, ComeWithThePlugin) {
  const std::vector<std::string> icons = named_icons();
  ASSERT_EQ(icons.size(), 3u);
  for (const std::string& icon : icons) EXPECT_FALSE(exists(icon)) << icon;
  vtkNew<vtkPVPluginLoader> loader;
  ASSERT_TRUE(loader->LoadPlugin(BRINDLE_PLUGIN)) << loader->GetErrorString();
  for (const std::string& icon : icons) EXPECT_TRUE(exists(icon)) << icon;
}

}  // namespace
