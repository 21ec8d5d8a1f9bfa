#include <algorithm>
#include <array>
#include <cmath>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/units.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/python/arrays.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/signatures.h>

namespace ringwatch::python {
namespace {

/// A number of Python, of numpy's scalars too.
double numberOf(const std::string& name, py::handle value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred()) {
    PyErr_Clear();
    throw InputError(joinText(name, ": ", describe(value), "; must be a number"));
  }
  return number;
}

Material materialOf(const std::string& model, py::handle density, const py::kwargs& parameters) {
  Options options;
  for (const auto& [name, value] : parameters) {
    const auto key = name.cast<std::string>();
    options.set(key, numberOf(key, value));
  }
  return makeMaterial(model, options, numberOf("density", density));
}

std::shared_ptr<HeldBody> bodyOf(const HeldMesh& mesh, const py::object& material, const std::string& lumping,
                                 const ElementRules& rules, int threads) {
  BodyOptions options;
  options.lumping = lumpingNames.valueOf("lumping", lumping);
  options.rules = rules;
  if (threads < 0) throw InputError(joinText("threads = ", threads, ": must be 0, for all, or more"));
  options.threads = threads;
  if (py::isinstance<Material>(material)) {
    const auto one = material.cast<Material>();
    const py::gil_scoped_release release;
    return std::make_shared<HeldBody>(*mesh.mesh, one, options);
  }
  std::vector<Material> materials;
  try {
    materials = material.cast<std::vector<Material>>();
  } catch (const py::cast_error&) {
    throw InputError(
        joinText("material: ", describe(material), "; must be a Material, or a list of one for each block"));
  }
  const py::gil_scoped_release release;
  return std::make_shared<HeldBody>(*mesh.mesh, materials, options);
}

/// Which of x, y, z a text names.
std::array<bool, 3> componentsOf(const std::string& text) {
  std::array<bool, 3> chosen{};
  for (const char letter : text) {
    const std::size_t at = std::string_view("xyz").find(letter);
    if (at == std::string_view::npos || chosen[at])
      throw InputError(joinText("components = \"", text, "\": must be some of x, y and z, each once"));
    chosen[at] = true;
  }
  if (text.empty()) throw InputError("components = \"\": must be some of x, y and z, each once");
  return chosen;
}

/// Nodes by the name of a set, by their numbers, or by a flag for each node.
std::vector<std::int32_t> nodesOf(py::handle listed, const Mesh& mesh) {
  if (py::isinstance<py::str>(listed)) {
    const auto name = listed.cast<std::string>();
    if (const auto set = mesh.nodeSets.find(name); set != mesh.nodeSets.end()) return set->second;
    std::vector<std::string_view> known;
    for (const auto& [other, set] : mesh.nodeSets) known.push_back(other);
    throw InputError(joinText("nodes: unknown set ", inQuotes(name), "; ",
                              known.empty() ? std::string("the mesh has none")
                                            : joinText(didYouMean(name, known), "known are ", shortList(known))));
  }
  const py::object given = listAsArray(listed);
  const Eigen::Index nodes = mesh.nodeCount();
  using Flags = py::array_t<bool, py::array::c_style>;
  if (!py::isinstance<Flags>(given)) return indicesOf("nodes", given, 1, nodes);
  const auto flags = py::reinterpret_borrow<Flags>(given);
  if (flags.ndim() != 1 || flags.size() != nodes)
    throw InputError(joinText("nodes: ", describe(given), "; must be a flag for each node, of shape ",
                              shapeText({nodes}), ", an array or a list of node numbers, or the name of a set"));
  std::vector<std::int32_t> chosen;
  for (py::ssize_t i = 0; i < flags.size(); ++i)
    if (flags.data()[i]) chosen.push_back(i);
  return chosen;
}

using Vector = std::array<double, 3>;
void requireFinite(const char* name, const Vector& vector, const char* unit) {
  for (const double part : vector)
    if (!std::isfinite(part)) throw InputError(joinText(name, ": ", part, " ", unit, ": must be finite"));
}

void fix(HeldBody& held, py::handle nodes, const std::string& components, const Vector& v) {
  const std::vector<std::int32_t> chosen = nodesOf(nodes, held.body.mesh());
  const std::array<bool, 3> fixed = componentsOf(components);
  requireFinite("velocity", v, "m/s");
  changing(held, [&] {
    for (const std::int32_t node : chosen)
      for (int c = 0; c < 3; ++c)
        if (fixed[c]) held.body.constraints().move(node, c, v[c]);
  });
}

py::array force(HeldBody& held, py::handle positions) {
  const NodeVectorsView x = nodalOf("x", positions, held.body.nodeCount());
  NodeVectors result = reading(held, [&] {
    NodeVectors f;
    BorrowedWorkspace workspace(held);
    held.body.internalForce(x, f, *workspace);
    return f;
  });
  return ownedArray(std::move(result));
}

py::array tangentProduct(HeldBody& held, py::handle positions, py::handle direction) {
  const NodeVectorsView x = nodalOf("x", positions, held.body.nodeCount()),
                        v = nodalOf("v", direction, held.body.nodeCount());
  NodeVectors result = reading(held, [&] {
    NodeVectors Kv;
    BorrowedWorkspace workspace(held);
    held.body.tangentProduct(x, v, Kv, *workspace);
    return Kv;
  });
  return ownedArray(std::move(result));
}

double energy(HeldBody& held, py::handle positions) {
  const NodeVectorsView x = nodalOf("x", positions, held.body.nodeCount());
  return reading(held, [&] {
    BorrowedWorkspace workspace(held);
    return held.body.energy(x, *workspace);
  });
}

/// The tangents of all elements of a block, 3n×3n each.
py::array elementTangents(HeldBody& held, py::handle positions, std::int64_t number) {
  const Body& body = held.body;
  const NodeVectorsView x = nodalOf("x", positions, body.nodeCount());
  const std::int64_t blocks = body.blocks().size();
  if (number < 0 || number >= blocks) throw InputError(joinText("block = ", number, ": must be 0 to ", blocks - 1));
  const MeshBlock& block = body.mesh().blocks[number];
  const std::size_t elements = block.elementCount(), size = 3 * static_cast<std::size_t>(block.nodesPerElement());
  std::vector<double> tangents(elements * size * size);
  reading(held, [&] {
    parallelFor(0, elements, body.threads(), [&](std::int64_t e) {
      const Eigen::MatrixXd K = body.elementTangent({number, e}, x);
      std::copy_n(K.data(), size * size, tangents.data() + static_cast<std::size_t>(e) * size * size);
    });
  });
  const auto side = static_cast<py::ssize_t>(size);
  return ownedArray(std::move(tangents), {static_cast<py::ssize_t>(elements), side, side});
}

void addBodyForce(HeldBody& held, const Vector& a) {
  requireFinite("acceleration", a, "m/s2");
  changing(held, [&] { held.body.addBodyForce(Eigen::Vector3d::Map(a.data())); });
}

}  // namespace

