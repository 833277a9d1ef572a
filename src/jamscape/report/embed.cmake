# Writes OUTPUT: the files SCRIPT and STYLE as bytes in the program. Bytes, because compilers limit the length of a string.
function(bytes_of file result)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  set(${result} "${bytes}" PARENT_SCOPE)
endfunction()

bytes_of(${SCRIPT} script)
bytes_of(${STYLE} style)
file(WRITE ${OUTPUT} "#include \"jamscape/report/bundle.hpp\"

namespace jam {
namespace {

constexpr unsigned char script[] = {${script}};
constexpr unsigned char style[] = {${style}};

}  // namespace

std::string bundle_script() { return {std::begin(script), std::end(script)}; }
std::string bundle_style() { return {std::begin(style), std::end(style)}; }

}  // namespace jam
")
