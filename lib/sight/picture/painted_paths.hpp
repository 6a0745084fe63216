// Painted paths, by whatever room they are found: a path of arcs in the view plane for each of some balls. A room that
// knows what is seen hands out such paths; the room of pictures knows no more of it than this.
#pragma once

#include "view/projected_arcs.hpp"

namespace hsp {

// Takes arcs one after the other. `first` begins a run of arcs, each of which starts where the one before it ends;
// `closes` is true where such a run ends at its start.
struct ArcVisitor {
  void *context;
  void (*take)(void *context, const ProjectedArc &arc, bool first, bool closes);

  void operator()(const ProjectedArc &arc, bool first, bool closes) const { take(context, arc, first, closes); }
};

// The filled part of a path, or the part drawn with the colour of its lines after all paths are filled.
enum class PathPart : uint32_t { outline, lines };

class PaintedPaths {
 public:
  // How a room answers for its paths. `source` is what it has found, as it was given below; balls are in grid order.
  // A path shows one body, a ball or what belongs to one and is painted as it is; bodies have numbers as in
  // SeenSilhouettes, and balls are their own bodies.
  struct Functions {
    uint32_t (*ball_of)(const void *source, uint32_t path);
    // The loops around a path, all of them closed.
    void (*visit_outline)(const void *source, const BallSet &balls, uint32_t path, const ArcVisitor &visitor);
    // Null where lines run along the outline of each path as it is painted.
    void (*visit_lines)(const void *source, const BallSet &balls, uint32_t path, const ArcVisitor &visitor);
    // Whether a path has one colour where balls are shaded. Null where all paths are of balls.
    bool (*is_plain)(const void *source, uint32_t path) = nullptr;
    // Null likewise.
    uint32_t (*body_of)(const void *source, const BallSet &balls, uint32_t path) = nullptr;
  };

  // All but the count have to outlive this. The functions are a named constant, which linkers can leave out.
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

// The silhouette of a body between two parameters, with the body on the left, in front of one body or of the
// background. Of a ball they are angles around its centre. Bodies that are balls have their numbers in grid order,
// no_id is the background.
struct SilhouetteArc {
  // The side beyond one end of an arc.
  struct End {
    bool goes_on;     // on the same silhouette, in front of the body `other`
    bool goes_under;  // unseen, under the nearer body `other`; neither: into a crease, where it meets `behind`
    uint32_t other;
    uint32_t crossed;  // the body whose silhouette it crosses there; no_id if there is none
  };

  double from, to;
  uint32_t behind;
  End start, end;
};

// Takes the arcs of a body one after the other; `first` begins a run of arcs, each of which goes on where the one
// before it ends, with parameters that go on, too.
struct SilhouetteVisitor {
  void *context;
  void (*take)(void *context, const SilhouetteArc &arc, bool first);

  void operator()(const SilhouetteArc &arc, bool first) const { take(context, arc, first); }
};

// One side of a body that is no ball: in view coordinates its silhouette is the points start + t step.
struct StraightSilhouette {
  Vec3 start, step;
  double outward[2];  // of length 1, across
  double radius;      // of the body; no contour is wider
};

class SeenSilhouettes {
 public:
  // How a room answers for its bodies. Of a body that is no ball:
  struct OtherBodies {
    uint32_t (*ball_of)(const void *source, uint32_t body);
    // The side that has the point of the parameter t, or is nearer to a point of the view plane.
    StraightSilhouette (*side_with)(const void *source, uint32_t body, double t);
    StraightSilhouette (*side_near)(const void *source, uint32_t body, double x, double y);
    double (*front_at)(const void *source, uint32_t body, double x, double y);
  };

  // No silhouettes.
  SeenSilhouettes() = default;
  // source has to outlive this. hand_out(source, body, visitor) as below. others: null where all bodies are balls.
  SeenSilhouettes(const void *source, void (*hand_out)(const void *, uint32_t, const SilhouetteVisitor &),
                  const OtherBodies *others = nullptr)
      : source_(source), visit_(hand_out), others_(others) {}

  bool exist() const { return visit_ != nullptr; }
  // Calls visitor(arc, first) for what is seen of the silhouette of a body.
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

// The extent in the view plane of the silhouettes of the balls of all paths, and the depths of their centres; zeros
// without paths.
struct ViewBox {
  double low[2];
  double high[2];
  double depth_low, depth_high;
};
ViewBox box_of(const BallSet &balls, const PaintedPaths &paths);

}  // namespace hsp
