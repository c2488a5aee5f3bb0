package org.selectiverenderer.hmd;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.selectiverenderer.apparatus.Eye;
import org.selectiverenderer.apparatus.EyeFrustum;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.camera.EyeView;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.camera.ViewLayout;

/**
 * A test pattern for each eye that is shown instead of the world to check a display ({@code run
 * --hmd-check}):
 *
 * <ul>
 *   <li>a frame at the picture's very edge: all four sides must be visible;
 *   <li>the name of the eye in a corner: with the other eye closed, the right name must be visible;
 *   <li>lines every 5 degrees, labelled every 10 degrees: they measure the field of view, with a
 *       protractor or by turning the tracker by a known angle;
 *   <li>a circle of 10 degrees radius about the centre: round if the aspect ratio is right;
 *   <li>three squares of 10 cm at 1, 2 and 4 m: with both eyes each must be seen as one, in this
 *       order of depth; the nearest must look as wide as a real 10 cm square held at 1 m.
 * </ul>
 *
 * @param layout the layout of the two views
 */
record DisplayTestPattern(StereoLayout layout) implements ViewLayout {
  private static final int FRAME = 0xffffffff;
  private static final int FINE = 0xff2f6f3f;
  private static final int COARSE = 0xff55c878;
  private static final int CIRCLE = 0xffe6b84c;
  private static final int[] SQUARES = {0xffff6b5e, 0xff6ea8fe, 0xffd58cff};
  private static final double[] DISTANCES = {1, 2, 4};
  private static final double SIDE = 0.1;
  private static final int STEP = 5;
  private static final int ROUND = 72;

  /** One eye's picture. */
  private record Page(EyeFrustum frustum, double width, double height, List<Primitive2D> marks) {
    /** Returns the pixel position of a direction, given by its tangents from the head's axis. */
    double[] at(double x, double y) {
      Vector2d seen = frustum.project(new Vector3d(x, y, -1));
      return new double[] {(1 + seen.x) / 2 * width, (1 - seen.y) / 2 * height};
    }

    void line(double[] a, double[] b, double thick, int color) {
      marks.add(new Primitive2D.Line(a[0], a[1], b[0], b[1], thick, color));
    }

    void text(String text, double x, double y, double size, int color) {
      marks.add(new Primitive2D.Text(text, x, y, size, color));
    }
  }

  @Override
  public List<EyeView> views(World world, int width, int height, DepthRange range) {
    return layout.views(world, width, height, range);
  }

  @Override
  public boolean showsWorld() {
    return false;
  }

  @Override
  public List<Primitive2D> marks(int view, int width, int height) {
    Eye eye = Eye.values()[view];
    Page page = new Page(layout.geometry().frustum(eye), width, height, new ArrayList<>());
    degrees(page);
    circle(page);
    squares(page, eye);
    // Only the outermost pixels, so that a side that the display cuts off is noticed at once.
    page.line(new double[] {0, 0.5}, new double[] {width, 0.5}, 1, FRAME);
    page.line(new double[] {0, height - 0.5}, new double[] {width, height - 0.5}, 1, FRAME);
    page.line(new double[] {0.5, 0}, new double[] {0.5, height}, 1, FRAME);
    page.line(new double[] {width - 0.5, 0}, new double[] {width - 0.5, height}, 1, FRAME);
    double size = height / 14.0;
    page.text(eye.name(), eye == Eye.LEFT ? size / 2 : width - 3.6 * size, 1.4 * size, size, FRAME);
    return page.marks();
  }

  private static void degrees(Page page) {
    EyeFrustum frustum = page.frustum();
    double letters = page.height() / 36;
    for (int degrees = -85; degrees <= 85; degrees += STEP) {
      double tangent = Math.tan(Math.toRadians(degrees));
      boolean coarse = degrees % (2 * STEP) == 0;
      int color = coarse ? COARSE : FINE;
      double thick = coarse ? 2 : 1;
      if (tangent > frustum.left() && tangent < frustum.right()) {
        double[] top = page.at(tangent, frustum.top());
        page.line(top, page.at(tangent, frustum.bottom()), thick, color);
        if (coarse && top[0] < page.width() - 3 * letters) {
          page.text(figure(degrees), top[0] + 3, page.height() - 6, letters, color);
        }
      }
      if (tangent > frustum.bottom() && tangent < frustum.top()) {
        double[] left = page.at(frustum.left(), tangent);
        page.line(left, page.at(frustum.right(), tangent), thick, color);
        if (coarse) {
          page.text(figure(degrees), 5, left[1] - 3, letters, color);
        }
      }
    }
  }

  private static String figure(int degrees) {
    return degrees + "\u00b0";
  }

  private static void circle(Page page) {
    double radius = Math.tan(Math.toRadians(10));
    for (int i = 0; i < ROUND; i++) {
      double a = 2 * Math.PI * i / ROUND;
      double b = 2 * Math.PI * (i + 1) / ROUND;
      page.line(
          page.at(radius * Math.cos(a), radius * Math.sin(a)),
          page.at(radius * Math.cos(b), radius * Math.sin(b)),
          2,
          CIRCLE);
    }
  }

  private void squares(Page page, Eye eye) {
    Vector3d at = layout.geometry().position(eye);
    for (int i = 0; i < DISTANCES.length; i++) {
      double distance = DISTANCES[i];
      // Side by side in the centre of the view, whatever their distance.
      double x = distance * (0.15 * i - 0.15);
      double[] corners = new double[8];
      int[][] sides = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
      for (int corner = 0; corner < 4; corner++) {
        Vector3d point =
            new Vector3d(x + sides[corner][0] * SIDE / 2, sides[corner][1] * SIDE / 2, -distance)
                .sub(at);
        double[] seen = page.at(point.x / -point.z, point.y / -point.z);
        corners[2 * corner] = seen[0];
        corners[2 * corner + 1] = seen[1];
      }
      page.marks().add(new Primitive2D.Area(corners, SQUARES[i]));
      page.text(
          String.format(Locale.ROOT, "%.0f m", distance),
          corners[0],
          corners[1] + page.height() / 22,
          page.height() / 30,
          SQUARES[i]);
    }
  }
}
