#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/report/page_data.h>
#include <ringwatch/meshes/formats/vtu_frame.h>

namespace ringwatch {

/// A frame for the page.
struct PageFrame {
  std::int64_t number = 1;  // in the run, counted from 1
  double time = 0;          // s
  VtuFrame state;
};

/// The range of the colours about a range of positive numbers: at least 5 %, so that what differs by less, as the steps
/// of a regular mesh do by rounding, has nearly one colour.
struct ColourRange {
  static constexpr double least = 1.05;
  double low = 0, high = 0;
  static ColourRange about(double low, double high);
};

/// An element of a frame, for a card.
struct WorstCard {
  ElementRef ref;
  bool ofFile = false;       // id is the file's number
  std::int64_t element = 0;  // elements counted through, as the page counts them
  std::int64_t id = 0;
  std::string type, shape;                         // "tet4"; "sliver, 2.1° dihedral", at the frame's positions
  double step = 0;                                 // s
  double volume = 0, minHeight = 0;                // m³, m
  double minEdge = 0, maxEdge = 0;                 // m
  std::vector<std::array<double, 3>> corners;      // m
  std::vector<std::array<std::int32_t, 2>> edges;  // of the corners
  std::vector<std::vector<std::int32_t>> faces;    // of the corners
};

/// Makes of frames, one after the other, what the page shows in space: the surface, and the elements with the least
/// steps through the body; of small meshes all elements. Frames of one mesh after each other share what does not
/// change.
class MeshPack {
 public:
  /// Up to so many elements all of them are in the page, and from larger meshes so many of each frame.
  static constexpr std::size_t allElements = 30000, leastElements = 10000;

  explicit MeshPack(PageData& data) : data_(data) {}
  /// keyFrame: of this one the picture and the cards are made. controlling: elements of it that have cards of their
  /// own.
  void add(const PageFrame& frame, bool keyFrame, const std::vector<ElementRef>& controlling = {});
  /// { scale: {field, min, max} or null, groups: [ … ] }
  nlohmann::ordered_json finish();

  const std::vector<WorstCard>& worst() const { return worst_; }
  const std::vector<WorstCard>& controlling() const { return controlling_; }
  /// PNG of the key frame, "" for none.
  const std::string& picture() const { return picture_; }
  /// The field that is the step of elements: the first of the frames named "… step by … (s)"; "" for none.
  const std::string& stepField() const { return stepField_; }
  std::size_t elementCount() const { return elementCount_; }         // of the last frame
  const ColourRange& pictureScale() const { return pictureScale_; }  // s

 private:
  struct KeptFrame;
  struct Group;
  void closeGroup();
  void makeKeyFrame(const PageFrame& frame, const std::vector<double>* steps,
                    const std::vector<ElementRef>& controlling);

  PageData& data_;
  std::shared_ptr<Group> group_;  // that is open
  nlohmann::ordered_json groups_ = nlohmann::ordered_json::array();
  std::vector<WorstCard> worst_, controlling_;
  std::string picture_, stepField_;
  ColourRange pictureScale_;
  std::size_t elementCount_ = 0;
};

}  // namespace ringwatch
