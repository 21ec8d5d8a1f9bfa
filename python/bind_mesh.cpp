#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/generators/generator_registry.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/python/arrays.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/signatures.h>

namespace ringwatch::python {
namespace {

/// An element by its name, here or in meshio.
ElementType elementNamed(const std::string& given) {
  const py::dict ofMeshio = py::module_::import("ringwatch._convert").attr("_ELEMENT_OF_MESHIO");
  const std::string name = ofMeshio.contains(given) ? ofMeshio[given.c_str()].cast<std::string>() : given;
  std::vector<std::string_view> known;
  for (const ElementInfo& info : allElements()) {
    if (info.name == name) return info.type;
    known.push_back(info.name);
  }
  throw InputError(joinText("cells: unknown element ", inQuotes(name), "; ", didYouMean(name, known), "known are ",
                            shortList(known)));
}

HeldMesh sound(Mesh mesh, const char* source) {
  HeldMesh made;
  {
    const py::gil_scoped_release release;
    requireValid(mesh);
    requireSound(mesh, source, &made.notes);
    for (std::string& note : meshNotes(mesh, source)) made.notes.push_back(std::move(note));
  }
  made.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return made;
}

/// Numbers of the file, one each of `count` things.
std::vector<std::int64_t> idsOf(const std::string& name, py::handle given, std::size_t count) {
  std::vector<std::int64_t> ids = integersOf(name.c_str(), given, 1);
  if (ids.size() != count)
    throw InputError(joinText(name, ": ", ids.size(), " numbers; must be ", count, ", one each"));
  return ids;
}

HeldMesh meshOf(py::handle points, const py::object& cells, const py::dict& nodeSets, const py::object& nodeIds,
                const py::object& cellIds, const py::dict& cellSets) {
  Mesh mesh;
  const std::span<const double> numbers = realsOf("points", points, {-1, 3});
  const Eigen::Index nodes = numbers.size() / 3;
  mesh.X = NodeVectorsView(numbers.data(), nodes);
  const auto addBlock = [&](const std::string& name, py::handle listed) {
    const ElementType type = elementNamed(name);
    const int perElement = elementInfo(type).nodes;
    const std::string argument = joinText("cells[", inQuotes(name), "]");
    const py::object connectivity = listAsArray(listed);
    std::vector<std::int32_t> indices = indicesOf(argument.c_str(), connectivity, 2, nodes);
    const auto given = py::reinterpret_borrow<py::array>(connectivity);
    if (given.shape(1) != perElement)
      throw InputError(joinText(argument, ": ", describe(given), "; must be of shape ", shapeText({-1, perElement}),
                                ", ", perElement, " nodes an element"));
    mesh.blocks.push_back({type, std::move(indices), {}});
  };
  if (py::isinstance<py::dict>(cells)) {
    for (const auto& [name, connectivity] : py::reinterpret_borrow<py::dict>(cells))
      addBlock(name.cast<std::string>(), connectivity);
  } else {
    for (const py::handle block : cells) {
      const auto pair = block.cast<std::pair<std::string, py::object>>();
      addBlock(pair.first, pair.second);
    }
  }
  for (const auto& [name, set] : nodeSets) {
    const auto key = name.cast<std::string>();
    mesh.nodeSets[key] = indicesOf(joinText("node_sets[", inQuotes(key), "]").c_str(), set, 1, nodes);
  }
  for (const auto& [name, set] : cellSets) {
    const auto key = name.cast<std::string>();
    const std::string argument = joinText("cell_sets[", inQuotes(key), "]");
    if (!py::isinstance<py::sequence>(set) || py::len(set) != mesh.blocks.size())
      throw InputError(joinText(argument, ": ", describe(set), "; must be a list of an array for each of the ",
                                mesh.blocks.size(), " blocks"));
    std::vector<ElementRef>& members = mesh.elementSets[key];
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (const std::int32_t e :
           indicesOf(argument.c_str(), set[py::int_(b)], 1, static_cast<std::int64_t>(mesh.blocks[b].elementCount())))
        members.emplace_back(b, e);
  }
  if (!nodeIds.is_none()) mesh.nodeIds = idsOf("node_ids", nodeIds, mesh.nodeCount());
  if (!cellIds.is_none()) {
    if (!py::isinstance<py::sequence>(cellIds) || py::len(cellIds) != mesh.blocks.size())
      throw InputError(joinText("cell_ids: ", describe(cellIds), "; must be a list of an array for each of the ",
                                mesh.blocks.size(), " blocks"));
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      mesh.blocks[b].ids = idsOf(joinText("cell_ids[", b, "]"), cellIds[py::int_(b)], mesh.blocks[b].elementCount());
  }
  return sound(std::move(mesh), "mesh");
}

HeldMesh load(const std::filesystem::path& path, bool repair) {
  HeldMesh made;
  const py::gil_scoped_release release;
  Mesh mesh = loadMesh(path, &made.notes, repair);
  for (std::string& note : meshNotes(mesh, path.string())) made.notes.push_back(std::move(note));
  made.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return made;
}

HeldMesh generate(const std::string& kind, const py::kwargs& parameters) {
  GeneratorArguments arguments;
  for (const auto& [name, value] : parameters) {
    const auto key = name.cast<std::string>();
    try {
      if (py::isinstance<py::str>(value))
        arguments[key] = value.cast<std::string>();
      else if (py::isinstance<py::sequence>(value) || py::isinstance<py::array>(value))
        arguments[key] = value.cast<std::vector<double>>();
      else
        arguments[key] = value.cast<double>();
    } catch (const py::cast_error&) {
      throw InputError(
          joinText(kind, ": ", key, ": ", describe(value), "; must be a number, a list of numbers or a text"));
    }
  }
  return sound(generateMesh(kind, arguments), "mesh");
}

py::list blocksOf(const py::object& self) {
  const Mesh& mesh = *self.cast<const HeldMesh&>().mesh;
  py::list blocks;
  for (const MeshBlock& block : mesh.blocks)
    blocks.append(py::make_tuple(
        std::string(elementInfo(block.type).name),
        viewOf(block.connectivity.data(),
               {static_cast<py::ssize_t>(block.elementCount()), py::ssize_t{block.nodesPerElement()}}, self)));
  return blocks;
}

/// (name, nodes, number of VTK, number of gmsh, node i in gmsh's element, in VTK's) of every element, for readers of
/// other packages' meshes.
py::tuple elements() {
  py::list all;
  for (const ElementInfo& info : allElements()) {
    py::list order;
    for (int i = 0; i < info.nodes; ++i) order.append(info.gmshOrder.empty() ? i : int{info.gmshOrder[i]});
    py::list ofVtk;
    const bool wedge =
        detail::vtkCell(info.vtkCellType, static_cast<std::size_t>(info.nodes)).order == detail::NodeOrder::vtkWedge;
    for (std::size_t i = 0; i < static_cast<std::size_t>(info.nodes); ++i)
      ofVtk.append(wedge ? std::size_t{detail::vtkWedgeOrder[i]} : i);
    all.append(py::make_tuple(std::string(info.name), info.nodes, info.vtkCellType, info.gmshType, py::tuple(order),
                              py::tuple(ofVtk)));
  }
  return py::tuple(all);
}

}  // namespace

std::string meshText(const Mesh& mesh) {
  std::string text = joinText(mesh.nodeCount(), " nodes");
  for (const MeshBlock& block : mesh.blocks)
    text += joinText(", ", block.elementCount(), " ", elementInfo(block.type).name);
  return text;
}

void bindMesh(py::module_& module) {
  auto mesh = bindClass<py::class_<HeldMesh>>(
      module, "Mesh", py::init(&meshOf),
      "Points and elements, which never change: Mesh(points, {\"tet4\": cells}).\n\n"
      "points: (N, 3) float64 in C order, m. cells: by element name, ringwatch's or meshio's, (n, nodes of the "
      "element)\n"
      "of whole numbers in VTK's node order, of a wedge in gmsh's; or a list of (name, cells). node_sets: node "
      "numbers\n"
      "by name. node_ids, cell_ids: the numbers of another program, for messages: (N,), and a list of an array for "
      "each\n"
      "block. cell_sets: lists of the same form by name, with elements counted in their blocks. All of them are "
      "copied.\n"
      "Raises InputError for arrays of another shape or type, and for a mesh that is not sound: inverted or "
      "degenerate\n"
      "elements, nodes that do not exist. Elements of the other handedness are turned round, and nodes that no "
      "element\n"
      "uses are dropped: `notes` says so.",
      "", py::arg("points"), py::arg("cells"), py::kw_only(), py::arg("node_sets") = py::dict(),
      py::arg("node_ids") = py::none(), py::arg("cell_ids") = py::none(), py::arg("cell_sets") = py::dict());
  mesh.def("__repr__",
           [](const HeldMesh& self) {
             std::string text = joinText("<Mesh: ", meshText(*self.mesh));
             for (const auto& [name, set] : self.mesh->nodeSets) text += joinText(", set ", inQuotes(name));
             return text + ">";
           })
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const NodeVectors& X = self.cast<const HeldMesh&>().mesh->X;
            return viewOf(X.data(), {static_cast<py::ssize_t>(X.cols()), py::ssize_t{3}}, self);
          },
          "Positions at rest, (N, 3), m: a view that cannot be written.")
      .def_property_readonly(
          "blocks", [](const py::object& self) { return py::tuple(blocksOf(self)); },
          "(element name, nodes of the elements (n, k), int32) of each block: views.")
      .def_property_readonly(
          "cells",
          [](const py::object& self) {
            py::dict cells;
            for (const py::handle block : blocksOf(self)) {
              const auto pair = py::reinterpret_borrow<py::tuple>(block);
              if (cells.contains(pair[0]))
                throw InputError(
                    joinText("cells: the mesh has several blocks of ", pair[0].cast<std::string>(), "; use blocks"));
              cells[pair[0]] = pair[1];
            }
            return cells;
          },
          "Nodes of the elements by element name; InputError where two blocks have the same.")
      .def_property_readonly(
          "node_sets",
          [](const py::object& self) {
            py::dict sets;
            for (const auto& [name, set] : self.cast<const HeldMesh&>().mesh->nodeSets)
              sets[py::str(name)] = viewOf(set.data(), {static_cast<py::ssize_t>(set.size())}, self);
            return sets;
          },
          "Node numbers by name: views.")
      .def_property_readonly(
          "cell_sets",
          [](const HeldMesh& self) {
            py::dict sets;
            for (const auto& [name, set] : self.mesh->elementSets) {
              std::vector<std::vector<std::int32_t>> members(self.mesh->blocks.size());
              for (const ElementRef e : set) members[static_cast<std::size_t>(e.block)].push_back(e.element);
              py::list arrays;
              for (const std::vector<std::int32_t>& own : members)
                arrays.append(py::array_t<std::int32_t>(static_cast<py::ssize_t>(own.size()), own.data()));
              sets[py::str(name)] = arrays;
            }
            return sets;
          },
          "Elements by name, a list of an array for each block.")
      .def_property_readonly(
          "notes", [](const HeldMesh& self) { return py::tuple(py::cast(self.notes)); },
          "What the reader wants to be known, one line each.")
      .def_property_readonly("element_count", [](const HeldMesh& self) { return self.mesh->elementCount(); });
  bindMethod(
      mesh, "save",
      [](const HeldMesh& self, const std::filesystem::path& path) {
        const py::gil_scoped_release release;
        writeMesh(*self.mesh, path);
      },
      "Writes the mesh, as .msh or .vtu.", py::arg("path"));
  module.def("_elements", &elements);
  bindFunction(
      module, "load_mesh", &load,
      "Reads a mesh to compute with, in the formats of `ringwatch help formats`. Coordinates are taken as m. "
      "With repair\nit is mended first, as by `ringwatch mesh repair`. Raises InputError with the line that the "
      "command line prints.",
      "", py::arg("path"), py::kw_only(), py::arg("repair") = false);
  bindFunction(module, "generate_mesh", &generate,
               "Makes a mesh from parameters, as `ringwatch help generators` lists them: generate_mesh(\"bar\", "
               "cells=[8, 2, 2]).",
               "**parameters", py::arg("kind"), py::pos_only());
}

}  // namespace ringwatch::python
