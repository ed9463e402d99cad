#include "core/base/coordinates.h"
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/structure_text.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/held.h"
#include "python/words.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <sstream>

namespace espalier::python {

NodeRows::NodeRows(const Skeleton& skeleton) : rowOf(skeleton.idEnd(), -1) {
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    rowOf[indexOf(id)] = std::ssize(ids);
    ids.push_back(static_cast<std::uint32_t>(indexOf(id)));
    positions.insert(positions.end(), node.position.begin(), node.position.end());
    radii.push_back(node.radius);
    parents.push_back(node.parent ? row(*node.parent) : -1);
    edges.push_back(static_cast<char32_t>(node.edge));
  }
}

namespace {

/// The types of edges that were given; none: the first child of a node goes on, others branch off.
std::u32string edgesIn(const py::object& object, const py::array_t<std::int64_t>& parents) {
  const auto count = static_cast<std::size_t>(parents.size());
  std::u32string edges(count, U'<');
  if (object.is_none()) {
    std::vector<bool> hasChild(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t parent = parents.at(i);
      if (parent < 0 || parent >= static_cast<std::int64_t>(i)) continue;
      if (hasChild[static_cast<std::size_t>(parent)]) edges[i] = U'+';
      hasChild[static_cast<std::size_t>(parent)] = true;
    }
    return edges;
  }
  const py::list words(object);
  if (words.size() != count)
    throw Error("edges are " + std::to_string(words.size()) + ": give one for each of " +
                counted(count, "node"));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string word = py::str(words[i]);
    if (word != "<" && word != "+")
      throw Error("edges, row " + std::to_string(i) +
                  ": write '<' for a successor or '+' for a "
                  "branching, not '" +
                  word + "'");
    edges[i] = static_cast<char32_t>(word[0]);
  }
  return edges;
}

HeldSkeleton skeletonOf(const py::object& positionsGiven, const py::object& parentsGiven,
                        const py::object& radiiGiven, const py::object& edgesGiven) {
  const auto positions = numbersIn<double>(positionsGiven, "positions");
  requireShape(positions, "positions", -1, 3);
  const py::ssize_t count = positions.shape(0);
  const std::int64_t lastRow = count - 1;
  const auto parents = wholeNumbersIn<std::int64_t>(parentsGiven, "parents", -1, lastRow);
  requireShape(parents, "parents", count, 1);
  py::array_t<double> radii;
  if (!radiiGiven.is_none()) {
    radii = numbersIn<double>(radiiGiven, "radii");
    requireShape(radii, "radii", count, 1);
  }
  const std::u32string edges = edgesIn(edgesGiven, parents);
  Skeleton skeleton;
  skeleton.reserve(static_cast<std::size_t>(count));
  for (py::ssize_t i = 0; i < count; ++i) {
    const std::string where = "row " + std::to_string(i);
    Node node{.position = {positions.at(i, 0), positions.at(i, 1), positions.at(i, 2)},
              .radius = radiiGiven.is_none() ? 0 : radii.at(i)};
    if (!isInRange(node.position, node.radius)) throw outOfRange(FilePlace{where});
    if (node.radius < 0) throw Error(where + ": its radius is below 0: correct it");
    const std::int64_t parent = parents.at(i);
    if (parent >= i)
      throw Error(where + ": its parent, row " + std::to_string(parent) +
                  ", is no row before it: list parents before their children, and -1 for roots");
    if (parent >= 0) node.parent = NodeId(static_cast<std::uint32_t>(parent));
    node.edge = static_cast<EdgeType>(edges[static_cast<std::size_t>(i)]);
    skeleton.add(node);
  }
  return {.skeleton = std::make_shared<const Skeleton>(std::move(skeleton))};
}

HeldSkeleton held(Imported<Structure> structure) {
  return {.skeleton = std::make_shared<const Skeleton>(std::move(structure.value.skeleton)),
          .frame = std::move(structure.value.frame),
          .notes = eachInEnglish(structure.notes)};
}

HeldSkeleton fromMtg(const std::string& text) {
  const py::gil_scoped_release released;
  constexpr const char* name = "mtg";
  std::istringstream in(text);
  Imported<Mtg> mtg = readMtg(in, name);
  Imported<Structure> structure =
      structureOf({std::move(mtg.value), text}, std::move(mtg.notes), name);
  if (isWithoutPositions(structure.value)) // says so
    (void)espalier::skeletonOf(structure.value.frame->mtg, name);
  return held(std::move(structure));
}

