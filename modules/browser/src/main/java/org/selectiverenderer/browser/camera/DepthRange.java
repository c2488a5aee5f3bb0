package org.selectiverenderer.browser.camera;

import org.joml.Vector3dc;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;

/**
 * The distances of the near and far clipping planes.
 *
 * @param near the near plane's distance, above 0
 * @param far the far plane's distance, above {@code near}
 */
public record DepthRange(double near, double far) {
  /** Largest ratio of far to near; beyond it a 24-bit depth buffer is too coarse at a distance. */
  private static final double MOST = 1e5;

  /** Depth along the view axis per distance from the eye, at the edge of a view of 120 degrees. */
  private static final double ALONG_AXIS = 0.5;

  /**
   * Returns the range from half the avatar's collision distance to the visibility limit, or to the
   * farthest shape if there is no limit (X3D 4.0, 23.4.4: NavigationInfo). If that is very far, the
   * near plane moves away from the eye too, but not beyond the nearest shape.
   *
   * @param avatarRadius the first element of avatarSize
   * @param visibilityLimit the visibility limit; 0 for none
   */
  public static DepthRange of(
      InstanceTree tree, Vector3dc eye, double avatarRadius, double visibilityLimit) {
    return of(tree, eye, avatarRadius, visibilityLimit, false);
  }

  /**
   * Returns the range as above.
   *
   * @param whole whether all of the scene is to be in view, however small it is: the near plane is
   *     then at most at a hundredth of the distance to the farthest shape
   */
  public static DepthRange of(
      InstanceTree tree,
      Vector3dc eye,
      double avatarRadius,
      double visibilityLimit,
      boolean whole) {
    double near = Math.max(avatarRadius / 2, 1e-6);
    if (visibilityLimit > near) {
      return new DepthRange(near, visibilityLimit);
    }
    double farthest = farthest(tree, eye);
    if (whole && farthest > 0) {
      near = Math.max(1e-6, Math.min(near, Math.sqrt(farthest) / 100));
    }
    double far = Math.max(near * 100, Math.sqrt(farthest) * 1.01);
    if (far > near * MOST) {
      near = Math.max(near, Math.min(far / MOST, nearest(tree, eye) * ALONG_AXIS));
    }
    return new DepthRange(near, far);
  }

  /** Returns the square of the distance to the farthest corner of a bounding box. */
  private static double farthest(InstanceTree tree, Vector3dc eye) {
    double[] box = new double[6];
    return tree.boxes()
        .greatest(
            (boxes, at) -> farthest(copy(boxes, at, box), eye),
            i -> {
              ShapeInstance shape = tree.shapes().get(i);
              return shape.shown() ? farthest(shape.bounds(), eye) : 0;
            },
            0);
  }

  /**
   * Returns the distance to the nearest bounding box; from inside a box, the distance to its faces.
   */
  private static double nearest(InstanceTree tree, Vector3dc eye) {
    double[] box = new double[6];
    return -tree.boxes()
        .greatest(
            (boxes, at) -> -outside(copy(boxes, at, box), eye),
            i -> {
              ShapeInstance shape = tree.shapes().get(i);
              return shape.shown() && shape.bounds()[0] <= shape.bounds()[3]
                  ? -distance(shape.bounds(), eye)
                  : Double.NEGATIVE_INFINITY;
            },
            Double.NEGATIVE_INFINITY);
  }

  private static double[] copy(float[] boxes, int at, double[] box) {
    for (int i = 0; i < box.length; i++) {
      box[i] = boxes[at + i];
    }
    return box;
  }

  /** Returns the distance to a box, 0 from inside: no box within it is nearer. */
  private static double outside(double[] box, Vector3dc eye) {
    return Math.hypot(
        Math.max(0, Math.max(box[0] - eye.x(), eye.x() - box[3])),
        Math.hypot(
            Math.max(0, Math.max(box[1] - eye.y(), eye.y() - box[4])),
            Math.max(0, Math.max(box[2] - eye.z(), eye.z() - box[5]))));
  }

  private static double distance(double[] box, Vector3dc eye) {
    double x = Math.max(box[0] - eye.x(), eye.x() - box[3]);
    double y = Math.max(box[1] - eye.y(), eye.y() - box[4]);
    double z = Math.max(box[2] - eye.z(), eye.z() - box[5]);
    double inside = Math.max(x, Math.max(y, z));
    return inside <= 0
        ? -inside
        : Math.hypot(Math.max(0, x), Math.hypot(Math.max(0, y), Math.max(0, z)));
  }

  private static double farthest(double[] box, Vector3dc eye) {
    if (box[0] > box[3]) {
      return 0;
    }
    double x = Math.max(Math.abs(box[0] - eye.x()), Math.abs(box[3] - eye.x()));
    double y = Math.max(Math.abs(box[1] - eye.y()), Math.abs(box[4] - eye.y()));
    double z = Math.max(Math.abs(box[2] - eye.z()), Math.abs(box[5] - eye.z()));
    return x * x + y * y + z * z;
  }
}
