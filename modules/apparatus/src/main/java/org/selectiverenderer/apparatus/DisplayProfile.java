package org.selectiverenderer.apparatus;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The optical properties of a head-mounted or other stereo display.
 *
 * @param name the display's name for messages
 * @param width the width of one eye's picture in pixels
 * @param height the height of one eye's picture in pixels
 * @param fieldOfView the field of view of one eye's picture
 * @param overlap the share of an eye's picture that the other eye sees too, above 0, at most 1; the
 *     rest lies at the outer sides
 * @param imageDistance the distance in metres of the plane in which the optics show both pictures
 *     (the image plane); infinite for collimated optics. Objects at that distance have no disparity
 *     on the display
 * @param leftOffset the offset in metres of the left eye from its nominal position (half the
 *     interpupillary distance to the left): right, up, back
 * @param rightOffset the same for the right eye
 * @param leftScreen the number of the left eye's monitor, counted from 0
 * @param rightScreen the same for the right eye
 */
public record DisplayProfile(
    String name,
    int width,
    int height,
    FieldOfView fieldOfView,
    double overlap,
    double imageDistance,
    Vector3dc leftOffset,
    Vector3dc rightOffset,
    int leftScreen,
    int rightScreen) {

  /**
   * Kaiser Electro-Optics ProView 50, VGA: the display of the thesis's experiment (6.1.1). 50
   * degrees from corner to corner, each eye its own input. Full overlap and collimated optics are
   * assumed, not measured.
   */
  public static final DisplayProfile PROVIEW_50 = proView("ProView 50", 640, 480);

  /** Kaiser Electro-Optics ProView 30, XGA (thesis 2.4.2); 50 degrees from corner to corner. */
  public static final DisplayProfile PROVIEW_30 = proView("ProView 30", 1024, 768);

  /**
   * A desktop monitor, for tests without a head-mounted display: 50 degrees from corner to corner.
   * Objects at two metres have no disparity, so that disparities within a room stay small.
   */
  public static final DisplayProfile DESK =
      new DisplayProfile(
          "desk monitor",
          1024,
          768,
          FieldOfView.diagonal(50, 4, 3),
          1,
          2,
          new Vector3d(),
          new Vector3d(),
          0,
          0);

  /**
   * @throws IllegalArgumentException if a number is out of its range
   */
  public DisplayProfile {
    if (width < 1 || height < 1 || leftScreen < 0 || rightScreen < 0) {
      throw new IllegalArgumentException(
          "a display must be at least 1 pixel wide and high, its screen numbers 0 or more");
    }
    if (!(overlap > 0 && overlap <= 1) || !(imageDistance > 0)) {
      throw new IllegalArgumentException(
          "the overlap must be above 0 and at most 1, the image distance above 0 metres");
    }
    leftOffset = new Vector3d(leftOffset);
    rightOffset = new Vector3d(rightOffset);
  }

  private static DisplayProfile proView(String name, int width, int height) {
    return new DisplayProfile(
        name,
        width,
        height,
        FieldOfView.diagonal(50, width, height),
        1,
        Double.POSITIVE_INFINITY,
        new Vector3d(),
        new Vector3d(),
        0,
        1);
  }

  Vector3dc offset(Eye eye) {
    return eye == Eye.LEFT ? leftOffset : rightOffset;
  }

  /** Returns the number of an eye's monitor, counted from 0. */
  public int screen(Eye eye) {
    return eye == Eye.LEFT ? leftScreen : rightScreen;
  }
}
