#include "app/about/libraries.h"

#include "core/base/shown.h"
#include "ui/view/graphics_versions.h"

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <QtGlobal>
#include <nanoflann.hpp>
#include <nlohmann/json.hpp>
#include <sqlite3.h>
#include <tbb/version.h>

#include <initializer_list>
#include <liblzf/lzf.h>
#include <libqhull_r/libqhull_r.h>
#include <pugixml.hpp>
#include <xxhash.h>
#include <zlib.h>

namespace espalier {
namespace {

/// {1, 4, 3}: "1.4.3"
std::string dotted(std::initializer_list<unsigned> numbers) {
  std::string text;
  for (const unsigned number : numbers)
    text += (text.empty() ? "" : ".") + std::to_string(number);
  return text;
}

/// "2020.2.r 2020/08/31": "2020.2"
std::string qhullVersion() {
  const std::string text = qh_version;
  return text.substr(0, text.find(".r"));
}

} // namespace

std::vector<Library> libraries() {
  const unsigned hashes = XXH_versionNumber();
  const GraphicsVersions graphics = graphicsVersions();
  return {{"Qt", qVersion(), "LGPL-3.0-only", Shown::tr("windows, pictures in 2D, reports")},
          {"VTK", graphics.vtk, "BSD-3-Clause", Shown::tr("pictures in 3D")},
          {"GLEW", graphics.glew, "BSD-3-Clause AND MIT", Shown::tr("functions of OpenGL")},
          {"libspnav", SPNAV_VERSION, "BSD-3-Clause", Shown::tr("3D mice")},
          {"Eigen", dotted({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION}),
           "MPL-2.0", Shown::tr("vectors and matrices")},
          {"nanoflann",
           dotted({NANOFLANN_VERSION >> 8U, (NANOFLANN_VERSION >> 4U) & 0xfU,
                   NANOFLANN_VERSION & 0xfU}),
           "BSD-2-Clause", Shown::tr("neighbors of points")},
          {"oneTBB", TBB_runtime_version(), "Apache-2.0", Shown::tr("work on all processors")},
          {"Qhull", qhullVersion(), "Qhull", Shown::tr("convex hulls")},
          {"SQLite", sqlite3_libversion(), "public domain", Shown::tr("project files")},
          {"xxHash", dotted({hashes / 10000, hashes / 100 % 100, hashes % 100}), "BSD-2-Clause",
           Shown::tr("whether a file is the same")},
          {"pugixml", dotted({PUGIXML_VERSION / 1000, PUGIXML_VERSION / 10 % 100}), "MIT",
           Shown::tr("files in XML")},
          {"JSON for Modern C++",
           dotted({NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                   NLOHMANN_JSON_VERSION_PATCH}),
           "MIT", Shown::tr("files in JSON")},
          {"zlib", zlibVersion(), "Zlib", Shown::tr("MAT files")},
          {"LibLZF", dotted({LZF_VERSION >> 8U, LZF_VERSION & 0xffU}), "BSD-2-Clause",
           Shown::tr("PCD files")},
          {"CLI11", CLI11_VERSION, "BSD-3-Clause", Shown::tr("the command line")}};
}

} // namespace espalier
