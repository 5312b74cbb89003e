# Makes report/page_source.hpp of the page's sources: the HTML with its style and script in it, in two parts.
set(page ${CMAKE_CURRENT_SOURCE_DIR}/report)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page}/page.html ${page}/page.css ${page}/view.js
                                                               ${page}/page.js ${page}/controls.js)
file(READ ${page}/page.html PAGE_HEAD)
foreach(source page.css view.js page.js controls.js)
  file(READ ${page}/${source} text)
  string(REPLACE "{{${source}}}" "${text}" PAGE_HEAD "${PAGE_HEAD}")
endforeach()
string(FIND "${PAGE_HEAD}" "{{pairs}}" end)
string(SUBSTRING "${PAGE_HEAD}" ${end} -1 PAGE_TAIL)
string(REPLACE "{{pairs}}" "" PAGE_TAIL "${PAGE_TAIL}")
string(SUBSTRING "${PAGE_HEAD}" 0 ${end} PAGE_HEAD)
configure_file(${page}/page_source.hpp.in report/page_source.hpp @ONLY)
