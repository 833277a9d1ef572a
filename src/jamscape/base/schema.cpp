#include "jamscape/base/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "jamscape/base/error.hpp"
#include "jamscape/base/nearest.hpp"

namespace jam {
namespace {

template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

std::string name_of(const Written& written) {
  return std::visit(Overload{[](bool b) { return fmt::format("the truth value {}", b); },
                             [](std::int64_t n) { return fmt::format("the integer {}", n); },
                             [](double x) { return fmt::format("the number {}", print_number(x)); },
                             [](const std::string& s) { return fmt::format("the text {}", print_text(s)); },
                             [](const std::vector<Written>&) { return std::string("a list"); }},
                    written.value);
}

[[noreturn]] void throw_wrong_type(const Option& option, const Written& written) {
  throw usage_error(
      fmt::format("'{}' is {}, where {} is expected", option.key, name_of(written), describe_type(option)),
      written.place, fmt::format("jamscape explain {}", option.key));
}

void check_range(const Option& option, double value, const std::string& place) {
  const OptionMeta& m = option.meta;
  const bool inside = value <= m.max && (m.above_min ? value > m.min : value >= m.min);
  if (std::isfinite(value) && inside) return;
  const std::string allowed = describe_range(m);
  throw usage_error(fmt::format("'{}' = {} is out of range: it must be {}", option.key, print_number(value),
                                allowed.empty() ? "finite" : allowed),
                    place, fmt::format("jamscape explain {}", option.key));
}

double number(const Option& option, const Written& written, const Scales& scales) {
  double value = 0;
  if (const auto* x = std::get_if<double>(&written.value))
    value = *x;
  else if (const auto* n = std::get_if<std::int64_t>(&written.value))
    value = static_cast<double>(*n);
  else if (const auto* text = std::get_if<std::string>(&written.value))
    value = read_quantity(*text, option.key, option.meta, written.place, scales);
  else
    throw_wrong_type(option, written);
  check_range(option, value, written.place);
  return value + 0.0;  // -0.0 is 0: both name one simulation
}

}  // namespace

void assign(const Option& option, const Written& written, const Scales& scales) {
  const auto wanted = [&]<class T>(T*) -> const T& {
    if (const T* value = std::get_if<T>(&written.value)) return *value;
    throw_wrong_type(option, written);
  };
  const auto items = [&]() -> const std::vector<Written>& {
    return wanted(static_cast<std::vector<Written>*>(nullptr));
  };
  std::visit(Overload{[&](bool* p) { *p = wanted(p); },
                      [&](std::int64_t* p) {
                        const std::int64_t value = wanted(p);
                        check_range(option, static_cast<double>(value), written.place);
                        *p = value;
                      },
                      [&](double* p) { *p = number(option, written, scales); }, [&](std::string* p) { *p = wanted(p); },
                      [&](std::vector<double>* p) {
                        std::vector<double> values;
                        for (const Written& item : items()) values.push_back(number(option, item, scales));
                        *p = std::move(values);
                      },
                      [&](std::vector<std::string>* p) {
                        std::vector<std::string> values;
                        for (const Written& item : items()) {
                          const auto* text = std::get_if<std::string>(&item.value);
                          if (!text) throw_wrong_type(option, item);
                          values.push_back(*text);
                        }
                        *p = std::move(values);
                      },
                      [&](const EnumTarget& e) {
                        const std::string& text = wanted(static_cast<std::string*>(nullptr));
                        const auto at = std::find(e.names.begin(), e.names.end(), text);
                        if (at == e.names.end()) {
                          const std::string near = nearest(text, {e.names.begin(), e.names.end()});
                          throw usage_error(
                              fmt::format("'{}' cannot be \"{}\": it is {}", option.key, text, describe_type(option)),
                              written.place,
                              near.empty() ? fmt::format("jamscape explain {}", option.key)
                                           : fmt::format("{} = \"{}\"", option.key, near));
                        }
                        e.set(static_cast<std::size_t>(at - e.names.begin()));
                      }},
             option.target);
}

std::string print_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string print_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (c == '\n')
      out += "\\n";
    else if (c == '\t')
      out += "\\t";
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string print_value(const Option& option) {
  const auto list = [](const auto& values, auto print) {
    std::string text;
    for (const auto& v : values) text += (text.empty() ? "" : ", ") + print(v);
    return "[" + text + "]";
  };
  return std::visit(Overload{[](bool* p) { return std::string(*p ? "true" : "false"); },
                             [](std::int64_t* p) { return fmt::format("{}", *p); },
                             [](double* p) { return print_number(*p); }, [](std::string* p) { return print_text(*p); },
                             [&](std::vector<double>* p) { return list(*p, print_number); },
                             [&](std::vector<std::string>* p) { return list(*p, print_text); },
                             [](const EnumTarget& e) { return print_text(e.names[e.get()]); }},
                    option.target);
}

std::string describe_type(const Option& option) {
  const bool with_unit = !option.meta.unit.empty();
  return std::visit(
      Overload{[](bool*) { return std::string("true or false"); },
               [](std::int64_t*) { return std::string("an integer"); },
               [&](double*) {
                 return with_unit ? fmt::format("a number (in {})", option.meta.unit) : std::string("a number");
               },
               [](std::string*) { return std::string("text in quotes"); },
               [](std::vector<double>*) { return std::string("a list of numbers"); },
               [](std::vector<std::string>*) { return std::string("a list of texts"); },
               [](const EnumTarget& e) { return fmt::format("one of \"{}\"", fmt::join(e.names, "\", \"")); }},
      option.target);
}

std::string describe_range(const OptionMeta& meta) {
  const bool low = std::isfinite(meta.min), high = std::isfinite(meta.max);
  std::string text;
  if (low) text = fmt::format("{} {}", meta.above_min ? "above" : "at least", meta.min);
  if (high) text += fmt::format("{}at most {}", low ? " and " : "", meta.max);
  return text;
}

void throw_unknown_key(std::string_view key, const std::vector<std::string>& known, std::string place) {
  const std::string near = nearest(key, known);
  throw usage_error(fmt::format("unknown key '{}'", key), std::move(place),
                    near.empty() ? "jamscape explain lists all keys" : fmt::format("did you mean '{}'?", near));
}

}  // namespace jam
