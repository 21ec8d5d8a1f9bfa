#include <algorithm>
#include <charconv>
#include <string_view>

#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/markup.h>
#include <ringwatch/base/output_file.h>
#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/formats/vtu_writer.h>

// The only file that knows VTK, so that everything else builds without it.
#ifdef RINGWATCH_WITH_VTK
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataCompressor.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
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
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtkZLibDataCompressor.h>
#endif

namespace ringwatch {

namespace {

constexpr std::string_view setPrefix = "set:";

/// VTK writes names into its XML as they are.
bool isForbiddenInNames(char c) { return (c >= 0 && c < ' ') || c == '"' || c == '<' || c == '>' || c == '&'; }

/// The name of a set in a frame, which must not fail for it.
std::string frameNameOfSet(std::string name) {
  std::replace_if(name.begin(), name.end(), isForbiddenInNames, '_');
  return name;
}

}  // namespace

void writePvd(const std::filesystem::path& path, std::span<const PvdEntry> entries) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  "
      "<Collection>\n";
  for (const PvdEntry& entry : entries) {
    char time[40];
    text += "    <DataSet timestep=\"";
    text.append(time, std::to_chars(time, time + sizeof time, entry.time).ptr);
    text += "\" part=\"0\" file=\"" + markupText(entry.file.generic_string()) + "\"/>\n";
  }
  writeFileAtomically(path, text + "  </Collection>\n</VTKFile>\n");
}

void writePvtu(const std::filesystem::path& path, const Mesh& mesh, std::span<const VtuField> pointFields,
               std::span<const VtuField> cellFields, std::span<const std::filesystem::path> pieces) {
  const auto array = [](std::string_view type, const std::string& name, int components) {
    return joinText("      <PDataArray type=\"", type, "\" Name=\"", markupText(name), "\" NumberOfComponents=\"",
                    components, "\"/>\n");
  };
  const auto arrays = [&](std::span<const VtuField> fields) {
    constexpr std::string_view types[]{"Float64", "Int32", "Int64"};  // in the order of VtuField::values
    std::string text;
    for (const VtuField& field : fields) text += array(types[field.values.index()], field.name, field.components);
    return text;
  };
  const auto setArrays = [&](const auto& sets) {
    std::string text;
    for (const auto& [name, members] : sets) text += array("Int8", std::string(setPrefix) + frameNameOfSet(name), 1);
    return text;
  };
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n  "
      "<PUnstructuredGrid GhostLevel=\"0\">\n    <PPointData>\n" +
      arrays(pointFields) + setArrays(mesh.nodeSets) + array("Int64", "originalNodeId", 1) +
      "    </PPointData>\n    <PCellData>\n" + arrays(cellFields) + setArrays(mesh.elementSets) +
      array("Int64", "originalElementId", 1) + "    </PCellData>\n    <PPoints>\n" + array("Float64", "Points", 3) +
      "    </PPoints>\n";
  for (const std::filesystem::path& piece : pieces)
    text += "    <Piece Source=\"" + markupText(piece.generic_string()) + "\"/>\n";
  writeFileAtomically(path, text + "  </PUnstructuredGrid>\n</VTKFile>\n");
}

#ifndef RINGWATCH_WITH_VTK

namespace {
constexpr const char* howToGetVtk =
    "this build is without VTK; install it (Debian: libvtk9-dev) and configure with -DRINGWATCH_WITH_VTK=ON";
}
namespace detail {
// Of the readers (mesh_readers.h): it is here since this file alone sees VTK. A program without VTK may bring its own.
[[gnu::weak]] bool unpack(const std::string& source, const std::string&, const char*, std::size_t, char*, std::size_t) {
  throw InputError(source + ": the data are packed: " + howToGetVtk);
}
void writeVtuWithSets(const Mesh&, const std::filesystem::path& path) {
  throw InputError("cannot write " + path.string() + ": " + howToGetVtk);
}
}  // namespace detail
void writeVtu(const std::filesystem::path& path, const Mesh&, const NodeVectors&, std::span<const VtuField>,
              std::span<const VtuField>, std::optional<double>, std::span<const VtuField>) {
  throw InputError("cannot write " + path.string() + ": " + howToGetVtk);
}

