/// The page of a campaign: its parts, and how a browser shows it.
#include "apps/campaign.hpp"
#include "core/campaign/report.hpp"
#include "support/patterns.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace riedel::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Page, LetsEveryTextMeanItself) {
  Page page("a < b & \"c\"");
  page.paragraph("<script>alert(1)</script>");
  page.table({.caption = "1 > 0", .header = {"<i>"}, .rows = {{{{"x & y"}}, "run \"1\""}}});
  const std::string html = page.html();
  EXPECT_THAT(html, AllOf(HasSubstr("<title>a &lt; b &amp; &quot;c&quot;</title>"), HasSubstr("&lt;script&gt;alert(1)"),
                          HasSubstr("<th scope=\"col\" class=\"text\">&lt;i&gt;</th>"),
                          HasSubstr("<tr data-run=\"run &quot;1&quot;\">"), HasSubstr("x &amp; y")));
}

TEST(Page, EncodesBytesAsRfc4648Does) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Page, ListsTheCurvesThatHaveANameAndNoOthers) {
  Plot plot{.title = "", .x_label = "x", .y_label = "y", .series = {}};
  plot.series.push_back({.label = "one", .x = {0, 1}, .y = {0, 1}});
  plot.series.back().id = "run 1";
  plot.series.push_back({.label = "theory", .x = {0, 1}, .y = {1, 0}});
  Page page("p");
  page.plot(plot, "c");
  EXPECT_THAT(page.html(), AllOf(HasSubstr("<g data-run=\"run 1\">\n<polyline"),
                                 HasSubstr("aria-pressed=\"false\" data-run=\"run 1\""),
                                 Not(HasSubstr("data-run=\"theory\"")), HasSubstr(">theory</text>")));
}

TEST(Page, LeavesCaptionsWhereTheyAreWhileATableScrolls) {
  Page page("p");
  page.table({.caption = "what it is", .header = {"a"}, .rows = {{{{"1"}}}}});
  const std::string html = page.html();
  EXPECT_LT(html.find(">what it is<"), html.find("class=\"scroll\""));
  EXPECT_THAT(html, Not(HasSubstr("<caption")));
}

/// Ends of the ticks' labels on the bar of colours, in the units of its picture.
std::vector<std::pair<double, double>> labels_on_bar(const Interval& range) {
  Page page("p");
  page.pictures({.caption = "", .pictures = {}, .label = "e", .range = range});
  const std::string html = page.html();
  const std::string label = R"re(<text x="([^"]+)" y="31" text-anchor="middle">([^<]+)</text>)re";
  std::vector<std::pair<double, double>> ends;
  for (const auto& match : matches_in(html, label)) {
    const double x = std::stod(match[1]), half = 0.5 * text_width(match[2], 11);
    ends.emplace_back(x - half, x + half);
  }
  return ends;
}

TEST(Page, ShowsEveryLabelOfTheColoursWhole) {
  for (const Interval& range : {Interval{0.55, 0.9}, {0, 1}, {-1e-12, 1e-12}, {0.55, 0.5500001}, {1.2e5, 1.3e5}}) {
    const auto ends = labels_on_bar(range);
    ASSERT_FALSE(ends.empty());
    EXPECT_GE(ends.front().first, 0.0) << range.low;
    EXPECT_LE(ends.back().second, 352.0) << range.low;
    for (std::size_t i = 1; i < ends.size(); ++i) EXPECT_GT(ends[i].first, ends[i - 1].second) << range.low;
  }
}

/// What a browser that shows the page at this width finds in it.
nlohmann::json seen_in_browser(const std::string& browser, const TemporaryFolder& folder, const std::string& html,
                               int width) {
  const std::string probe = R"(<script>
const box = each => each.getBoundingClientRect();
const seen = {
  curves: [...document.querySelectorAll("svg g[data-run]")].filter(g => box(g).width > 50 && box(g).height > 20).length,
  tables: document.querySelectorAll("table").length,
  rows: document.querySelectorAll("tbody tr").length,
  images: [...document.images].filter(i => i.complete && i.naturalWidth > 50 && box(i).width > 20).length,
  width: innerWidth, overflow: document.documentElement.scrollWidth - innerWidth,
};
document.querySelector("button[data-run]").click();
seen.picked = new Set([...document.querySelectorAll(".picked")].map(e => e.dataset.run)).size;
seen.faded = [...document.querySelectorAll("svg g[data-run]")].filter(g => !g.classList.contains("picked")).length;
document.querySelector("button[data-run]").click();
seen.left = document.querySelectorAll(".picked").length;
document.documentElement.dataset.seen = JSON.stringify(seen);
</script>)";
  std::string page = html;
  page.insert(page.find("</body>"), probe);
  const std::string path = folder.file("page.html", page), found = (folder / "dom").string();
  const std::string call =
      browser + " --headless --no-sandbox --disable-gpu --user-data-dir=" + (folder / "profile").string() +
      " --window-size=" + std::to_string(width) + ",900 --dump-dom file://" + path + " >" + found + " 2>/dev/null";
  EXPECT_EQ(std::system(call.c_str()), 0);
  const std::string dom = file_content(found);
  const std::size_t start = dom.find("data-seen=\"") + 11;
  std::string json = dom.substr(start, dom.find('"', start) - start);
  for (std::size_t at = 0; (at = json.find("&quot;")) != std::string::npos;) json.replace(at, 6, "\"");
  return parsed(json);
}

