package org.selectiverenderer.hmd;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Where the two eyes are and what each sees through a display. The view axes of both are parallel
 * to the head's; the pictures are shifted instead (off-axis frusta). Turning the axes inwards
 * ("toe-in") would give vertical disparities and a curved depth plane (Woods, Docherty and Koch
 * 1993, Image distortions in stereoscopic video systems).
 *
 * <p>Lengths are metres in the head's coordinates: right handed, the middle between the eyes at the
 * origin, X to the right, Y up, looking along -Z.
 *
 * @param interpupillaryDistance metres, not negative; 0 shows both eyes the same place
 */
public record EyeGeometry(DisplayProfile profile, double interpupillaryDistance) {
  /** Millimetres: the mean of adults (Dodgson 2004, Variation and extrema of human IPD). */
  public static final double MEAN_IPD = 63;

  /** Millimetres; adults have 52 to 78. */
  public static final double LARGEST_IPD = 100;

  public EyeGeometry {
    if (!(interpupillaryDistance >= 0 && interpupillaryDistance < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("the distance of the eyes must be above 0");
    }
  }

  /** An eye's place in metres. */
  public Vector3d position(Eye eye) {
    return new Vector3d(eye.side() * interpupillaryDistance / 2, 0, 0).add(profile.offset(eye));
  }

  /**
   * What both eyes see together: where their pictures overlap in part more than one eye does. To
   * the side on which it reaches farther.
   */
  public FieldOfView bothEyes() {
    EyeFrustum left = frustum(Eye.LEFT);
    EyeFrustum right = frustum(Eye.RIGHT);
    return new FieldOfView(
        Math.max(Math.max(-left.left(), -right.left()), Math.max(left.right(), right.right())),
        Math.max(Math.max(-left.bottom(), -right.bottom()), Math.max(left.top(), right.top())));
  }

  /**
   * What an eye sees.
   *
   * <p>The picture of an eye is a window of the half extents (x, y) times D in the plane at
   * distance D. With a share of the pictures overlapping, its middle lies beside the head's axis,
   * outwards, by (1 - overlap) x D. Seen from an eye at (ex, ey, ez) the side at w has the tangent
   * (w - ex) / (D + ez); where D is infinite the eye's place does not matter.
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
