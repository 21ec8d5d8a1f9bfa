#include <charconv>

#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/meshes/file_cursor.h>
#include <ringwatch/meshes/mesh_builder.h>
#include <ringwatch/meshes/mesh_readers.h>
#include <ringwatch/meshes/vtu_writer.h>

// The only file that knows VTK, so that everything else builds without it.
#ifdef RINGWATCH_WITH_VTK
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeInt8Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>
#endif

namespace ringwatch {

void writePvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    char time[40];
    text += "    <DataSet timestep=\"";
    text.append(time, std::to_chars(time, time + sizeof time, entry.time).ptr);
    text += "\" part=\"0\" file=\"";
    for (const char c : entry.file.generic_string()) {
      switch (c) {
        case '&': text += "&amp;"; break;
        case '<': text += "&lt;"; break;
        case '>': text += "&gt;"; break;
        case '"': text += "&quot;"; break;
        default: text += c;
      }
    }
    text += "\"/>\n";
  }
  writeFileAtomically(path, text + "  </Collection>\n</VTKFile>\n");
}

#ifndef RINGWATCH_WITH_VTK

namespace {
constexpr const char* howToGetVtk =
    "this build is without VTK; install it (Debian: libvtk9-dev) and configure with -DRINGWATCH_WITH_VTK=ON";
}
namespace detail {
Mesh readVtu(const std::filesystem::path& path, const std::string&, Notes*, Problems*) {
  throw InputError(path.string() + ": cannot read: " + howToGetVtk);
}
void writeVtuWithSets(const Mesh&, const std::filesystem::path& path) {
  throw InputError("cannot write " + path.string() + ": " + howToGetVtk);
}
}  // namespace detail
void writeVtu(const std::filesystem::path& path, const Mesh&, const NodeVectors&, std::span<const VtuField>,
              std::span<const VtuField>, std::optional<double>) {
  throw InputError("cannot write " + path.string() + ": " + howToGetVtk);
}

#else

namespace {

constexpr std::string_view setPrefix = "set:";

/// Catches what VTK would print. VTK has one output window for the whole program, hence the lock.
class CaptureWindow : public vtkOutputWindow {
 public:
  static CaptureWindow* New();
  vtkTypeMacro(CaptureWindow, vtkOutputWindow)

  void DisplayText(const char* text) override { keep(text); }
  void DisplayErrorText(const char* text) override {
    failed = true;
    keep(text);
  }
  void DisplayWarningText(const char* text) override { keep(text); }
  void DisplayGenericWarningText(const char* text) override { keep(text); }
  bool failed = false;
  std::string first;