void bindBody(py::module_& module) {
  bindClass<py::class_<Material>>(
      module, "Material", py::init(&materialOf),
      "A constitutive law and a density (kg/m3): Material(\"stvk\", young=30e3, poisson=0.3, density=1000).\n\n"
      "The other keywords are the law's own parameters; `ringwatch help laws` lists them. Raises InputError for an\n"
      "unknown law or parameter and for a value out of range.",
      "**parameters", py::arg("model"), py::pos_only(), py::kw_only(), py::arg("density"))
      .def_property_readonly("model", [](const Material& self) { return std::string(self.lawName()); })
      .def_readonly("density", &Material::density, "kg/m3")
      .def_property_readonly("wave_speed", &Material::waveSpeed, "Of a pressure wave at rest, m/s.")
      .def("__repr__", [](const Material& self) {
        return labelled(joinText("<Material ", self.lawName(), ": ", self.density, " kg/m3, pressure wave ",
                                 self.waveSpeed(), " m/s>"));
      });

  auto body = bindClass<py::class_<HeldBody, std::shared_ptr<HeldBody>>>(
      module, "Body", py::init(&bodyOf),
      "A mesh made computable by a material: masses, forces, energies, tangents, supports.\n\n"
      "material: one, or a list of one for each block. lumping: row-sum, equal or diagonal-scaling. rules: quadrature\n"
      "rule by element name. threads: 0 for all; results do not depend on it. Several threads of Python may use a "
      "body\n"
      "at once. Raises InputError; NumericalError for an element without volume or mass.",
      "", py::arg("mesh"), py::arg("material"), py::kw_only(), py::arg("lumping") = "row-sum",
      py::arg("rules") = ElementRules(), py::arg("threads") = 0);
  body.def("__repr__",
           [](const HeldBody& self) {
             return labelled(joinText("<Body: ", meshText(self.body.mesh()), ", ", self.body.totalMass(), " kg>"));
           })
      .def_property_readonly("node_count", [](const HeldBody& self) { return self.body.nodeCount(); })
      .def_property_readonly("element_count", [](const HeldBody& self) { return self.body.mesh().elementCount(); })
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const NodeVectors& X = self.cast<const HeldBody&>().body.mesh().X;
            return viewOf(X.data(), {static_cast<py::ssize_t>(X.cols()), py::ssize_t{3}}, self);
          },
          "Positions at rest, (N, 3), m: a view that cannot be written.")
      .def_property_readonly(
          "lumped_mass",
          [](const py::object& self) {
            const Eigen::VectorXd& mass = self.cast<const HeldBody&>().body.lumpedMass();
            return viewOf(mass.data(), {static_cast<py::ssize_t>(mass.size())}, self);
          },
          "The mass of each node, (N,), kg: a view that cannot be written.")
      .def_property_readonly(
          "total_mass", [](const HeldBody& self) { return self.body.totalMass(); }, "kg")
      .def_property_readonly(
          "volume", [](const HeldBody& self) { return self.body.volume(); }, "At rest, m3.")
      .def_property_readonly(
          "external_force", [](HeldBody& self) { return ownedArray(NodeVectors(self.body.externalForce())); },
          "Dead nodal forces, (N, 3), N: a copy.");
  bindMethod(body, "add_body_force", &addBodyForce,
             "Adds mass times acceleration (three numbers, m/s2) to the external forces.", py::arg("acceleration"));
  bindMethod(body, "fix", &fix,
             "Takes components of nodes out of the stability problem: held, or moved at a velocity (m/s).\n\n"
             "nodes: the name of a node set of the mesh, their numbers, or a flag for each node, such as\n"
             "points[:, 0] < 1e-6. components: some of x, y, z. Raises InputError.",
             py::arg("nodes"), py::arg("components") = "xyz", py::kw_only(), py::arg("velocity") = Vector{0, 0, 0});
  bindMethod(body, "internal_force", &force,
             "The derivative of the strain energy by the positions x, (N, 3), N. x: (N, 3), m, read where it lies.",
             py::arg("x"));
  bindMethod(body, "tangent_product", &tangentProduct,
             "K(x) v with the exact tangent K, (N, 3), N. x, v: (N, 3), m, read where they lie.", py::arg("x"),
             py::arg("v"));
  bindMethod(body, "energy", &energy, "The strain energy at positions x, J. x: (N, 3), m, read where it lies.",
             py::arg("x"));
  bindMethod(body, "element_tangents", &elementTangents,
             "The exact tangents of all elements of a block, (elements, 3 n, 3 n), N/m, as TangentBracket takes them.",
             py::arg("x"), py::arg("block") = 0);
}

}  // namespace ringwatch::python
