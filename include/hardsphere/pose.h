/* hardsphere/pose.h: a rigid molecule, turned and moved, against another one at rest (Sections 3 and 6).
 *
 * Guide: poses.md.
 *
 * Provisional: this may change with any minor version, as the changelog then says.
 *
 *   hsp_body_bytes(n, &bytes);                    hsp_body *body;
 *   hsp_body_init(memory, bytes, n, &body);       hsp_body_set(body, model);
 *   hsp_body_hits(fixed, posed, poses, pose, hit, NULL);
 *
 * A body is a molecule prepared as a tree of spheres around its balls. Its balls are those of a model, on the same
 * lattice; once they are taken it does not need the model any more. A pose moves the point x of the posed body to R x +
 * t, where R is the rotation of a quaternion about the origin. Then each ball is rounded to the lattice again: its
 * centre becomes the lattice point nearest to R x + t as computed in doubles. As long as coordinates are below 2^40
 * steps that is within 0.87 steps of the ideal position. So answers are exact for the rounded balls, the same on every
 * machine, and right for the ideal balls wherever no gap is within a step of 0. Balls that touch meet. Rational poses
 * round nothing: their answers are exact for the ideal balls.
 *
 * Both bodies need lattices of the same step: set hsp_model_options.step where radii differ much. Queries only read
 * bodies, so that any number of threads may query at once, and a list of poses may be split over threads in any way:
 * each pose is answered on its own. Lists in which each pose is close to the one before, as in the frames of a motion,
 * cost less: the pair of balls that decided one pose is tested first for the next. */
#ifndef HARDSPHERE_POSE_H
#define HARDSPHERE_POSE_H

#include "model.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A molecule prepared for poses. */
typedef struct hsp_body hsp_body;

/** Bytes that hsp_body_init needs for at most `balls` balls, alignment slack included.
 *  - Property 1: at most HSP_BODY_BYTES(balls).
 *
 *  @retval HSP_E_ARGUMENT  bytes is NULL
 *  @retval HSP_E_RANGE     balls > HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_body_bytes(uint32_t balls, size_t *bytes);

/** The same as an upper bound that is a constant expression, for static arrays. */
#define HSP_BODY_BYTES(balls) ((size_t)2048 + (size_t)112 * (size_t)(balls))

/** Make a body without balls in caller memory of any alignment; sets *body.
 *  @retval HSP_E_ARGUMENT  memory or body is NULL
 *  @retval HSP_E_MEMORY    bytes is less than hsp_body_bytes says; nothing is written
 *  @retval HSP_E_RANGE     balls > HSP_MAX_BALLS, or the size does not fit a size_t */
HSP_API int32_t HSP_CALL hsp_body_init(void *memory, size_t bytes, uint32_t balls, hsp_body **body);

/** Take the balls of a model. May be called any number of times. On failure the body holds nothing, and queries of it
 *  return HSP_E_STATE until balls are taken again.
 *  - Property 1: the order of the balls has no effect but on the ids.
 *
 *  Cost: O(n log n).
 *  @retval HSP_E_ARGUMENT  a null pointer
 *  @retval HSP_E_CAPACITY  the body has room for fewer balls
 *  @retval HSP_E_STATE     hsp_model_set has failed */
HSP_API int32_t HSP_CALL hsp_body_set(hsp_body *body, const hsp_model *model);

/** How balls are taken. Zero means default in every field but the first. */
typedef struct hsp_body_request {
  uint32_t struct_size;         /**< sizeof(hsp_body_request) */
  uint32_t reserved;            /**< 0 */
  const hsp_executor *executor; /**< or NULL: its proceed is asked whether to go on; its threads share no work */
} hsp_body_request;

/** The same as hsp_body_set, with an executor that may stop it; request may be NULL: all defaults.
 *  @retval HSP_E_ARGUMENT  body or model is NULL; an executor with several workers and without run
 *  @retval HSP_E_VERSION   bad struct_size of request or executor, or reserved is not 0
 *  @retval HSP_E_CAPACITY  as hsp_body_set
 *  @retval HSP_E_STATE     as hsp_body_set
 *  @retval HSP_E_STOPPED   the executor said not to go on */
HSP_API int32_t HSP_CALL hsp_body_set_with(hsp_body *body, const hsp_model *model, const hsp_body_request *request);

