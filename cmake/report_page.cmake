# Embeds the files of the report's page, and Chart.js as Debian ships it, in one source file.
# Included, it gives plume_embed_report_page(); run as a script with OUTPUT and FILES, it writes that source file.

if(CMAKE_SCRIPT_MODE_FILE)
  set(arrays "")
  set(entries "")
  foreach(path ${FILES})
    get_filename_component(name ${path} NAME)
    string(MAKE_C_IDENTIFIER ${name} symbol)
    file(READ ${path} bytes HEX)
    string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
    string(APPEND arrays "const char ${symbol}[] = {${bytes}};\n")
    string(APPEND entries "    {\"${name}\", {${symbol}, sizeof(${symbol})}},\n")
  endforeach()
  file(WRITE ${OUTPUT}
"// Written by cmake/report_page.cmake.
#include \"sandbox/report/page_files.h\"

namespace plume {
namespace {
${arrays}}  // namespace

std::span<const PageFile> page_files() {
  static const PageFile kFiles[] = {
${entries}  };
  return kFiles;
}
}  // namespace plume
")
  return()
endif()

set(PLUME_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(plume_embed_report_page output)
  find_file(CHART_JS chart.min.js PATHS /usr/share/javascript/chart.js /usr/share/nodejs/chart.js/dist
            DOC "Chart.js 3: the charts of report.html")
  if(NOT CHART_JS)
    message(FATAL_ERROR "chart.min.js, version 3, is not there: install Debian's libjs-chart.js, as scripts/install.sh does, "
                        "or say where it is with -DCHART_JS=PATH")
  endif()
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/sandbox/report/page/*)
  list(APPEND files ${CHART_JS})
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${files}" -P ${PLUME_EMBED_SCRIPT}
    DEPENDS ${files} ${PLUME_EMBED_SCRIPT}
    COMMENT "Embedding the report's page"
    VERBATIM)
  set_source_files_properties(${output} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