HeldSkeleton skeletonIn(const std::filesystem::path& path) {
  const py::gil_scoped_release released;
  return held(readStructure(path));
}

Structure structureOf(const HeldSkeleton& self) {
  return {.skeleton = *self.skeleton, .frame = self.frame};
}

std::string mtgOf(const HeldSkeleton& self, const std::string& scales) {
  const py::gil_scoped_release released;
  return mtgTextOf(structureOf(self), mtgStyleIn(scales));
}

void write(const HeldSkeleton& self, const std::filesystem::path& path, const std::string& scales) {
  const py::gil_scoped_release released;
  writeStructure(path, structureOf(self), mtgStyleIn(scales));
}

void bindArrays(py::class_<HeldSkeleton>& skeleton) {
  const auto count = [](const HeldSkeleton& self) { return std::ssize(self.rows->ids); };
  skeleton.def_property_readonly(
      "positions",
      [count](const HeldSkeleton& self) {
        return viewOf({count(self), 3}, self.rows->positions.data(), self.rows);
      },
      "(n, 3) doubles, in the frame of the scan.");
  skeleton.def_property_readonly(
      "radii",
      [count](const HeldSkeleton& self) {
        return viewOf({count(self)}, self.rows->radii.data(), self.rows);
      },
      "(n,) doubles; 0 where the radius is not known.");
  skeleton.def_property_readonly(
      "parents",
      [count](const HeldSkeleton& self) {
        return viewOf({count(self)}, self.rows->parents.data(), self.rows);
      },
      "(n,): the row of the parent, which is before its own; -1 for a root.");
  skeleton.def_property_readonly(
      "edges",
      [count](const HeldSkeleton& self) {
        return viewOf(py::dtype("U1"), {count(self)}, self.rows->edges.data(), self.rows);
      },
      "(n,): '<' where a node goes on the axis of its parent, '+' where it branches off; without\n"
      "meaning for a root.");
  skeleton.def_property_readonly(
      "ids",
      [count](const HeldSkeleton& self) {
        return viewOf({count(self)}, self.rows->ids.data(), self.rows);
      },
      "(n,): the numbers by which the program names nodes.");
}

} // namespace

void bindSkeleton(py::module_& module) {
  py::class_<HeldSkeleton> skeleton(
      module, "Skeleton", ofPlainType(),
      "Nodes of a plant, a row for each, parents before their children.\n\n"
      "The arrays are made once, with the skeleton; they can only be read. One that was read from\n"
      "an MTG keeps its scales, classes, features and comments, and mtg() gives them back.");
  skeleton.def(
      py::init(&skeletonOf), py::arg("positions"), py::arg("parents"),
      py::arg("radii") = py::none(), py::arg("edges") = py::none(),
      documented(
          "__init__(self, positions, parents, radii=None, edges=None)",
          "positions: (n, 3). parents: (n,) rows before their own, -1 for roots. radii: (n,).\n"
          "edges: (n,) of '<' and '+'; None: the first child of a node goes on its axis, the\n"
          "others branch off. The arrays are copied.")
          .c_str());
  skeleton.def_static("read", &skeletonIn, py::arg("path"),
                      documented("read(path)", "The structure of a file, in any format that is "
                                               "read, as MTG or SWC.")
                          .c_str());
  skeleton.def_static(
      "from_mtg", &fromMtg, py::arg("text"),
      documented("from_mtg(text)", "The structure that an MTG describes, by its text.").c_str());
  skeleton.def(
      "mtg", &mtgOf, py::kw_only(), py::arg("scales") = "plant-node",
      documented("mtg(self, *, scales='plant-node')",
                 "Its text as an MTG, as the program writes it.\n\n"
                 "scales: plant-node or plant-axis-node, of one without scales of its own.")
          .c_str());
  skeleton.def("write", &write, py::arg("path"), py::kw_only(), py::arg("scales") = "plant-node",
               documented("write(self, path, *, scales='plant-node')",
                          "Writes a file, whose ending sets the format, as .mtg or .swc. The file\n"
                          "is whole or as it was before. scales: as of mtg().")
                   .c_str());
  bindArrays(skeleton);
  skeleton.def_readonly("notes", &HeldSkeleton::notes,
                        "What one should know of how it was read, a line each.");
  skeleton.def("__len__", [](const HeldSkeleton& self) { return self.skeleton->size(); });
  skeleton.def("__repr__", [](const HeldSkeleton& self) {
    return "<espalier.Skeleton of " + counted(self.skeleton->size(), "node") + ">";
  });
}

} // namespace espalier::python