 private:
  void keep(const char* text) {
    if (!first.empty() || text == nullptr) return;
    // "ERROR: In file, line n\nvtkClass (0x…): what\n\n": only the last part says something to a user.
    std::string_view all(text);
    if (const auto mark = all.find("): "); mark != std::string_view::npos) all.remove_prefix(mark + 3);
    for (const char c : all) first += c >= ' ' && c <= '~' ? c : ' ';
    while (!first.empty() && first.back() == ' ') first.pop_back();
  }
};
// What vtkStandardNewMacro makes, without its stray semicolon, which -Wpedantic refuses.
CaptureWindow* CaptureWindow::New() {
  auto* made = new CaptureWindow;
  made->InitializeObjectBase();
  return made;
}

class VtkSession {
 public:
  VtkSession() : lock_(mutex()), previous_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkOutputWindow::SetInstance(window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~VtkSession() {
    vtkLogger::SetStderrVerbosity(verbosity_);
    vtkOutputWindow::SetInstance(previous_);
  }
  VtkSession(const VtkSession&) = delete;
  VtkSession& operator=(const VtkSession&) = delete;
  vtkNew<CaptureWindow> window;

 private:
  static std::mutex& mutex() {
    static std::mutex m;
    return m;
  }
  std::lock_guard<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> previous_;
  vtkLogger::Verbosity verbosity_;
};

/// VTK allocates what a header announces. So the counts are compared with the size of the file first.
void checkXmlCounts(const std::filesystem::path& path, const std::string& text) {
  const std::string name = path.string();
  std::string_view trimmed(text);
  while (!trimmed.empty() && std::strchr(" \t\r\n", trimmed.back()) != nullptr) trimmed.remove_suffix(1);
  if (!trimmed.ends_with("</VTKFile>")) throw InputError(name + ": the file does not end with </VTKFile>; is it cut short?");
  if (text.find("type=\"UnstructuredGrid\"") == std::string::npos) throw InputError(name + ": only type=\"UnstructuredGrid\" is supported");
  // Deflate packs at most about 1032:1.
  for (const std::string_view key : {"NumberOfPoints=\"", "NumberOfCells=\"", "NumberOfTuples=\"", "NumberOfComponents=\""})
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
      const char* begin = text.data() + at + key.size();
      std::int64_t value = 0;
      const auto [stop, error] = std::from_chars(begin, text.data() + text.size(), value);
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      if (error != std::errc() || *stop != '"' || value < 0 || static_cast<std::uint64_t>(value) > text.size() * 1100)
        throw InputError(joinText(name, ":", line, ": ", key.substr(0, key.size() - 2), " is ",
                                  detail::quoted(std::string_view(begin, std::min<std::size_t>(20, text.size() - at - key.size()))
                                                     .substr(0, std::string_view(begin, std::min<std::size_t>(20, text.size() - at - key.size())).find('"'))),
                                  "; it must be a count that the file can hold"));
    }
}

vtkSmartPointer<vtkUnstructuredGrid> makeGrid(const Mesh& mesh, const NodeVectors& x) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(x.cols());
  if (x.size() > 0) std::memcpy(coordinates->GetPointer(0), x.data(), sizeof(double) * static_cast<std::size_t>(x.size()));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(coordinates);
  grid->SetPoints(points);
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  vtkNew<vtkUnsignedCharArray> types;
  std::size_t entries = 0;
  for (const MeshBlock& block : mesh.blocks) entries += block.connectivity.size();
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(entries));
  offsets->SetNumberOfValues(static_cast<vtkIdType>(mesh.elementCount()) + 1);
  types->SetNumberOfValues(static_cast<vtkIdType>(mesh.elementCount()));
  vtkIdType cell = 0, entry = 0;
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    for (std::size_t e = 0; e < block.elementCount(); ++e, ++cell) {
      offsets->SetValue(cell, entry);
      types->SetValue(cell, static_cast<unsigned char>(info.vtkCellType));
      for (int a = 0; a < info.nodes; ++a) connectivity->SetValue(entry++, block.element(e)[a]);
    }
  }
  offsets->SetValue(cell, entry);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  grid->SetCells(types, cells);
  return grid;
}

template <class Array, class T>
void addArray(vtkFieldData* target, const std::string& name, int components, std::span<const T> values) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / static_cast<std::size_t>(components)));
  if (!values.empty()) std::memcpy(array->GetVoidPointer(0), values.data(), values.size_bytes());
  target->AddArray(array);
}

void addFields(vtkFieldData* target, std::span<const VtuField> fields, std::size_t count, const std::string& failure) {
  for (const VtuField& field : fields)
    std::visit(
        [&](auto values) {
          if (field.components < 1 || values.size() != count * static_cast<std::size_t>(field.components))
            throw InputError(joinText(failure, "field ", detail::quoted(field.name), " has ", values.size(), " values; ",
                                      count * static_cast<std::size_t>(std::max(1, field.components)), " are needed"));
          using T = std::remove_const_t<typename decltype(values)::element_type>;
          if constexpr (std::is_same_v<T, double>) addArray<vtkDoubleArray>(target, field.name, field.components, values);
          else if constexpr (std::is_same_v<T, std::int32_t>) addArray<vtkTypeInt32Array>(target, field.name, field.components, values);
          else addArray<vtkTypeInt64Array>(target, field.name, field.components, values);
        },
        field.values);
}

void writeGrid(vtkUnstructuredGrid* grid, const Mesh& mesh, const std::filesystem::path& path) {
  addArray<vtkTypeInt64Array>(grid->GetPointData(), "originalNodeId", 1, std::span<const std::int64_t>(mesh.nodeIds));
  std::vector<std::int64_t> ids;
  for (const MeshBlock& block : mesh.blocks) ids.insert(ids.end(), block.ids.begin(), block.ids.end());
  addArray<vtkTypeInt64Array>(grid->GetCellData(), "originalElementId", 1, std::span<const std::int64_t>(ids));
  writeFileAtomically(path, [&](const std::filesystem::path& temporary) {
    const VtkSession session;
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName(temporary.c_str());
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    if (writer->Write() == 0 || writer->GetErrorCode() != 0 || session.window->failed || !std::filesystem::exists(temporary))
      throw InputError("cannot write " + path.string() + ": " + (session.window->first.empty() ? "input/output error" : session.window->first));
  });
}

}  // namespace

