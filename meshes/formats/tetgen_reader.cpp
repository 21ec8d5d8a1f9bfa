#include <cmath>

#include <ringwatch/meshes/formats/file_cursor.h>
#include <ringwatch/meshes/formats/mesh_builder.h>
#include <ringwatch/meshes/formats/mesh_readers.h>

namespace ringwatch::detail {
namespace {

// A last line without its end may have lost digits, and a shorter number is still a number.
void requireLineEnd(const FileCursor& cursor) {
  if (!cursor.endsWithNewline()) cursor.fail("the last line has no line end; is the file cut short?");
}

void requireEnd(FileCursor& cursor, std::string_view what, std::size_t count) {
  if (cursor.skipSpace())
    cursor.fail(joinText("more lines than the ", count, " ", what, " that the first line announces"));
}

}  // namespace

// Numbers start at 0 or 1 (or anywhere): elements refer to nodes by the number that the .node file gives them.
Mesh readTetgen(const std::filesystem::path& nodeFile, const std::filesystem::path& elementFile, Notes* notes,
                Problems* problems) {
  const std::string nodeText = readWholeFile(nodeFile), elementText = readWholeFile(elementFile);
  FileCursor nodes(nodeText, nodeFile.string()), elements(elementText, elementFile.string());
  nodes.comment = elements.comment = '#';
  MeshBuilder builder(
      elementFile.string(), [&](std::size_t p) { return nodes.where(p); },
      [&](std::size_t p) { return elements.where(p); });

  nodes.beginRecord("the number of nodes");
  std::size_t at = nodes.position();
  const std::int64_t announced = nodes.integerText("the number of nodes");
  const std::int64_t dimension = nodes.integerText("the dimension");
  const std::int64_t attributes = nodes.atLineEnd() ? 0 : nodes.integerText("the number of attributes");
  const std::int64_t markers = nodes.atLineEnd() ? 0 : nodes.integerText("the number of boundary markers");
  if (dimension != 3) nodes.failAt(at, joinText("the dimension is ", dimension, "; it must be 3"));
  if (attributes < 0 || attributes > 1000)
    nodes.failAt(at, joinText("the number of attributes is ", attributes, "; it must be 0 to 1000"));
  if (markers != 0 && markers != 1)
    nodes.failAt(at, joinText("the number of boundary markers is ", markers, "; it must be 0 or 1"));
  nodes.endRecord();
  const std::size_t count = nodes.checkedCount(announced, 8, "nodes", at);
  for (std::size_t i = 0; i < count; ++i) {
    nodes.beginRecord("a node");
    const std::size_t where = nodes.position();
    const std::int64_t id = nodes.integerText("the number of a node");
    if (id < 0) nodes.failAt(where, joinText("the number of a node is ", id, "; it must not be negative"));
    const double x = nodes.numberText("coordinate x"), y = nodes.numberText("coordinate y"),
                 z = nodes.numberText("coordinate z");
    for (std::int64_t k = 0; k < attributes; ++k) nodes.numberText("an attribute of a node");
    if (markers == 1)
      if (const std::int64_t marker = nodes.integerText("the boundary marker"); marker != 0)
        builder.addToNodeSet(joinText("marker-", marker), id);
    nodes.endRecord();
    builder.addNode(id, x, y, z, where);
  }
  requireEnd(nodes, "nodes", count);
  requireLineEnd(nodes);

  elements.beginRecord("the number of tetrahedra");
  at = elements.position();
  const std::int64_t announcedElements = elements.integerText("the number of tetrahedra");
  const std::int64_t width = elements.atLineEnd() ? 4 : elements.integerText("the number of nodes a tetrahedron");
  const std::int64_t regions = elements.atLineEnd() ? 0 : elements.integerText("the number of attributes");
  if (width != 4)
    elements.failAt(at, joinText("the number of nodes a tetrahedron is ", width, "; only 4 is supported"));
  if (regions < 0 || regions > 1000)
    elements.failAt(at, joinText("the number of attributes is ", regions, "; it must be 0 to 1000"));
  elements.endRecord();
  const std::size_t elementCount = elements.checkedCount(announcedElements, 10, "tetrahedra", at);
  const FileElement& tet = *findVtkElement(10);
  std::map<double, int> groups;
  for (std::size_t i = 0; i < elementCount; ++i) {
    elements.beginRecord("a tetrahedron");
    const std::size_t where = elements.position();
    const std::int64_t id = elements.integerText("the number of a tetrahedron");
    std::int64_t own[4];
    for (std::int64_t& node : own) node = elements.integerText("the number of a node of a tetrahedron");
    int group = -1;
    for (std::int64_t k = 0; k < regions; ++k) {
      const double value = elements.numberText("an attribute of a tetrahedron");
      if (k > 0 || std::isnan(value)) continue;
      const auto [found, isNew] = groups.try_emplace(value, 0);  // the first attribute is the region
      if (isNew) found->second = builder.addGroup({joinText("region-", value)});
      group = found->second;
    }
    elements.endRecord();
    builder.addElement(tet, id, own, group, where);
  }
  requireEnd(elements, "tetrahedra", elementCount);
  requireLineEnd(elements);
  return builder.finish(notes, problems);
}

}  // namespace ringwatch::detail
