#include <gtest/gtest.h>

#include "jamscape/report/bundle.hpp"
#include "jamscape/report/page.hpp"

namespace jam {
namespace {

TEST(Page, DataCannotEndItsScriptElement) {
  const std::string html = print_page({"t", {{"study", Json{{"title", "</script><script>alert(1)</script><!--"}}}}});
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_NE(html.find("\\u003c/script>\\u003cscript>alert(1)"), std::string::npos);
}

TEST(Page, TitleIsText) {
  const std::string html = print_page({"a < b & \"c\"", {}});
  EXPECT_NE(html.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos);
}

TEST(Page, LoadsNothing) {
  const std::string html = print_page({"t", {}});
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  for (const char* reference : {" src=", "@import", "url(", "<link"})
    EXPECT_EQ(html.find(reference), std::string::npos);
}

TEST(Page, StandsWithoutItsProgram) {
  const std::string html = print_page({"a < b", {}, "<table><tr><td>z</td></tr></table>"});
  const std::size_t main = html.find("<main");
  for (const char* part : {"<h1>a &lt; b</h1>", "Content-Security-Policy); the file", "<td>z</td>"})
    EXPECT_NE(html.find(part, main), std::string::npos) << part;
  EXPECT_EQ(html.find("<noscript"), std::string::npos) << "scripts may be forbidden though they are on";
}

TEST(Page, HoldsItsProgram) {
  const std::string script = bundle_script();
  EXPECT_EQ(script.find("</script"), std::string::npos);
  EXPECT_NE(print_page({"t", {}}).find(script), std::string::npos);
}

}  // namespace
}  // namespace jam
