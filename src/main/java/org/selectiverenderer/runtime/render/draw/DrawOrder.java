package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.camera.Camera;

/** The order of drawing, as numbers to sort by. */
final class DrawOrder {
  private static final int INDEX_BITS = 24;

  /** What of a number is the place in the list. */
  static final int INDEX_MASK = (1 << INDEX_BITS) - 1;

  private DrawOrder() {}

  /**
   * The order of drawing as a number: opaque before blended; opaque ones by program and texture,
   * then front to back, which spares covered pixels; blended ones back to front. Sixteen bits of
   * rank, 23 of distance, 24 of place in the list.
   */
  static long key(DrawItem item, int distance, int index) {
    long rank = item.blended() ? (1L << 15) : Math.min(item.rank(), (1 << 15) - 1);
    long depth = item.blended() ? (1 << 23) - 1 - distance : distance;
    return rank << (23 + INDEX_BITS) | depth << INDEX_BITS | index;
  }

  /**
   * From the nearest eye along the line of sight: of a blended item to the middle of its box, of
   * others to the far end. So walls, whose boxes reach from before all else to behind it, come last
   * and fill only what is left.
   */
  static int distance(DrawItem item, List<Camera> eyes) {
    double[] box = item.shape().bounds();
    double nearest = Double.POSITIVE_INFINITY;
    for (int eye = 0; eye < eyes.size(); eye++) {
      double x = (box[0] + box[3]) / 2;
      double y = (box[1] + box[4]) / 2;
      double z = (box[2] + box[5]) / 2;
      Matrix4dc v = eyes.get(eye).view();
      double middle = -(v.m02() * x + v.m12() * y + v.m22() * z + v.m32());
      double half =
          Math.abs(v.m02()) * (box[3] - box[0])
              + Math.abs(v.m12()) * (box[4] - box[1])
              + Math.abs(v.m22()) * (box[5] - box[2]);
      nearest = Math.min(nearest, item.blended() ? middle : middle + half / 2);
    }
    // The bits of a float that is not negative are in the order of its values.
    return Float.floatToIntBits((float) Math.max(0, nearest)) >>> 8;
  }
}