std::string browser_on_path() {
  for (const std::string name : {"chromium", "chromium-browser", "google-chrome"})
    if (std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0) return name;
  return "";
}

class Report : public CampaignTest {};

TEST(Provenance, CountsRunsOnlyWhereThereAreAny) {
  const auto facts = provenance("riedel reproduce --figure 2", {});
  EXPECT_TRUE(std::ranges::none_of(facts, [](const auto& fact) { return fact.first == "Runs"; }));
  const std::vector<RunResult> one(1);
  EXPECT_EQ(provenance("", one).back().second, "0 of 1 done, 1 missing");
}

TEST_F(Report, ShowsRunsInThreeDimensionsAsTheMeanOverTheirDepth) {
  ASSERT_EQ(compare({"--schemes", "gimp,cpdi2", "--set", "grid.dimensions=3", "--set", "specimen.depth_cells=2",
                     "--set", "loading.final_strain=0.002"})
                .code,
            0);
  const std::string html = file_content(out_ / "report.html");
  EXPECT_THAT(html, AllOf(HasSubstr("alt=\"void ratio e [-], cpdi2\""), HasSubstr("alt=\"shear strain γ [-], gimp\"")));
  EXPECT_TRUE(fs::exists(out_ / "void_ratio_1.png"));
}

TEST_F(Report, CallsRunsByWhatTheyDifferIn) {
  ASSERT_EQ(compare({"--schemes", "gimp,linear", "--vary", "nonlocal.length=0,6mm"}).code, 0);
  const std::string html = file_content(out_ / "report.html");
  EXPECT_THAT(html, AllOf(HasSubstr("gimp, l_c = 6 mm</button>"), HasSubstr("linear, local</button>")));
  const std::string colour = html.substr(html.find("<svg class=\"swatch\""), 400);
  EXPECT_THAT(colour, HasSubstr("stroke=\"#d55e00\"")) << "gimp is the second scheme, in every plot";
}

TEST_F(Report, HoldsEveryRunAndNeedsNoNetwork) {
  ASSERT_EQ(compare({"--schemes", "gimp,linear,bspline3", "--vary", "loading.lateral=virtual_stress,points"}).code, 0);
  const std::string html = file_content(out_ / "report.html");
  for (const auto& row : results()) EXPECT_THAT(html, HasSubstr("<tr data-run=\"" + row.at("run") + "\">"));
  EXPECT_THAT(
      html, AllOf(HasSubstr("5 of 6 done, 1 refused"), HasSubstr("out of balance"), HasSubstr("riedel compare --out")));
  for (std::size_t at = 0; (at = html.find("http", at)) != std::string::npos; ++at)
    EXPECT_EQ(html.substr(at, 26), "http://www.w3.org/2000/svg") << "the name of a language, not a place";
  EXPECT_THAT(html, Not(HasSubstr("<link")));
}

TEST_F(Report, IsReadableInABrowserWideAndNarrow) {
  const std::string browser = browser_on_path();
  if (browser.empty()) GTEST_SKIP() << "no chromium, chromium-browser or google-chrome here";
  ASSERT_EQ(compare({"--schemes", "gimp,linear,bspline3"}).code, 0);
  for (const int width : {1400, 390}) {
    const nlohmann::json seen = seen_in_browser(browser, folder_, file_content(out_ / "report.html"), width);
    EXPECT_EQ(seen["curves"], 3) << width;
    EXPECT_EQ(seen["tables"], 3) << width;
    EXPECT_EQ(seen["rows"], 9) << width;
    EXPECT_EQ(seen["images"], 12) << width << ": four fields";
    EXPECT_LE(seen["overflow"], 0) << "the page scrolls sideways at " << seen["width"];
    EXPECT_EQ(seen["picked"], 1);
    EXPECT_EQ(seen["faded"], 2);
    EXPECT_EQ(seen["left"], 0);
  }
}

} // namespace
} // namespace riedel::test