/** A rotation and a translation: the point x moves to R x + t. Frozen. */
typedef struct hsp_pose {
  double quaternion[4];  /**< w x y z, of any length but 0: the rotation R; 1 0 0 0 is no rotation */
  double translation[3]; /**< t, length */
} hsp_pose;

/** The pose of a rotation matrix [9], row by row, and a translation [3], length.
 *  Entries of matrix times its transpose may differ from those of the unit matrix by 1e-6; the pose has the quaternion
 *  whose rotation is nearest to the matrix.
 *  @retval HSP_E_ARGUMENT    a null pointer
 *  @retval HSP_E_NOT_FINITE  a number is NaN or infinite
 *  @retval HSP_E_RANGE       the matrix is no rotation: not orthonormal, or a reflection */
HSP_API int32_t HSP_CALL hsp_pose_from_matrix(const double *matrix, const double *translation, hsp_pose *pose);

/** Whether any ball of the posed body meets one of the body at rest, for each pose [poses]: hit [poses] becomes 1 or
 *  0. first_bad may be NULL, else it becomes the first pose that is refused, or HSP_NONE; nothing else is written then.
 *
 *  Cost: some two microseconds for free poses of a hundred atoms at contact, nearly independent of the size of the body
 *  at rest.
 *  @retval HSP_E_ARGUMENT    a null pointer with poses > 0, or lattices of different steps
 *  @retval HSP_E_STATE       a body holds nothing: its hsp_body_set has failed
 *  @retval HSP_E_NOT_FINITE  a number of a pose is NaN or infinite
 *  @retval HSP_E_RANGE       a quaternion has length 0, or its largest component is not within 2^-300 and 2^300; a
 *                            pose moves balls by more than 2^50 steps, or may move one farther than 2^51 steps */
HSP_API int32_t HSP_CALL hsp_body_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                       const hsp_pose *pose, uint32_t *hit, uint32_t *first_bad);

/** The same answers as hsp_body_hits, sooner for the frames of a motion, each of which is near the one before. In a
 *  free pose this function also finds how far apart the bodies are, up to `margin`, a length. The poses that follow are
 *  free without any query until a ball can have moved that far. A margin of some ten times the distance that a ball
 *  moves from one frame to the next serves best; with a larger margin each query takes longer.
 *  - Property 1: the margin has no effect on hit.
 *
 *  Cost: that of hsp_body_hits where bodies meet or come near each other, else a tenth of a microsecond.
 *  @retval HSP_E_ARGUMENT    as for hsp_body_hits
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_hits, or the margin is NaN or infinite
 *  @retval HSP_E_RANGE       as for hsp_body_hits, or the margin is negative */
HSP_API int32_t HSP_CALL hsp_body_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                             const hsp_pose *pose, double margin, uint32_t *hit, uint32_t *first_bad);

/** The pair of balls with the least gap. Frozen. */
typedef struct hsp_body_gap {
  double gap;     /**< length: |c - c'| - r - r', least of all pairs; negative for the pair that overlaps deepest */
  uint32_t fixed; /**< ball of the body at rest; HSP_NONE if a body has no balls: the gap is infinite then */
  uint32_t posed; /**< ball of the posed body, likewise */
} hsp_body_gap;

/** The least gap for each pose [poses]: gap [poses]. Otherwise as hsp_body_hits. A gap has an error of at most 2^-51 of
 *  the distance of the two centres, or of the sum of the two radii if balls overlap. Of pairs whose gaps are the same
 *  double once they are rounded it is the one with the lowest ball at rest, then with the lowest posed ball; pairs with
 *  equal ideal gaps may differ by that error.
 *  @retval HSP_E_ARGUMENT    as for hsp_body_hits; gap is NULL with poses > 0
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_hits
 *  @retval HSP_E_RANGE       as for hsp_body_hits */
HSP_API int32_t HSP_CALL hsp_body_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                       const hsp_pose *pose, hsp_body_gap *gap, uint32_t *first_bad);

/** How much two bodies overlap. Frozen. */
typedef struct hsp_body_overlap {
  double volume;     /**< length^3: the intersections of all pairs of balls, summed pair by pair */
  uint32_t pairs;    /**< pairs that meet; 2^32 - 1 if there are more */
  uint32_t reserved; /**< 0 */
} hsp_body_overlap;

/** How much the bodies overlap, a penalty for docking codes, for each pose [poses]: overlap [poses].
 *  Otherwise as hsp_body_hits. The intersection of two balls has an error of at most 1e-13 of itself.
 *  @retval HSP_E_ARGUMENT    as for hsp_body_hits; overlap is NULL with poses > 0
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_hits
 *  @retval HSP_E_RANGE       as for hsp_body_hits */
