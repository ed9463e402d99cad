#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_notes.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace espalier {

/// Where a code stands.
struct MtgPlace {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// The vertices that the values of a line belong to: all ids from first to last.
struct MtgSpan {
  VertexId first{};
  VertexId last{};
};

/// Adds vertices to an MTG from the codes of its text, such as "^<N", "/P1/A1" or "+B2/U1".
///
/// - A code without ^ is attached to the last vertex of the column before its own, one with ^ to
///   the last vertex of its own column.
/// - In the first column, a code that begins with / and a class of the coarsest scale is a full
///   name: it is attached to the scene, and its first vertices may be ones read before. So may
///   those of a code that begins with a name of a vertex: "(A1)/U1<U2". Only vertices with an index
///   are found again, and the last of a code is always new. Other codes continue the first column.
/// - A code of a coarser scale than what it is attached to is attached to what that is a part of,
///   and its own first part is attached where the coarser one was reached from. A + leaves the
///   vertex open for more codes with ^.
/// - An index is a number, or numbers parted by dots: S16.1 is the first of those at place 16.
/// - "<<" and "++" stand for all vertices between two indices; so do "<.<" and "+.+", to which the
///   values of the line belong alike. Of indices with a dot the last number counts up.
/// - A class that is not declared gets the scale of what it follows, after / the next finer one;
///   Scene is of scale 0.
class MtgTopology {
public:
  /// pre: mtg.classes are complete
  MtgTopology(Mtg& mtg, MtgNotes& notes, bool continuesColumns);

  /// Adds the vertices of a code.
  /// @throws Error if the code is malformed, or attached to nothing
  MtgSpan add(std::string_view code, MtgPlace place);

  /// The last vertex of a column, to which a line "*" adds.
  /// @throws Error if there is none
  [[nodiscard]] VertexId lastOf(MtgPlace place) const;

  /// Lets codes begin with "(alias)" for this vertex.
  void name(const std::string& alias, VertexId vertex, MtgPlace place);

  /// Those of the first vertices of codes that programs attach differently: <X without ^ below
  /// others.
  [[nodiscard]] const std::vector<VertexId>& disputed() const { return disputed_; }
  [[nodiscard]] MtgPlace firstDispute() const { return firstDispute_; }

private:
  struct Label {
    std::string_view symbol;
    int scale = 1;
    std::optional<LabelIndex> index;
  };
  /// From which vertex, and how, a coarser one was reached: its first part is attached there.
  struct Entry {
    VertexId vertex;
    EdgeType edge;
  };
  struct Column { // what stands in it so far; nothing stands for the scene
    std::optional<VertexId> last;
    std::map<int, VertexId> lastOfScale;
  };
  struct Step { // one vertex of a code, or a range of them: "<<U5"
    char edge = '/';
    bool isRange = false;
    bool isShared = false;
    std::string_view label;
    bool isLast = false; // of the code
  };
  struct Path { // along a code
    Column before;
    Column own;
    bool isName = false; // all of it was read before
    bool hasSpan = false;
    MtgSpan span; // of the last step, if that made vertices
  };
  /// What a vertex was written after, and how: the same again means the same vertex, in full names.
  using Name = std::tuple<std::optional<VertexId>, char, std::string_view, std::vector<int>>;

  [[nodiscard]] FilePlace cell(MtgPlace place) const;
  [[noreturn]] void fail(MtgPlace place, const char* sentence,
                         std::vector<std::string> values = {}) const;
  [[nodiscard]] Path pathOf(std::string_view& code, MtgPlace place);
  [[nodiscard]] Path pathOfName(std::string_view& code, MtgPlace place) const;
  [[nodiscard]] Column columnAt(std::size_t wanted, MtgPlace place) const;
  [[nodiscard]] Column anchor(std::string_view code, MtgPlace place, bool& isName);
  [[nodiscard]] Step nextStep(std::string_view& code, MtgPlace place) const;
  void follow(const Step& step, Path& path, MtgPlace place);
  void followRange(const Step& step, const Label& label, Path& path, MtgPlace place);
  void addOne(const Label& label, char edge, Path& path, MtgPlace place);

  [[nodiscard]] std::optional<Label> knownLabel(std::string_view text) const;
  Label labelOf(const Step& step, const Column& before, MtgPlace place);
  void declare(std::string_view symbol, const Step& step, const Column& before, MtgPlace place);
  [[nodiscard]] int finerThan(int scale, MtgPlace place) const;
  [[nodiscard]] int scaleOf(VertexId id) const { return mtg_.vertices[indexOf(id)].scale; }
  [[nodiscard]] std::optional<VertexId> upTo(std::optional<VertexId> vertex, int scale) const;
  [[nodiscard]] std::optional<VertexId> bearerOf(const Label& label, char edge,
                                                 const Column& before) const;
  void place(VertexId id, char edge, Column& column) const;
  VertexId attach(const Label& label, char edge, const Column& before, MtgPlace place);
  void linkFirstPart(MtgVertex& part, VertexId id);

  Mtg& mtg_;
  MtgNotes& notes_;
  bool continuesColumns_;
  int coarsest_ = 1;
  std::set<int> scalesInUse_;
  std::map<std::string, int, std::less<>> scales_; // by symbol
  std::map<VertexId, Entry> entries_;              // of vertices that have no parts yet
  std::map<Name, VertexId> names_;
  std::unordered_map<std::string, VertexId> aliases_;
  std::vector<Column> columns_;
  std::optional<VertexId> scene_;
  std::vector<VertexId> disputed_;
  MtgPlace firstDispute_;
  std::size_t inRanges_ = 0;
};

} // namespace espalier
