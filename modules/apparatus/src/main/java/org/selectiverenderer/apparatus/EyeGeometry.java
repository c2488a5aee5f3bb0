package org.selectiverenderer.apparatus;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The geometry of stereoscopic viewing: the positions of the two eyes and the frustum of each
 * through a display. Both view axes are parallel to the head's, with off-axis frusta. Turning the
 * axes inwards ("toe-in") would give vertical disparities and a curved depth plane (Woods, Docherty
 * and Koch 1993, Image distortions in stereoscopic video systems).
 *
 * <p>Lengths are metres in the head's coordinates: right-handed, the origin midway between the
 * eyes, X to the right, Y up, looking along -Z.
 *
 * @param interpupillaryDistance in metres, not negative; with 0 both eyes have the same position
 */
public record EyeGeometry(DisplayProfile profile, double interpupillaryDistance) {
  /**
   * The mean interpupillary distance of adults in millimetres (Dodgson 2004, Variation and extrema
   * of human IPD).
   */
  public static final double MEAN_IPD = 63;

  /** The largest interpupillary distance accepted, in millimetres; adults have 52 to 78. */
  public static final double LARGEST_IPD = 100;

  public EyeGeometry {
    if (!(interpupillaryDistance >= 0 && interpupillaryDistance < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("the interpupillary distance must be 0 or more");
    }
  }

  /** Returns an eye's position in metres. */
  public Vector3d position(Eye eye) {
    return new Vector3d(eye.side() * interpupillaryDistance / 2, 0, 0).add(profile.offset(eye));
  }

  /**
   * Returns the field of view of both eyes together, which is wider than one eye's if their
   * pictures overlap in part. If it is asymmetric, the wider side counts for both.
   */
  public FieldOfView bothEyes() {
    EyeFrustum left = frustum(Eye.LEFT);
    EyeFrustum right = frustum(Eye.RIGHT);
    return new FieldOfView(
        Math.max(Math.max(-left.left(), -right.left()), Math.max(left.right(), right.right())),
        Math.max(Math.max(-left.bottom(), -right.bottom()), Math.max(left.top(), right.top())));
  }

  /**
   * Returns the off-axis frustum of an eye.
   *
   * <p>The picture of an eye is a window of the half extents (x, y) times D in the plane at
   * distance D. With partial overlap its centre is displaced outwards from the head's axis by (1 -
   * overlap) x D. Seen from an eye at (ex, ey, ez) the edge at w has the tangent (w - ex) / (D +
   * ez); where D is infinite the eye's position does not matter.
   */
  public EyeFrustum frustum(Eye eye) {
    FieldOfView field = profile.fieldOfView();
    double middle = eye.side() * (1 - profile.overlap()) * field.x();
    double distance = profile.imageDistance();
    if (distance == Double.POSITIVE_INFINITY) {
      return new EyeFrustum(middle - field.x(), middle + field.x(), -field.y(), field.y());
    }
    Vector3dc at = position(eye);
    double depth = distance + at.z();
    return new EyeFrustum(
        ((middle - field.x()) * distance - at.x()) / depth,
        ((middle + field.x()) * distance - at.x()) / depth,
        (-field.y() * distance - at.y()) / depth,
        (field.y() * distance - at.y()) / depth);
  }
}
