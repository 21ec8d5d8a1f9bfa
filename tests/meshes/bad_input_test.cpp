#include <gmock/gmock.h>

#include <bit>
#include <cstring>

#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string msh(const std::string& nodes, const std::string& elements) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes + "$EndNodes\n$Elements\n" + elements +
         "$EndElements\n";
}
const std::string goodNodes = "4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";  // lines 5 to 9
const std::string goodElements = "1\n1 4 0 1 2 3 4\n";                    // lines 12 and 13

struct Case {
  const char* name;
  std::string content;
  std::vector<std::string> said;  // what the message must hold
};

TEST(BadInput, EveryFaultOfAnMshFileIsNamedWithLineAndValue) {
  const std::string format41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  const std::vector<Case> cases{
      {"version", "$MeshFormat\n5.3 0 8\n$EndMeshFormat\n", {":2: ", "5.3", "4.1"}},
      {"data size", "$MeshFormat\n2.2 0 4\n$EndMeshFormat\n", {":2: ", "4", "8"}},
      {"file type", "$MeshFormat\n2.2 7 8\n$EndMeshFormat\n", {":2: ", "7"}},
      {"binary 4.0", "$MeshFormat\n4.0 1 8\n$EndMeshFormat\n", {":2: ", "4.1"}},
      {"byte order", std::string("$MeshFormat\n2.2 1 8\n\x05\0\0\0\n$EndMeshFormat\n", 40), {": byte ", "5"}},
      {"no format", "hello\n", {":1: ", "hello", "$MeshFormat"}},
      {"word for a number", msh("4\n1 0 0 0\n2 abc 0 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "abc", "number"}},
      {"number with tail", msh("4\n1 0 0 0\n2 1.0x 0 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "1.0x"}},
      {"overflow", msh("4\n1 0 0 0\n2 1e999 0 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "1e999"}},
      {"NaN",
       msh("4\n1 0 0 0\n2 1 0 0\n3 0 nan 0\n4 0 0 1\n", goodElements),
       {":8: ", "coordinate y of node 3", "nan", "finite"}},
      {"infinity", msh("4\n1 0 0 0\n2 inf 0 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "node 2", "inf"}},
      {"twice", msh("4\n1 0 0 0\n2 1 0 0\n2 0 1 0\n4 0 0 1\n", goodElements), {":8: ", "node 2", "second time"}},
      {"negative number", msh("4\n1 0 0 0\n-2 1 0 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "-2"}},
      {"negative count", msh("-4\n", goodElements), {":5: ", "-4", "0 or more"}},
      {"absurd count", msh("4000000000000\n1 0 0 0\n", goodElements), {":5: ", "4000000000000"}},
      {"count beyond integers", msh("99999999999999999999\n1 0 0 0\n", goodElements), {":5: ", "99999999999999999999"}},
      {"too few nodes", msh("5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":10: ", "EndNodes"}},
      {"too many nodes",
       msh("3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", goodElements),
       {":9: ", "4 0 0 1", "$EndNodes"}},
      {"short line", msh("4\n1 0 0 0\n2 1 0\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "line ends", "coordinate z"}},
      {"long line", msh("4\n1 0 0 0\n2 1 0 0 8\n3 0 1 0\n4 0 0 1\n", goodElements), {":7: ", "8"}},
      {"missing node", msh(goodNodes, "1\n5 4 0 1 2 3 77\n"), {":13: ", "element 5", "77"}},
      {"unknown type", msh(goodNodes, "1\n1 777 0 1 2 3 4\n"), {":13: ", "777"}},
      {"tags", msh(goodNodes, "1\n1 4 -1 1 2 3 4\n"), {":13: ", "-1"}},
      {"short element", msh(goodNodes, "1\n1 4 0 1 2 3\n"), {":13: ", "line ends"}},
      {"no volume", msh(goodNodes, "1\n1 2 0 1 2 3\n"), {"no volume elements"}},
      {"no elements",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + goodNodes + "$EndNodes\n",
       {"$Elements", "cut short"}},
      {"second nodes", msh(goodNodes, goodElements) + "$Nodes\n0\n$EndNodes\n", {":15: ", "second $Nodes"}},
      {"stray line", msh(goodNodes, goodElements) + "stray\n", {":15: ", "stray"}},
      {"unended section", msh(goodNodes, goodElements) + "$Comments\nwords\n", {":15: ", "$EndComments"}},
      {"physical name",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 solid\n$EndPhysicalNames\n",
       {":6: ", "solid", "quotes"}},
      {"wrong total of nodes", format41 + "$Nodes\n1 2 1 1\n3 1 0 1\n1\n0 0 0\n$EndNodes\n", {":5: ", "2", "1"}},
      {"wrong dimension",
       format41 +
           "$Nodes\n1 1 1 1\n3 1 0 1\n1\n0 0 0\n$EndNodes\n$Elements\n1 1 1 1\n2 1 4 1\n1 1 1 1 1\n$EndElements\n",
       {":12: ", "dimension 2", "tet4"}},
      {"absurd block",
       format41 + "$Nodes\n1 1 1 1\n3 1 0 888888888888\n1\n0 0 0\n$EndNodes\n",
       {":6: ", "888888888888"}},
      {"absurd entities", format41 + "$Entities\n0 0 0 777777777777\n$EndEntities\n", {":5: ", "777777777777"}},
  };
  const TemporaryFolder folder;
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    writeBytes(folder / "bad.msh", c.content);
    const std::string text = errorOf([&] { readMesh(folder / "bad.msh"); });
    EXPECT_THAT(text, HasSubstr("bad.msh:"));
    for (const std::string& part : c.said) EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(BadInput, ElementsThatTheLibraryDoesNotHaveAreCountedByType) {
  const TemporaryFolder folder;
  writeBytes(folder / "bad.msh", msh(
                                     goodNodes, "3\n1 4 0 1 2 3 4\n2 93 0" + [] {
                                       std::string nodes;
                                       for (int i = 0; i < 125; ++i) nodes += " 1";
                                       return nodes;
                                     }() + "\n3 29 0 1 2 3 4 1 2 3 4 1 2 3 4 1 2 3 4 1 2 3 4\n"));
  const std::string text = errorOf([&] { readMesh(folder / "bad.msh"); });
  for (const char* part : {":14: ", "1 of type hex125", "1 of type tet20", "supported are tet4"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(BadInput, TetgenFaults) {
  const std::string nodes = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", elements = "1 4 0\n1 1 2 3 4\n";
  const TemporaryFolder folder;
  const std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> cases{
      {"4 2 0 0\n", elements, {"t.node:1: ", "dimension is 2"}},
      {"5 3 0 0\n1 0 0 0\n2 1.5 0 0\n3 0 1 0\n4 0 0 1\n5 0 0\n", elements, {"t.node:6: ", "coordinate z"}},
      {"-1 3 0 0\n", elements, {"t.node:1: ", "-1"}},
      {"3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", elements, {"t.node:5: ", "more lines"}},
      {"4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n3 0 0 1\n", elements, {"t.node:5: ", "node 3", "second"}},
      {nodes, "1 10 0\n1 1 2 3 4 5 6 7 8 9 10\n", {"t.ele:1: ", "10", "4"}},
      {nodes, "1 4 0\n1 1 2 3 9\n", {"t.ele:2: ", "node 9"}},
      {nodes, "1 4 0\n1 1 2 3 four\n", {"t.ele:2: ", "four"}},
      {nodes, "2 4 0\n1 1 2 3 4\n# a comment\n", {"t.ele:4: ", "cut short"}},
      {nodes, "1 4 0\n1 1 2 3 4", {"t.ele:2: ", "line end"}},
      {nodes, "0 4 0\n", {"t.ele", "no volume elements"}},
  };
  for (const auto& [nodeText, elementText, said] : cases) {
    writeBytes(folder / "t.node", nodeText);
    writeBytes(folder / "t.ele", elementText);
    const std::string text = errorOf([&] { readMesh(folder / "t.ele"); });
    for (const std::string& part : said) EXPECT_THAT(text, HasSubstr(part));
  }
  std::filesystem::remove(folder / "t.ele");
  EXPECT_THAT(errorOf([&] { readMesh(folder / "t.node"); }), HasSubstr("t.ele: cannot read"));
}

TEST(BadInput, GmshOptionsThatHelpAreNamed) {
  const TemporaryFolder folder;
  const std::string begin = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
  writeBytes(folder / "surface.msh", begin + "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
  EXPECT_THAT(errorOf([&] { readMesh(folder / "surface.msh"); }),
              AllOf(HasSubstr("there are no volume elements, only 1 of"), HasSubstr("add a Physical Volume"),
                    HasSubstr("Mesh.SaveAll = 1")));
  constexpr int hex27 = 12;  // which ranks do not read
  const detail::FoundElements found[] = {{detail::findGmshElement(hex27), 1, 0}};
  const auto where = [](std::size_t) { return std::string("m"); };
  EXPECT_THAT(errorOf([&] { detail::requireVolumes(found, 27, "m", where, ""); }),
              AllOf(HasSubstr("1 of type hex27"), HasSubstr("gmsh writes hex20 in place of hex27 with "
                                                            "Mesh.SecondOrderIncomplete = 1")));
}

TEST(BadInput, EveryFormatIsNamedAndHasAReader) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.points", "points\n");
  const std::string unknown = errorOf([&] { readMesh(folder / "a.points"); });
  for (const MeshFormatInfo& format : allMeshFormats()) {
    const std::string extensions(format.extensions);
    EXPECT_THAT(unknown, HasSubstr(std::string(format.name) + " (" + extensions + ")"));
    EXPECT_THAT(readableExtensions(), HasSubstr(extensions));
    const std::string file = "a" + extensions.substr(0, extensions.find('/'));
    writeBytes(folder / file, "solid\n");
    EXPECT_THAT(errorOf([&] { readMesh(folder / file); }), Not(HasSubstr("not a known mesh format"))) << extensions;
    if (format.writes)
      EXPECT_NO_THROW(writeMesh(mixedMesh(), folder / ("b" + extensions))) << extensions;
    else
      EXPECT_THAT(errorOf([&] { writeMesh(mixedMesh(), folder / file); }), HasSubstr("use .msh or .vtu")) << extensions;
  }
  EXPECT_EQ(writableExtensions(), ".msh or .vtu");
}

TEST(BadInput, FilesThatCannotBeReadOrAreNoMesh) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorOf([&] { readMesh(folder / "none.msh"); }), HasSubstr("no such file"));
  EXPECT_THAT(errorOf([&] { readMesh(folder.path()); }), HasSubstr("folder"));
  writeBytes(folder / "empty.msh", "");
  EXPECT_THAT(errorOf([&] { readMesh(folder / "empty.msh"); }), HasSubstr("empty"));
  writeBytes(folder / "empty.msh", "  \n\r\n");
  EXPECT_THAT(errorOf([&] { readMesh(folder / "empty.msh"); }), HasSubstr("empty"));
  writeBytes(folder / "a.points", "points\x01 \xFF\n");
  EXPECT_THAT(errorOf([&] { readMesh(folder / "a.points"); }), HasSubstr("known are"));
  EXPECT_THAT(errorOf([&] { writeMesh(mixedMesh(), folder / "a.stl"); }), HasSubstr(".msh or .vtu"));
  EXPECT_THAT(errorOf([&] { writeMesh(mixedMesh(), folder / "nowhere" / "a.msh"); }), HasSubstr("no folder"));
  Mesh named = mixedMesh();
  named.nodeSets["a\"b"] = {0};
  EXPECT_THAT(errorOf([&] { writeMesh(named, folder / "q.msh"); }), HasSubstr("quote"));
}

// CR alone, CR LF, and a byte order mark, in every format of text.
TEST(BadInput, LineEndsOfOtherSystemsAreTaken) {
  const TemporaryFolder folder;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
                    keyword = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n";
  const std::vector<std::pair<std::string, std::string>> files{
      {"m.msh", msh(goodNodes, goodElements)},
      {"m.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n" + points +
                    "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"},
      {"m.inp", keyword + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n"},
      {"m.k",
       "$ a "
       "deck\n*KEYWORD\n*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,0.,1.,0.\n4,0.,0.,1.\n*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n"},
      {"m.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"}};
  int read = 0;
  for (const auto& [name, text] : files)
    for (const std::string end : {"\n", "\r", "\r\n"}) {
      SCOPED_TRACE(name + std::to_string(end.size()));
      const auto ending = [&](std::string whole) {
        for (std::size_t at = 0; (at = whole.find('\n', at)) != std::string::npos; at += end.size())
          whole.replace(at, 1, end);
        return "\xEF\xBB\xBF" + whole;
      };
      writeBytes(folder / "m.ele", ending("1 4 0\n1 1 2 3 4\n"));
      writeBytes(folder / name, ending(text));
      const Mesh mesh = loadMesh(folder / name);
      EXPECT_EQ(mesh.X, (NodeVectors(3, 4) << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished());
      EXPECT_EQ(mesh.blocks.at(0).connectivity, (std::vector<std::int32_t>{0, 1, 2, 3}));
      ++read;
    }
  EXPECT_EQ(read, 15);
}

using Parse = std::function<Mesh(const std::string& content)>;

/// A file cut anywhere is refused, unless nothing but white space is lost.
void cutEverywhere(const std::string& whole, const Parse& parse) {
  const std::size_t needed = whole.find_last_not_of(" \r\n") + 1;
  ASSERT_NO_THROW(parse(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    try {
      parse(whole.substr(0, size));
      EXPECT_GE(size, needed) << "cut to " << size << " of " << whole.size() << " bytes was taken";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
    }
  }
}

/// Bytes changed anywhere never crash; they are refused or give some mesh.
void changeEverywhere(const std::string& whole, const Parse& parse) {
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char c : {'\0', '9', '-', '\xFF', '\n'}) {
      std::string changed = whole;
      changed[at] = c;
      try {
        Mesh mesh = parse(changed);
        requireSound(mesh, "changed");
      } catch (const InputError& error) {
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
      }
    }
}

TEST(BadInput, CutOrChangedMshFilesNeverCrash) {
  const TemporaryFolder folder;
  const Parse parse = [](const std::string& content) { return detail::readMsh("m.msh", content, nullptr, nullptr); };
  for (const MeshFormat format :
       {MeshFormat::msh22, MeshFormat::msh22Binary, MeshFormat::msh41, MeshFormat::msh41Binary}) {
    SCOPED_TRACE(static_cast<int>(format));
    writeMesh(mixedMesh(), folder / "m.msh", format);
    const std::string whole = readBytes(folder / "m.msh");
    cutEverywhere(whole, parse);
    changeEverywhere(whole, parse);
  }
}

TEST(BadInput, CutOrChangedTetgenFilesNeverCrash) {
  const TemporaryFolder folder;
  const std::string nodes = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n", elements = "1 4 0\n1 1 2 3 4\n";
  for (const char* name : {"t.node", "t.ele"}) {
    writeBytes(folder / "t.node", nodes);
    writeBytes(folder / "t.ele", elements);
    const Parse parse = [&](const std::string& content) {
      writeBytes(folder / name, content);
      return readMesh(folder / "t.ele");
    };
    const std::string whole = name == std::string("t.node") ? nodes : elements;
    cutEverywhere(whole, parse);
    changeEverywhere(whole, parse);
  }
}

constexpr const char* legacy =
    "# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n0 0 0\n1 0 0\n0 2 0\n0 0 "
    "3\n1 1 1\n"
    "\nCELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\n\nCELL_TYPES 2\n10\n10\n";

std::string legacyBinary() {
  std::string b = "# vtk DataFile Version 2.0\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n";
  const auto put = [&](auto value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    for (std::size_t i = sizeof(value); i-- > 0;) b += raw[i];  // big-endian
  };
  for (const double x : {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 1, 1, 1}) put(x);
  b += "\nCELLS 2 10\n";
  for (const std::int32_t i : {4, 0, 1, 2, 3, 4, 1, 2, 3, 4}) put(i);
  b += "\nCELL_TYPES 2\n";
  for (const std::int32_t i : {10, 10}) put(i);
  return b + "\n";
}

TEST(BadInput, CutOrChangedLegacyVtkFilesNeverCrash) {
  const Parse parse = [](const std::string& content) {
    return detail::readLegacyVtk("m.vtk", content, nullptr, nullptr);
  };
  for (const std::string& content : {std::string(legacy), legacyBinary()}) {
    cutEverywhere(content, parse);
    changeEverywhere(content, parse);
  }
}

constexpr const char* plainVtu =
    "<?xml version=\"1.0\"?>\n<!-- by hand -->\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">\n"
    "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0\n0 2 0 0 0 "
    "3</DataArray></Points>\n"
    "<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 2 3</DataArray>\n"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 7</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">AgAAAAUK</DataArray>\n</Cells>\n"
    "<CellData><DataArray type=\"Int8\" Name=\"set:a &amp; b\" format=\"ascii\">0 1</DataArray></CellData>\n"
    "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

// Cells of VTK's Lagrange types, as dolfinx writes them: a tetrahedron of 4 nodes or a wedge of 6 is the
// usual one, whose triangles VTK turns the other way.
TEST(VtuReader, TakesLagrangeCellsOfFewNodes) {
  const auto read = [](const std::string& connectivity, const std::string& offsets, const std::string& types) {
    const std::string array = "<DataArray type=\"Int64\" format=\"ascii\" Name=\"";
    return detail::readVtu("m.vtu",
                           "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"7\" "
                           "NumberOfCells=\"2\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
                           "format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1 0 0 2</DataArray></Points><Cells>" +
                               array + "connectivity\">" + connectivity + "</DataArray>" + array + "offsets\">" +
                               offsets + "</DataArray>" + array + "types\">" + types +
                               "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>",
                           nullptr, nullptr);
  };
  const Mesh lagrange = read("0 1 2 3 4 5 3 4 5 6", "6 10", "73 71"),
             usual = read("0 2 1 3 5 4 3 4 5 6", "6 10", "13 10");
  EXPECT_NEAR(meshVolume(lagrange), 0.5 + 1.0 / 6, 1e-15);
  ASSERT_EQ(lagrange.blocks.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(lagrange.blocks[b].type, usual.blocks[b].type);
    EXPECT_EQ(lagrange.blocks[b].connectivity, usual.blocks[b].connectivity);
  }
  try {
    read("0 1 2 3 4 3 4 5 6", "5 9", "71 71");
    FAIL() << "a tetrahedron of five nodes was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cell 0 is of VTK type 71, which is not supported"), std::string::npos)
        << error.what();
  }
}

TEST(VtuReader, TakesBase64WithItsHeaderTogetherOrApart) {
  const auto base64 = [](const std::string& bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k)
        bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
      for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
    }
    return text;
  };
  for (const bool apart : {false, true})
    for (const bool wide : {false, true}) {
      const auto array = [&](const char* head, const auto& values) {
        const std::string data(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
        const std::uint64_t size = data.size();
        const std::string header(reinterpret_cast<const char*>(&size), wide ? 8 : 4);  // of this machine's byte order
        return std::string("<DataArray ") + head + " format=\"binary\">\n" +
               (apart ? base64(header) + "\n" + base64(data) : base64(header + data)) + "\n</DataArray>";
      };
      const std::string text =
          std::string("<VTKFile type=\"UnstructuredGrid\" byte_order=\"") +
          (std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian") + "\" header_type=\"" +
          (wide ? "UInt64" : "UInt32") +
          "\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>" +
          array("type=\"Float64\" NumberOfComponents=\"3\"", std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 6}) +
          "</Points><Cells>" + array("type=\"Int64\" Name=\"connectivity\"", std::vector<std::int64_t>{0, 1, 2, 3}) +
          array("type=\"Int64\" Name=\"offsets\"", std::vector<std::int64_t>{4}) +
          array("type=\"UInt8\" Name=\"types\"", std::vector<std::uint8_t>{10}) +
          "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
      const Mesh mesh = detail::readVtu("m.vtu", text, nullptr, nullptr);
      EXPECT_EQ(mesh.X(2, 3), 6.0) << apart << wide;
      EXPECT_EQ(mesh.blocks[0].connectivity, (std::vector<std::int32_t>{0, 1, 2, 3}));
    }
}

TEST(BadInput, CutOrChangedVtuFilesNeverCrash) {
  const Parse parse = [](const std::string& content) { return detail::readVtu("m.vtu", content, nullptr, nullptr); };
  const Mesh mesh = parse(plainVtu);
  EXPECT_DOUBLE_EQ(meshVolume(mesh), 1.0);
  EXPECT_EQ(mesh.elementSets.at("a & b").size(), 1u);
  cutEverywhere(plainVtu, parse);
  changeEverywhere(plainVtu, parse);
#ifdef RINGWATCH_WITH_VTK
  const TemporaryFolder folder;
  writeMesh(generateBar({.cells = {2, 1, 1}}), folder / "m.vtu");
  const std::string whole = readBytes(folder / "m.vtu");
  cutEverywhere(whole, parse);
  changeEverywhere(whole, parse);
#endif
}

TEST(BadInput, VtuFaults) {
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = plainVtu;
    text.replace(text.find(what), what.size(), by);
    return errorOf([&] { detail::readVtu("m.vtu", text, nullptr, nullptr); });
  };
  EXPECT_THAT(replaced("UnstructuredGrid", "PolyData"), HasSubstr("m.vtu:3: the type is \"PolyData\""));
  EXPECT_THAT(replaced("Points=\"4\"", "Points=\"4000000000\""), HasSubstr("m.vtu:5: NumberOfPoints is 4000000000"));
  EXPECT_THAT(replaced("Points=\"4\"", "Points=\"-4\""), HasSubstr("\"-4\""));
  EXPECT_THAT(replaced("Points=\"4\"", "Points=\"5\""), HasSubstr("it must have 15"));
  EXPECT_THAT(replaced("Points=\"4\"", "Points=\"3\""), HasSubstr("more than 9 values"));
  EXPECT_THAT(replaced("0 2 0 0 0 3", "0 two 0 0 0 3"), HasSubstr("m.vtu:7: a value is \"two\""));
  EXPECT_THAT(replaced("0 2 0 0 0 3", "0 nan 0 0 0 3"), HasSubstr("point 2: coordinate y of node 2 is nan"));
  EXPECT_THAT(replaced("0 1 2 3<", "0 1 2 8<"), HasSubstr("cell 1: element 1 (tet4) refers to node 8"));
  EXPECT_THAT(replaced("3 7", "3 2"), HasSubstr("offset 1 is 2"));
  EXPECT_THAT(replaced("AgAAAAUK", "AwAAAAUK"), HasSubstr("are 3 bytes; they must be 2"));
  EXPECT_THAT(replaced("AgAAAAUK", "AgAAAAUN"), HasSubstr("(wedge6) has 4 nodes"));
  EXPECT_THAT(replaced("</Cells>", "</Cell>"), HasSubstr("</Cell> does not match <Cells>"));
  EXPECT_THAT(replaced("version=\"0.1\"", "version=\"0.1\" compressor=\"x\""), HasSubstr("m.vtu:"));
}

TEST(BadInput, LegacyVtkFaults) {
  const TemporaryFolder folder;
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = legacy;
    text.replace(text.find(what), what.size(), by);
    writeBytes(folder / "m.vtk", text);
    return errorOf([&] { readMesh(folder / "m.vtk"); });
  };
  EXPECT_THAT(replaced("POINTS 5", "POINTS 500000000000"), HasSubstr("m.vtk:5: the number of POINTS is 500000000000"));
  EXPECT_THAT(replaced("POINTS 5", "POINTS -5"), HasSubstr("-5"));
  EXPECT_THAT(replaced("UNSTRUCTURED_GRID", "POLYDATA"), HasSubstr("UNSTRUCTURED_GRID"));
  EXPECT_THAT(replaced("1 2 3 4\n\n", "1 2 3 8\n\n"), HasSubstr("m.vtk:14: element 1 (tet4) refers to node 8"));
  EXPECT_THAT(replaced("10\n10\n", "10\n12\n"), HasSubstr("cell 1 (hex8) has 4 nodes; it must have 8"));
  EXPECT_THAT(replaced("1 1 1", "1 nan 1"), HasSubstr("m.vtk:10: coordinate y of node 4 is nan"));
  EXPECT_THAT(replaced("10\n10\n", "10\n42\n"), HasSubstr("VTK type 42"));
}

}  // namespace
}  // namespace ringwatch
