# Writes OUTPUT: the files of FOLDER ending in .toml as text in the program.
file(GLOB files ${FOLDER}/*.toml)
set(entries "")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"~~(${text})~~\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"jamscape/study/builtin.hpp\"

namespace jam {

const std::vector<BuiltinFile>& builtin_files() {
  static const std::vector<BuiltinFile> files = {
${entries}  };
  return files;
}

}  // namespace jam
")