#else

namespace {

/// Catches what VTK would print. VTK has one output window for the whole program, so there is a lock.
class CaptureWindow : public vtkOutputWindow {
 public:
  static CaptureWindow* New();
  vtkTypeMacro(CaptureWindow, vtkOutputWindow)

      void DisplayText(const char* text) override {
    keep(text);
  }
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
  VtkSession()
      : lock_(mutex()), previous_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
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

vtkSmartPointer<vtkUnstructuredGrid> makeGrid(const Mesh& mesh, const NodeVectors& x) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(x.cols());
  if (x.size() > 0)
    std::memcpy(coordinates->GetPointer(0), x.data(), sizeof(double) * static_cast<std::size_t>(x.size()));
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
    if (info.vtkCellType == 0) throw InputError(joinText("cannot write .vtu: VTK has no cell like ", info.name));
    const bool wedge =
        detail::vtkCell(info.vtkCellType, static_cast<std::size_t>(info.nodes)).order == detail::NodeOrder::vtkWedge;
    for (std::size_t e = 0; e < block.elementCount(); ++e, ++cell) {
      offsets->SetValue(cell, entry);
      types->SetValue(cell, static_cast<unsigned char>(info.vtkCellType));
      for (std::size_t a = 0; a < static_cast<std::size_t>(info.nodes); ++a)
        connectivity->SetValue(entry++, block.element(e)[wedge ? detail::vtkWedgeOrder[a] : a]);
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

void checkName(const std::string& name, const std::string& failure) {
  if (name.empty() || std::any_of(name.begin(), name.end(), isForbiddenInNames))
    throw InputError(failure + "the name " + detail::quoted(name) +
                     " must be without quotes, <, > and &, and not empty");
}

void addFields(vtkFieldData* target, std::span<const VtuField> fields, std::size_t count, const std::string& failure) {
  for (const VtuField& field : fields) {
    checkName(field.name, failure);
    std::visit(
        [&](auto values) {
          if (field.components < 1 || values.size() != count * static_cast<std::size_t>(field.components))
            throw InputError(joinText(failure, "field ", detail::quoted(field.name), " has ", values.size(),
                                      " values; ", count * static_cast<std::size_t>(std::max(1, field.components)),
                                      " are needed"));
          using T = std::remove_const_t<typename decltype(values)::element_type>;
          if constexpr (std::is_same_v<T, double>)
            addArray<vtkDoubleArray>(target, field.name, field.components, values);
          else if constexpr (std::is_same_v<T, std::int32_t>)
            addArray<vtkTypeInt32Array>(target, field.name, field.components, values);
          else
            addArray<vtkTypeInt64Array>(target, field.name, field.components, values);
        },
        field.values);
  }
}

/// Arrays set:NAME of 0 and 1; nameOf(name) is the name as it is written.
template <class NameOf>
void addSets(vtkUnstructuredGrid* grid, const Mesh& mesh, const NameOf& nameOf) {
  const auto add = [&](vtkFieldData* target, const std::string& name, const std::vector<signed char>& flags) {
    addArray<vtkTypeInt8Array>(target, std::string(setPrefix) + nameOf(name), 1, std::span<const signed char>(flags));
  };
  for (const auto& [name, nodes] : mesh.nodeSets) {
    std::vector<signed char> flags(mesh.nodeCount());
    for (const std::int32_t n : nodes) flags.at(n) = 1;
    add(grid->GetPointData(), name, flags);
  }
  std::vector<std::size_t> first{0};
  for (const MeshBlock& block : mesh.blocks) first.push_back(first.back() + block.elementCount());
  for (const auto& [name, elements] : mesh.elementSets) {
    std::vector<signed char> flags(mesh.elementCount());
    for (const ElementRef& ref : elements) flags.at(first.at(ref.block) + static_cast<std::size_t>(ref.element)) = 1;
    add(grid->GetCellData(), name, flags);
  }
}

void writeGrid(vtkUnstructuredGrid* grid, const Mesh& mesh, const std::filesystem::path& path) {
  std::vector<std::int64_t> nodeIds, ids;
  for (std::size_t i = 0; i < mesh.nodeCount(); ++i) nodeIds.push_back(mesh.nodeId(i));
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e) ids.push_back(block.id(e));
  addArray<vtkTypeInt64Array>(grid->GetPointData(), "originalNodeId", 1, std::span<const std::int64_t>(nodeIds));
  addArray<vtkTypeInt64Array>(grid->GetCellData(), "originalElementId", 1, std::span<const std::int64_t>(ids));
  // Into memory first: VTK looks neither at what fails when it closes a file nor keeps why.
  std::string text;
  {
    const VtkSession session;
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetWriteToOutputString(1);
    writer->SetInputData(grid);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();  // LZ4 takes a third of the time, but not every reader knows it
    if (writer->Write() == 0 || session.window->failed)
      throw InputError("cannot write " + path.string() + ": " + session.window->first);
    text = writer->GetOutputString();
  }
  writeFileAtomically(path, [&](const std::filesystem::path& temporary) {
    OutputFile file(temporary, OutputFile::Mode::empty, path.string());
    file.write(text);
    file.close();
  });
}

}  // namespace

void writeVtu(const std::filesystem::path& path, const Mesh& mesh, const NodeVectors& x,
              std::span<const VtuField> pointFields, std::span<const VtuField> cellFields, std::optional<double> time,
              std::span<const VtuField> frameFields) {
  const std::string failure = "cannot write " + path.string() + ": ";
  if (x.cols() != mesh.X.cols())
    throw InputError(joinText(failure, x.cols(), " positions; ", mesh.nodeCount(), " are needed"));
  const auto grid = makeGrid(mesh, x);
  addFields(grid->GetPointData(), pointFields, mesh.nodeCount(), failure);
  addFields(grid->GetCellData(), cellFields, mesh.elementCount(), failure);
  addSets(grid, mesh, frameNameOfSet);
  if (time) addArray<vtkDoubleArray>(grid->GetFieldData(), "TimeValue", 1, std::span<const double>(&*time, 1));
  for (const VtuField& field : frameFields) {
    const std::size_t values = std::visit([](auto list) { return list.size(); }, field.values);
    addFields(grid->GetFieldData(), std::span(&field, 1), values / static_cast<std::size_t>(field.components), failure);
  }
  writeGrid(grid, mesh, path);
}

namespace detail {

void writeVtuWithSets(const Mesh& mesh, const std::filesystem::path& path) {
  const auto grid = makeGrid(mesh, mesh.X);
  addSets(grid, mesh, [&](std::string name) {
    checkName(name, "cannot write " + path.string() + ": ");
    return name;
  });
  writeGrid(grid, mesh, path);
}

bool unpack(const std::string& source, const std::string& compressor, const char* in, std::size_t inSize, char* out,
            std::size_t outSize) {
  const VtkSession session;  // VTK reports data that do not unpack through its window
  vtkSmartPointer<vtkDataCompressor> unpacker;
  if (compressor == "vtkZLibDataCompressor") unpacker = vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (compressor == "vtkLZ4DataCompressor") unpacker = vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (compressor == "vtkLZMADataCompressor") unpacker = vtkSmartPointer<vtkLZMADataCompressor>::New();
  if (unpacker == nullptr)
    throw InputError(source + ": the compressor is " + detail::quoted(compressor) +
                     "; it must be vtkZLibDataCompressor, vtkLZ4DataCompressor or vtkLZMADataCompressor");
  const auto* packed = reinterpret_cast<const unsigned char*>(in);
  return unpacker->Uncompress(packed, inSize, reinterpret_cast<unsigned char*>(out), outSize) == outSize &&
         !session.window->failed;
}

}  // namespace detail
#endif

}  // namespace ringwatch