void writeVtu(const std::filesystem::path& path, const Mesh& mesh, const NodeVectors& x, std::span<const VtuField> pointFields,
              std::span<const VtuField> cellFields, std::optional<double> time) {
  const std::string failure = "cannot write " + path.string() + ": ";
  if (x.cols() != mesh.X.cols()) throw InputError(joinText(failure, x.cols(), " positions; ", mesh.nodeCount(), " are needed"));
  const auto grid = makeGrid(mesh, x);
  addFields(grid->GetPointData(), pointFields, mesh.nodeCount(), failure);
  addFields(grid->GetCellData(), cellFields, mesh.elementCount(), failure);
  if (time) addArray<vtkDoubleArray>(grid->GetFieldData(), "TimeValue", 1, std::span<const double>(&*time, 1));
  writeGrid(grid, mesh, path);
}

namespace detail {

void writeVtuWithSets(const Mesh& mesh, const std::filesystem::path& path) {
  const auto grid = makeGrid(mesh, mesh.X);
  const auto addSet = [](vtkFieldData* target, const std::string& name, const std::vector<signed char>& flags) {
    addArray<vtkTypeInt8Array>(target, std::string(setPrefix) + name, 1, std::span<const signed char>(flags));
  };
  for (const auto& [name, nodes] : mesh.nodeSets) {
    std::vector<signed char> flags(mesh.nodeCount());
    for (const std::int32_t n : nodes) flags.at(static_cast<std::size_t>(n)) = 1;
    addSet(grid->GetPointData(), name, flags);
  }
  std::vector<std::size_t> first{0};
  for (const MeshBlock& block : mesh.blocks) first.push_back(first.back() + block.elementCount());
  for (const auto& [name, elements] : mesh.elementSets) {
    std::vector<signed char> flags(mesh.elementCount());
    for (const ElementRef& ref : elements) flags.at(first.at(static_cast<std::size_t>(ref.block)) + static_cast<std::size_t>(ref.element)) = 1;
    addSet(grid->GetCellData(), name, flags);
  }
  writeGrid(grid, mesh, path);
}

Mesh readVtu(const std::filesystem::path& path, const std::string& text, Notes* notes, Problems* problems) {
  const std::string name = path.string();
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  checkXmlCounts(path, text);
  try {
    const VtkSession session;
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    grid = reader->GetOutput();
    if (reader->GetErrorCode() != 0) session.window->failed = true;
    if (session.window->failed || !session.window->first.empty() || grid == nullptr)
      throw InputError(name + ": VTK cannot read it: " + (session.window->first.empty() ? "the data are corrupt" : session.window->first));
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& reason) {  // std::bad_alloc, std::length_error on corrupt counts
    throw InputError(name + ": VTK cannot read it: " + reason.what());
  }
  const vtkIdType pointCount = grid->GetNumberOfPoints(), cellCount = grid->GetNumberOfCells();
  if (pointCount == 0 || grid->GetPoints() == nullptr) throw InputError(name + ": there are no points; is the file cut short?");
  vtkCellArray* cells = grid->GetCells();
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (cellCount == 0 || cells == nullptr || types == nullptr) throw InputError(name + ": there are no cells; is the file cut short?");
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  vtkDataArray* offsets = cells->GetOffsetsArray();
  if (types->GetNumberOfValues() != cellCount || offsets->GetNumberOfTuples() != cellCount + 1)
    throw InputError(joinText(name, ": ", types->GetNumberOfValues(), " cell types and ", offsets->GetNumberOfTuples(), " offsets for ", cellCount, " cells"));
  const auto integerAt = [](vtkDataArray* array, vtkIdType i) -> std::int64_t {
    if (auto* wide = vtkTypeInt64Array::SafeDownCast(array)) return wide->GetValue(i);
    if (auto* narrow = vtkTypeInt32Array::SafeDownCast(array)) return narrow->GetValue(i);
    const double value = array->GetComponent(i, 0);
    return std::abs(value) < 9e15 ? static_cast<std::int64_t>(value) : -1;
  };
  const auto idArray = [](vtkFieldData* data, const char* arrayName, vtkIdType count) -> vtkDataArray* {
    vtkDataArray* array = data->GetArray(arrayName);
    return array != nullptr && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == count ? array : nullptr;
  };
  vtkDataArray* nodeIds = idArray(grid->GetPointData(), "originalNodeId", pointCount);
  vtkDataArray* elementIds = idArray(grid->GetCellData(), "originalElementId", cellCount);

  MeshBuilder builder(name, [&](std::size_t p) { return joinText(name, ": point ", p); },
                      [&](std::size_t p) { return joinText(name, ": cell ", p); });
  for (vtkIdType n = 0; n < pointCount; ++n) {
    double p[3];
    grid->GetPoints()->GetPoint(n, p);
    builder.addNode(n, p[0], p[1], p[2], static_cast<std::size_t>(n));
  }
  // Sets that an element belongs to, as one group a combination.
  std::vector<std::pair<std::string, vtkDataArray*>> elementSets;
  const auto setArrays = [&](vtkFieldData* data, vtkIdType count, auto visit) {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
      vtkDataArray* array = data->GetArray(i);
      if (array == nullptr || array->GetName() == nullptr) continue;
      const std::string_view arrayName = array->GetName();
      if (arrayName.substr(0, setPrefix.size()) == setPrefix && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == count)
        visit(std::string(arrayName.substr(setPrefix.size())), array);
    }
  };
  setArrays(grid->GetCellData(), cellCount, [&](const std::string& set, vtkDataArray* array) { elementSets.emplace_back(set, array); });
  setArrays(grid->GetPointData(), pointCount, [&](const std::string& set, vtkDataArray* array) {
    for (vtkIdType n = 0; n < pointCount; ++n)
      if (array->GetComponent(n, 0) != 0) builder.addToNodeSet(set, n);
  });
  std::map<std::vector<std::string>, int> groups;
  std::int64_t nodes[125];
  std::size_t flat = 0;
  const std::int64_t entries = connectivity->GetNumberOfTuples();
  for (vtkIdType c = 0; c < cellCount; ++c) {
    const int type = types->GetValue(c);
    const std::int64_t begin = integerAt(offsets, c), end = integerAt(offsets, c + 1);
    if (begin < 0 || end < begin || end > entries)
      throw InputError(joinText(name, ": cell ", c, " spans entries ", begin, " to ", end, " of the connectivity, which has ", entries));
    const FileElement* known = findVtkElement(type);
    if (known == nullptr && detail::isVtkVolumeCell(type))
      throw InputError(joinText(name, ": cell ", c, " is of VTK type ", type, ", which is not supported; tetrahedra (10) and hexahedra (12) are"));
    if (known == nullptr || known->dimension < 3) {
      ++flat;
      continue;
    }
    if (end - begin != known->nodes)
      throw InputError(joinText(name, ": cell ", c, " (", known->name, ") has ", end - begin, " nodes; it must have ", known->nodes));
    for (std::int64_t i = begin; i < end; ++i) nodes[i - begin] = integerAt(connectivity, i);
    int group = -1;
    if (!elementSets.empty()) {
      std::vector<std::string> member;
      for (const auto& [set, array] : elementSets)
        if (array->GetComponent(c, 0) != 0) member.push_back(set);
      if (!member.empty()) {
        const auto [found, isNew] = groups.try_emplace(member, 0);
        if (isNew) found->second = builder.addGroup(member);
        group = found->second;
      }
    }
    builder.addElement(*known, elementIds != nullptr ? integerAt(elementIds, c) : c, nodes, group, static_cast<std::size_t>(c), false);
  }
  if (flat > 0 && notes != nullptr) notes->push_back(joinText(name, ": ", flat, " cells of surfaces, lines or points are left out"));
  Mesh mesh = builder.finish(notes, problems);
  if (nodeIds != nullptr)
    for (vtkIdType n = 0; n < pointCount; ++n) mesh.nodeIds[static_cast<std::size_t>(n)] = integerAt(nodeIds, n);
  return mesh;
}

}  // namespace detail
#endif

}  // namespace ringwatch
