#include "jamscape/report/page.hpp"

#include "jamscape/report/bundle.hpp"
#include "jamscape/report/plain_tables.hpp"

namespace jam {
namespace {

/// JSON that cannot end the script element it stands in.
std::string embedded(const Json& data) {
  std::string out;
  for (const char c : data.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

/// Where scripts run the plain tables are not seen, unless drawing fails before the page stands.
constexpr const char* hide_plain =
    "(() => { const page = document.documentElement; page.classList.add('drawing'); "
    "addEventListener('error', () => { if (page.dataset.ready !== 'true') page.classList.remove('drawing'); }); })();";

constexpr const char* why_plain =
    "There are no figures here because the script inside this page that draws them did not run: JavaScript is switched "
    "off, or the server that sends the page forbids it (Content-Security-Policy); the file opened from a disk shows "
    "them.";

}  // namespace

std::string print_page(const Page& page) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
      "style-src 'unsafe-inline'; img-src data:\">\n";
  html += "<title>" + escaped(page.title) + "</title>\n<style>" + bundle_style() +
          "\n.drawing #plain { display: none }</style>\n" + "<script>" + hide_plain + "</script>\n</head>\n<body>\n";
  html += "<main id=\"report\"><div id=\"plain\"><h1>" + escaped(page.title) + "</h1>\n<p>" + why_plain + "</p>\n" +
          page.plain + "</div></main>\n";
  for (const Block& block : page.blocks)
    html += "<script type=\"application/json\" id=\"data-" + block.name + "\">" + embedded(block.data) + "</script>\n";
  html += "<script>" + bundle_script() + "</script>\n</body>\n</html>\n";
  return html;
}

}  // namespace jam
