// The report in a real browser: loaded from the disk, without a network. Skipped, and said so, where there is none.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fixture.hpp"
#include "jamscape/base/files.hpp"
#include "jamscape/report/report.hpp"

namespace jam {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string output_of(const std::string& command) {
  std::string out;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return out;
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) out.append(buffer.data(), n);
  pclose(pipe);
  return out;
}

std::string browser() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::string path = output_of(std::string("command -v ") + name);
    if (!path.empty()) return path.substr(0, path.find('\n'));
  }
  return {};
}

class ReportPage : public testing::Test {
 protected:
  void SetUp() override {
    browser_ = browser();
    if (browser_.empty()) GTEST_SKIP() << "no Chromium on this machine: the report's page is not looked at";
    folder_ = fs::temp_directory_path() / ("jamscape-page-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  /// Opens DIR/report.html with the probe appended, and returns what the probe found; lines of the console go to
  /// `console_`. Frames come with the browser's virtual clock (frames.js): how busy the machine is changes nothing.
  Json open_page(const std::string& graphics = "--disable-3d-apis") {
    std::string page = read_text(folder_ / "report.html");
    page.insert(page.rfind("</body>"), "<script>" + read_text(PAGE_SCRIPTS "/probe.js") + "</script>\n");
    page.insert(page.find("<head>") + 6, "\n<script>" + read_text(PAGE_SCRIPTS "/frames.js") + "</script>");
    write_text(folder_ / "probed.html", page);
    const fs::path log = folder_ / "console.txt";
    const std::string document = output_of(
        "'" + browser_ + "' --headless=new --no-sandbox --disable-gpu --hide-scrollbars --window-size=1400,1000 " +
        graphics +
        " --disable-background-networking --host-resolver-rules='MAP * ~NOTFOUND' --proxy-server=127.0.0.1:9" +
        " --user-data-dir='" + (folder_ / "profile").string() +
        "' --enable-logging=stderr --virtual-time-budget=20000" + " --dump-dom 'file://" +
        (folder_ / "probed.html").string() + "' 2>'" + log.string() + "'");
    console_.clear();
    const std::string all = read_text(log);
    for (std::size_t at = 0; (at = all.find(":CONSOLE", at)) != std::string::npos; ++at) {
      const std::string line = all.substr(at, all.find('\n', at) - at);
      if (line.find("GL Driver Message") == std::string::npos) console_ += line + "\n";  // of a slow software driver
    }
    const std::string mark = "id=\"probe\">";
    const std::size_t from = document.rfind(mark);
    if (from == std::string::npos) return Json::object({{"ready", false}});
    const std::size_t start = from + mark.size();
    return Json::parse(document.substr(start, document.find("</script>", start) - start));
  }

  /// The page without its data and program, as it stands where a server's policy forbids scripts.
  std::string open_forbidden() {
    std::string page = read_text(folder_ / "report.html");
    page.insert(page.find("<head>") + 6,
                "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'self'\">");
    write_text(folder_ / "forbidden.html", page);
    const std::string document =
        output_of("'" + browser_ + "' --headless=new --no-sandbox --disable-gpu --user-data-dir='" +
                  (folder_ / "profile").string() + "' --dump-dom 'file://" + (folder_ / "forbidden.html").string() +
                  "' 2>/dev/null");
    const std::size_t from = document.find("<main");
    return from == std::string::npos ? "" : document.substr(from, document.find("</main>") - from);
  }

  std::string browser_, console_;
  fs::path folder_;
};

std::vector<std::string> sections(const Json& found) { return found.at("sections").get<std::vector<std::string>>(); }

TEST_F(ReportPage, ShowsEverySectionOfACompleteStudy) {
  write_fixture(folder_);
  write_report(folder_);
  const Json found = open_page();
  ASSERT_TRUE(found.at("ready")) << console_;
  EXPECT_EQ(console_, "");
  EXPECT_EQ(found.at("problems").size(), 0u) << found.at("problems");
  EXPECT_EQ(found.at("title"), "Synthetic results");
  EXPECT_EQ(sections(found),
            (std::vector<std::string>{"systems", "transitions", "networks", "diagrams", "generators", "coordination",
                                      "topology", "forces", "order", "mechanics", "explorer"}));
  // 8 N_i^*, Z and rattlers, 2 totals, 2 Betti, 3 and 2 P(F), 3 psi_6, g, 4 of mechanics, the explorer
  EXPECT_EQ(found.at("charts"), 28);
  // and on top of these the emblem, 3 networks with their key, 6 diagrams
  EXPECT_EQ(found.at("canvases"), 28 + 1 + 4 + 6);
  EXPECT_EQ(found.at("blank"), 0);
  EXPECT_FALSE(found.at("wider"));
}

TEST_F(ReportPage, ShowsNetworksInTwoAndThreeDimensions) {
  write_network_fixture(folder_);
  write_report(folder_);
  for (const char* graphics : {"--enable-unsafe-swiftshader", "--disable-3d-apis"}) {
    const Json found = open_page(graphics);
    ASSERT_TRUE(found.at("ready")) << console_;
    EXPECT_EQ(console_, "") << graphics;
    EXPECT_EQ(found.at("problems").size(), 0u) << found.at("problems");
    EXPECT_EQ(found.at("sections"),
              (std::vector<std::string>{"systems", "transitions", "networks", "generators", "coordination", "surfaces",
                                        "topology", "forces", "order", "mechanics", "explorer"}));
    EXPECT_EQ(found.at("heat_maps"), 3 * 5 + 1);  // b2 of the spheres only
    EXPECT_EQ(found.at("spheres"), 1);
    EXPECT_EQ(found.at("blank"), 0) << graphics;
    EXPECT_FALSE(found.at("wider"));
  }
}

TEST_F(ReportPage, ShowsPackingsOfClusters) {
  write_cluster_fixture(folder_);
  write_report(folder_);
  for (const char* graphics : {"--enable-unsafe-swiftshader", "--disable-3d-apis"}) {
    const Json found = open_page(graphics);
    ASSERT_TRUE(found.at("ready")) << console_;
    EXPECT_EQ(console_, "") << graphics;
    EXPECT_EQ(found.at("problems").size(), 0u) << found.at("problems");
    EXPECT_EQ(sections(found), (std::vector<std::string>{"systems", "shapes", "networks", "contact-forces", "radial",
                                                         "particle-stress", "final"}));
    // P(f), G(r) and P(i) of crosses and of stars; k, solid fraction and Z over sphericity
    EXPECT_EQ(found.at("charts"), 3 * 2 + 3);
    EXPECT_EQ(found.at("spheres"), 3);
    // and on top of these the emblem, 6 packings with a key, 6 shapes
    EXPECT_EQ(found.at("canvases"), 9 + 1 + 7 + 6);
    EXPECT_EQ(found.at("blank"), 0) << graphics;
    EXPECT_FALSE(found.at("wider"));
  }
}

TEST_F(ReportPage, SaysWhyWhereScriptsAreForbidden) {
  write_fixture(folder_);
  write_report(folder_);
  const std::string page = open_forbidden();
  EXPECT_NE(page.find("<h1>Synthetic results</h1>"), std::string::npos) << page;
  EXPECT_NE(page.find("the server that sends the page forbids it"), std::string::npos);
  EXPECT_NE(page.find("Of all realisations</h2>"), std::string::npos);
  EXPECT_NE(page.find("Means over realisations, frame by frame</h2>"), std::string::npos);
  EXPECT_NE(page.find("&plusmn;") == std::string::npos ? page.find("±") : 0, std::string::npos);
}

TEST_F(ReportPage, LeavesOutWhatAStudyHasNot) {
  write_fixture(folder_, {.tasks = false, .transitions = false});
  fs::remove(folder_ / "ensemble/betti.csv");
  fs::remove(folder_ / "ensemble/force_distribution.csv");
  write_report(folder_);
  const Json found = open_page();
  ASSERT_TRUE(found.at("ready")) << console_;
  EXPECT_EQ(console_, "");
  EXPECT_EQ(found.at("problems").size(), 0u) << found.at("problems");
  EXPECT_EQ(sections(found), (std::vector<std::string>{"systems", "generators", "coordination", "topology", "order",
                                                       "mechanics", "explorer"}));
  EXPECT_EQ(found.at("blank"), 0);
}

TEST_F(ReportPage, StandsBeforeAnythingIsFinished) {
  write_fixture(folder_,
                {.ensemble = false, .tasks = false, .transitions = false, .title = "</script><b>\"odd\" & title"});
  write_report(folder_);
  const Json found = open_page();
  ASSERT_TRUE(found.at("ready")) << console_;
  EXPECT_EQ(console_, "");
  EXPECT_EQ(found.at("title"), "</script><b>\"odd\" & title");
  EXPECT_EQ(sections(found), std::vector<std::string>{"systems"});
}

}  // namespace
}  // namespace jam
