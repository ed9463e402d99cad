#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/scan_notes.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/held.h"
#include "python/job.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

namespace espalier::python {
namespace {

template <class T> std::vector<Eigen::Vector3d> rowsOf(const py::array_t<T>& array) {
  const auto values = array.template unchecked<2>();
  std::vector<Eigen::Vector3d> rows(static_cast<std::size_t>(values.shape(0)));
  for (py::ssize_t i = 0; i < values.shape(0); ++i)
    rows[static_cast<std::size_t>(i)] = {static_cast<double>(values(i, 0)),
                                         static_cast<double>(values(i, 1)),
                                         static_cast<double>(values(i, 2))};
  return rows;
}

/// The positions in an array: it is read where it lies, whatever its strides, if it has floats or
/// doubles.
std::vector<Eigen::Vector3d> positionsIn(const py::object& object) {
  requireUnmasked(object, "points");
  if (py::isinstance<py::array_t<float>>(object)) {
    const auto array = py::reinterpret_borrow<py::array_t<float>>(object);
    requireShape(array, "points", -1, 3);
    return rowsOf(array);
  }
  const py::array_t<double> array = numbersIn<double>(object, "points");
  requireShape(array, "points", -1, 3);
  return rowsOf(array);
}

RawPoints rawPoints(const py::object& points, const py::object& colors,
                    const py::object& intensities) {
  RawPoints raw{.positions = positionsIn(points), .colors = {}, .intensities = {}};
  const auto count = static_cast<py::ssize_t>(raw.positions.size());
  if (!colors.is_none()) {
    const auto array = wholeNumbersIn<std::uint8_t>(colors, "colors", 0, 255);
    requireShape(array, "colors", count, 3);
    const auto values = array.unchecked<2>();
    for (py::ssize_t i = 0; i < count; ++i)
      raw.colors.push_back({values(i, 0), values(i, 1), values(i, 2)});
  }
  if (!intensities.is_none()) {
    const auto array = numbersIn<float>(intensities, "intensities");
    requireShape(array, "intensities", count, 1);
    const auto values = array.unchecked<1>();
    for (py::ssize_t i = 0; i < count; ++i)
      raw.intensities.push_back(values(i));
  }
  return raw;
}

HeldScan scanOf(const py::object& points, const py::object& colors, const py::object& intensities,
                const py::object& report) {
  RawPoints raw = rawPoints(points, colors, intensities);
  const std::size_t given = raw.positions.size();
  auto cloud = std::make_shared<const PointCloud>(resultOf(
      report, 0, [&](const Progress& progress) { return PointCloud(std::move(raw), progress); }));
  if (cloud->isEmpty())
    throw Error("points hold " + std::to_string(given) +
                " rows, none of them finite: give the points of a scan");
  std::vector<ShownMessage> notes = scanNotes(*cloud, "points");
  if (auto note = leftOutNote(*cloud, given, "points")) notes.insert(notes.begin(), *note);
  return {std::move(cloud), eachInEnglish(notes)};
}

HeldScan scanIn(const std::filesystem::path& path, const py::object& report) {
  auto read =
      resultOf(report, 0, [&](const Progress& progress) { return readPoints(path, progress); });
  return {std::make_shared<const PointCloud>(std::move(read.value)), eachInEnglish(read.notes)};
}

py::object colorsOf(const HeldScan& scan) {
  const std::vector<Color>& colors = scan.cloud->colors();
  if (colors.empty()) return py::none();
  static_assert(sizeof(Color) == 3);
  return viewOf({std::ssize(colors), 3}, colors.front().data(), scan.cloud);
}

py::object intensitiesOf(const HeldScan& scan) {
  const std::vector<float>& values = scan.cloud->intensities();
  if (values.empty()) return py::none();
  return viewOf({std::ssize(values)}, values.data(), scan.cloud);
}

} // namespace

void bindScan(py::module_& module) {
  py::class_<HeldScan> scan(
      module, "Scan", ofPlainType(),
      "Points of a scan, sorted so that near ones are near in memory.\n\n"
      "The arrays given are read once; what is kept takes 16 bytes a point, 3 more with colors "
      "and\n"
      "4 with intensities. All arrays here are views of that, and can only be read. Points that\n"
      "are not finite are left out, as `notes` says.");
  scan.def(py::init(&scanOf), py::arg("points"), py::kw_only(), py::arg("colors") = py::none(),
           py::arg("intensities") = py::none(), py::arg("progress") = py::none(),
           documented("__init__(self, points, *, colors=None, intensities=None, progress=None)",
                      "points: an array (n, 3) of positions. colors: (n, 3), 0 to 255.\n"
                      "intensities: (n,). progress: called with the fraction done and the stage.")
               .c_str());
  scan.def_static("read", &scanIn, py::arg("path"), py::kw_only(), py::arg("progress") = py::none(),
                  documented("read(path, *, progress=None)",
                             "The points of a file, in any format that is read, as PLY or LAS.")
                      .c_str());
  scan.def(
      "write",
      [](const HeldScan& self, const std::filesystem::path& path) {
        const py::gil_scoped_release released;
        writePoints(path, *self.cloud);
      },
      py::arg("path"),
      documented("write(self, path)",
                 "Writes the points in the order in which they were given, as PLY (.ply) or text\n"
                 "(.xyz, .asc, .txt, .csv, .pts). The file is whole or as it was before.")
          .c_str());
  scan.def_property_readonly(
      "positions",
      [](const HeldScan& self) {
        return viewOf({self.cloud->size(), 3}, self.cloud->positions().data(), self.cloud);
      },
      "(n, 3) floats, about `origin`: positions + origin are in the frame of the points given.");
  scan.def_property_readonly(
      "origin",
      [](const HeldScan& self) { return viewOf({3}, self.cloud->origin().data(), self.cloud); },
      "(3,) doubles.");
  scan.def_property_readonly(
      "order",
      [](const HeldScan& self) {
        const auto& order = self.cloud->fileOrder();
        return viewOf({std::ssize(order)}, order.data(), self.cloud);
      },
      "(n,): the row of the points given, or the place in the file, that each point comes from.");
  scan.def_property_readonly("colors", &colorsOf, "(n, 3), 0 to 255: red, green, blue; or None.");
  scan.def_property_readonly("intensities", &intensitiesOf, "(n,) floats, or None.");
  scan.def_readonly("notes", &HeldScan::notes,
                    "What one should know of these points, a line each.");
  scan.def("__len__", [](const HeldScan& self) { return self.cloud->size(); });
  scan.def("__repr__", [](const HeldScan& self) {
    return "<espalier.Scan of " + std::to_string(self.cloud->size()) + " points>";
  });
}

} // namespace espalier::python
