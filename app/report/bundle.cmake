# What the page of `ringwatch report` has in it, as bundle.cpp: built from npm's packages by report/web/remake and kept here, so that
# no build needs npm.
foreach(part bundle.js bundle.css LICENSES.txt)
  string(MAKE_C_IDENTIFIER ${part} name)
  file(READ ${CMAKE_CURRENT_LIST_DIR}/web/${part} ${name})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/web/${part})
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/bundle.cpp CONTENT [[
#include <ringwatch/app/report/bundle.h>

namespace ringwatch {
std::string_view reportScript() { return R"ringwatch(@bundle_js@)ringwatch"; }
std::string_view reportStyle() { return R"ringwatch(@bundle_css@)ringwatch"; }
std::string_view reportLicences() { return R"ringwatch(@LICENSES_txt@)ringwatch"; }
}  // namespace ringwatch
]] @ONLY)
