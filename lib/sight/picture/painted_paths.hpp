// Painted paths: loops of arcs in the view plane, for each of some bodies. A room that finds which parts are seen hands
// out such paths; the room of pictures knows nothing else of it.
#pragma once

#include "view/projected_arcs.hpp"

namespace hsp {

// Takes arcs one after the other. `first` begins a run of arcs, each of which starts where the one before it ends;
// `closes` is true for the last arc of a run that ends at its start.
struct ArcVisitor {
  void *context;
  void (*take)(void *context, const ProjectedArc &arc, bool first, bool closes);

  void operator()(const ProjectedArc &arc, bool first, bool closes) const { take(context, arc, first, closes); }
};

// The filled part of a path, or the part drawn with the colour of its lines after all paths are filled.
enum class PathPart : uint32_t { outline, lines };

class PaintedPaths {
 public:
  // The functions of a room for its paths. source: the room's result, as given to the constructor. Balls are in grid
  // order. A path shows one body: a ball, or a body that belongs to a ball and has its colour. Bodies are numbered as
  // in SeenSilhouettes; a ball has the same number as body.
  struct Functions {
    uint32_t (*ball_of)(const void *source, uint32_t path);
    // Visits the loops around a path, all of them closed.
    void (*visit_outline)(const void *source, const BallSet &balls, uint32_t path, const ArcVisitor &visitor);
    // Visits the lines of a path. Null if lines run along the outline of each path as it is painted.
    void (*visit_lines)(const void *source, const BallSet &balls, uint32_t path, const ArcVisitor &visitor);
    // Whether a path has one colour though balls are shaded. Null if all paths are of balls.
    bool (*is_plain)(const void *source, uint32_t path) = nullptr;
    // The body of a path. Null if all paths are of balls.
    uint32_t (*body_of)(const void *source, const BallSet &balls, uint32_t path) = nullptr;
  };

  // frame, source and functions have to outlive this object. The functions are a named constant, which linkers can
  // leave out.
  PaintedPaths(const ViewFrame &frame, uint32_t count, const void *source, const Functions &functions)
      : frame_(&frame), source_(source), functions_(&functions), count_(count) {}
  PaintedPaths(const ViewFrame &frame, uint32_t count, const void *source, const Functions &&functions) = delete;

  const ViewFrame &frame() const { return *frame_; }
  uint32_t size() const { return count_; }
  uint32_t ball_of(uint32_t path) const { return functions_->ball_of(source_, path); }
  uint32_t body_of(const BallSet &balls, uint32_t path) const {
    return functions_->body_of != nullptr ? functions_->body_of(source_, balls, path) : ball_of(path);
  }
  bool is_plain(uint32_t path) const { return functions_->is_plain != nullptr && functions_->is_plain(source_, path); }
  bool have_own_lines() const { return functions_->visit_lines != nullptr; }

  // Calls visit(arc, first, closes) as an ArcVisitor is called.
  template <class Visit>
  void visit(const BallSet &balls, uint32_t path, PathPart part, Visit visit) const {
    const ArcVisitor visitor{&visit, [](void *context, const ProjectedArc &arc, bool first, bool closes) {
                               (*static_cast<Visit *>(context))(arc, first, closes);
                             }};
    (part == PathPart::outline ? functions_->visit_outline : functions_->visit_lines)(source_, balls, path, visitor);
  }

 private:
  const ViewFrame *frame_;
  const void *source_;
  const Functions *functions_;
  uint32_t count_;
};

// The pieces of a view, painted one over the other.
PaintedPaths paths_of(const View &view);

// A part of the silhouette of a body between two parameters, with the body on the left, in front of one body or of the
// background. The parameters of a ball are angles around its centre. A body that is a ball has its number in grid
// order; no_id is the background.
struct SilhouetteArc {
  // The way the silhouette goes on beyond one end of an arc. If neither is true, it goes over into a crease with
  // `behind`.
  struct End {
    bool goes_on;     // it is seen, in front of the body `other`
    bool goes_under;  // it is hidden, under the nearer body `other`
    uint32_t other;
    uint32_t crossed;  // the body whose silhouette it crosses there; no_id if there is none
  };

  double from, to;
  uint32_t behind;
  End start, end;
};

// Takes the arcs of a body one after the other. `first` begins a run of arcs, each of which begins at the end of the
// one before it, with the same parameter.
struct SilhouetteVisitor {
  void *context;
  void (*take)(void *context, const SilhouetteArc &arc, bool first);

  void operator()(const SilhouetteArc &arc, bool first) const { take(context, arc, first); }
};

// One side of a body that is no ball: the points start + t step of its silhouette, in view coordinates.
struct StraightSilhouette {
  Vec3 start, step;
  double outward[2];  // the outward normal in the view plane, of length 1
  double radius;      // of the body; no contour is wider
};

class SeenSilhouettes {
 public:
  // The functions of a room for its bodies that are no balls.
  struct OtherBodies {
    uint32_t (*ball_of)(const void *source, uint32_t body);
    // The side with the point of the parameter t; the side that is nearer to a point of the view plane.
    StraightSilhouette (*side_with)(const void *source, uint32_t body, double t);
    StraightSilhouette (*side_near)(const void *source, uint32_t body, double x, double y);
    double (*front_at)(const void *source, uint32_t body, double x, double y);
  };

  // No silhouettes.
  SeenSilhouettes() = default;
  // source has to outlive this object. hand_out(source, body, visitor) does what visit() does. others: null if all
  // bodies are balls.
  SeenSilhouettes(const void *source, void (*hand_out)(const void *, uint32_t, const SilhouetteVisitor &),
                  const OtherBodies *others = nullptr)
      : source_(source), visit_(hand_out), others_(others) {}

  bool exist() const { return visit_ != nullptr; }
  // Calls visitor(arc, first) for the visible parts of the silhouette of a body.
  void visit(uint32_t body, const SilhouetteVisitor &visitor) const { visit_(source_, body, visitor); }

  static bool is_ball(const BallSet &balls, uint32_t body) { return body < balls.n; }
  uint32_t ball_of(const BallSet &balls, uint32_t body) const {
    return is_ball(balls, body) ? body : others_->ball_of(source_, body);
  }
  StraightSilhouette side_with(uint32_t body, double t) const { return others_->side_with(source_, body, t); }
  StraightSilhouette side_near(uint32_t body, double x, double y) const {
    return others_->side_near(source_, body, x, y);
  }
  double front_at(uint32_t body, double x, double y) const { return others_->front_at(source_, body, x, y); }

 private:
  const void *source_ = nullptr;
  void (*visit_)(const void *, uint32_t, const SilhouetteVisitor &) = nullptr;
  const OtherBodies *others_ = nullptr;
};

// The extent in the view plane of the silhouettes of the balls of all paths, and the range of the depths of their
// centres; zeros without paths.
struct ViewBox {
  double low[2];
  double high[2];
  double depth_low, depth_high;
};
ViewBox box_of(const BallSet &balls, const PaintedPaths &paths);

}  // namespace hsp
