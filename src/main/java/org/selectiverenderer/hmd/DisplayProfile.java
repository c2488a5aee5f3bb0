package org.selectiverenderer.hmd;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * What a display shows to two eyes.
 *
 * @param name for people
 * @param width of one eye's picture in pixels
 * @param height of one eye's picture in pixels
 * @param fieldOfView of one eye's picture
 * @param overlap the share of an eye's picture that the other eye sees too, above 0, at most 1;
 *     what is missing to 1 lies at the outer sides
 * @param imageDistance metres to the plane in which the optics show both pictures; infinite for
 *     collimated optics. What is drawn at that distance has no disparity on the display
 * @param leftOffset metres by which the left eye lies beside its nominal place (half the
 *     interpupillary distance to the left): right, up, back
 * @param rightOffset likewise
 * @param leftScreen number of the monitor that the left eye sees, counted from 0
 * @param rightScreen likewise
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
   * taken for granted, not measured.
   */
  public static final DisplayProfile PROVIEW_50 = proView("ProView 50", 640, 480);

  /** Kaiser Electro-Optics ProView 30, XGA (thesis 2.4.2); 50 degrees from corner to corner. */
  public static final DisplayProfile PROVIEW_30 = proView("ProView 30", 1024, 768);

  /**
   * A monitor on a desk, for checks without a head-mounted display: 50 degrees from corner to
   * corner. What is two metres away lies in the screen, so that nothing in a room is far off it.
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
          "a display needs pixels, and its screens are counted from 0");
    }
    if (!(overlap > 0 && overlap <= 1) || !(imageDistance > 0)) {
      throw new IllegalArgumentException(
          "the overlap must be above 0 and at most 1, and the image in front of the eyes");
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

  /** The monitor that an eye sees, counted from 0. */
  public int screen(Eye eye) {
    return eye == Eye.LEFT ? leftScreen : rightScreen;
  }
}