HSP_API int32_t HSP_CALL hsp_body_overlaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                           const hsp_pose *pose, hsp_body_overlap *overlap, uint32_t *first_bad);

/** All pairs of balls that meet in one pose: pair [needed][2], the ball at rest first, ascending.
 *  @retval HSP_E_ARGUMENT    fixed, posed or pose is NULL; pair is NULL with a capacity above 0; lattices of different
 *                            steps
 *  @retval HSP_E_CAPACITY    capacity < *needed; nothing is written to pair
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_hits
 *  @retval HSP_E_RANGE       as for hsp_body_hits, or more than 2^32 - 2 pairs */
HSP_API int32_t HSP_CALL hsp_body_pairs(const hsp_body *fixed, const hsp_body *posed, const hsp_pose *pose,
                                        uint32_t *pair, uint32_t capacity, uint32_t *needed);

/** A rotation and a translation without any rounding: the point x moves to R x + t. R is a matrix of fractions, the
 *  integer matrix of the quaternion divided by the square of its length; t is a lattice point. Frozen. */
typedef struct hsp_rational_pose {
  int32_t quaternion[4]; /**< w x y z, not all 0, of any length: the rotation R; 1 0 0 0 is none */
  double translation[3]; /**< t, length; rounded to the nearest lattice point */
} hsp_rational_pose;

/** As hsp_body_hits, for each rational pose [poses], which keeps the body rigid: no ball is rounded to the lattice
 *  again. Whether two ideal balls meet is decided in integers of 256 bits where doubles leave a doubt. Lists of close
 *  poses cost less, as there.
 *  - Property 1: the same rotation by a quaternion of another length has the same answers.
 *
 *  Cost: as hsp_body_hits, more where balls nearly touch.
 *  @retval HSP_E_ARGUMENT    as for hsp_body_hits
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  a number of a translation is NaN or infinite
 *  @retval HSP_E_RANGE       a quaternion is 0; a pose moves balls by more than 2^50 steps, or may move one farther
 *                            than 2^51 steps */
HSP_API int32_t HSP_CALL hsp_body_rational_hits(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                                const hsp_rational_pose *pose, uint32_t *hit, uint32_t *first_bad);

/** As hsp_body_hits_along, for each rational pose [poses]: the answers of hsp_body_rational_hits.
 *  - Property 1: the margin has no effect on hit.
 *
 *  @retval HSP_E_ARGUMENT    as for hsp_body_hits
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_rational_hits, or the margin is NaN or infinite
 *  @retval HSP_E_RANGE       as for hsp_body_rational_hits, or the margin is negative */
HSP_API int32_t HSP_CALL hsp_body_rational_hits_along(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                                      const hsp_rational_pose *pose, double margin, uint32_t *hit,
                                                      uint32_t *first_bad);

/** As hsp_body_gaps, for each rational pose [poses]: gaps between ideal balls.
 *  @retval HSP_E_ARGUMENT    as for hsp_body_hits; gap is NULL with poses > 0
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_rational_hits
 *  @retval HSP_E_RANGE       as for hsp_body_rational_hits */
HSP_API int32_t HSP_CALL hsp_body_rational_gaps(const hsp_body *fixed, const hsp_body *posed, uint32_t poses,
                                                const hsp_rational_pose *pose, hsp_body_gap *gap, uint32_t *first_bad);

/** As hsp_body_pairs, for a rational pose.
 *  @retval HSP_E_ARGUMENT    fixed, posed or pose is NULL; pair is NULL with a capacity above 0; lattices of different
 *                            steps
 *  @retval HSP_E_CAPACITY    capacity < *needed; nothing is written to pair
 *  @retval HSP_E_STATE       as for hsp_body_hits
 *  @retval HSP_E_NOT_FINITE  as for hsp_body_rational_hits
 *  @retval HSP_E_RANGE       as for hsp_body_rational_hits, or more than 2^32 - 2 pairs */
HSP_API int32_t HSP_CALL hsp_body_rational_pairs(const hsp_body *fixed, const hsp_body *posed,
                                                 const hsp_rational_pose *pose, uint32_t *pair, uint32_t capacity,
                                                 uint32_t *needed);

#ifdef __cplusplus
}
#endif

#endif
