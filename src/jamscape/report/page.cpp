#include "jamscape/report/page.hpp"

#include "jamscape/report/bundle.hpp"

namespace jam {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

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

}  // namespace

std::string print_page(const Page& page) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
      "style-src 'unsafe-inline'; img-src data:\">\n";
  html += "<title>" + escaped(page.title) + "</title>\n<style>" + bundle_style() + "</style>\n</head>\n<body>\n";
  html += "<main id=\"report\"><noscript><h1>" + escaped(page.title) +
          "</h1><p>This page draws its figures with JavaScript, which is switched off.</p></noscript></main>\n";
  for (const Block& block : page.blocks)
    html += "<script type=\"application/json\" id=\"data-" + block.name + "\">" + embedded(block.data) + "</script>\n";
  html += "<script>" + bundle_script() + "</script>\n</body>\n</html>\n";
  return html;
}

}  // namespace jam
