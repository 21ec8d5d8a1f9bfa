#pragma once
#include <string_view>

namespace ringwatch {

// Made by CMake from app/report/web/bundle.js, bundle.css and page.js's libraries' licences: see app/report/web/remake.

/// The script of the page, with three.js and uPlot in it.
std::string_view reportScript();
/// Its style sheet.
std::string_view reportStyle();
/// The licences of the libraries in it.
std::string_view reportLicences();

}  // namespace ringwatch
