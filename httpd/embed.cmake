# Writes client_scripts into one .cpp:
#   cmake -DROOT=client_scripts -DLAYOUTS=city_db -DBUNDLES=FOLDER -DOUT=client_files.cpp -P embed.cmake
# LAYOUTS' *_layout.h become layout/*_layout.h: the page and its shaders read the formats that C++ was compiled with.
# BUNDLES' files (bundle_*.cmake) lie beside the folders core, x3d and page.
set(files)
foreach(suffix js mjs html css svg png vert frag)
  foreach(folder core x3d page)
    file(GLOB_RECURSE found RELATIVE ${ROOT} ${ROOT}/${folder}/*.${suffix})
    list(APPEND files ${found})
  endforeach()
endforeach()
list(FILTER files EXCLUDE REGEX "\\.test\\.|node_modules")
list(SORT files)
set(arrays "")
set(table "")
set(count 0)

macro(embed name path)
  file(READ ${path} hex HEX)
  file(SIZE ${path} size)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
  string(REGEX REPLACE "('\\\\x[0-9a-f][0-9a-f]',){24}" "\\0\n    " bytes "${bytes}")
  string(APPEND arrays "constexpr char kFile${count}[] = {\n    ${bytes}'\\0'};\n")
  string(APPEND table "      {\"${name}\", {kFile${count}, ${size}}},\n")
  math(EXPR count "${count} + 1")
endmacro()

foreach(file ${files})
  embed(${file} ${ROOT}/${file})
endforeach()
file(GLOB layouts RELATIVE ${LAYOUTS} ${LAYOUTS}/*_layout.h)
foreach(file ${layouts})
  embed(layout/${file} ${LAYOUTS}/${file})
endforeach()
file(GLOB_RECURSE bundles RELATIVE ${BUNDLES} ${BUNDLES}/*.js ${BUNDLES}/*.css)
list(SORT bundles)
foreach(file ${bundles})
  embed(${file} ${BUNDLES}/${file})
endforeach()
file(WRITE ${OUT}.new "#include \"httpd/static_files.hpp\"\n\nnamespace vicus {\nnamespace {\n${arrays}}  // namespace\n
const std::vector<EmbeddedFile>& embedded_client_files() {
  static const std::vector<EmbeddedFile> files = {
${table}  };
  return files;
}

}  // namespace vicus\n")
file(RENAME ${OUT}.new ${OUT})
