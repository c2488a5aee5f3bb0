package org.selectiverenderer.runtime.render.draw;

import java.util.List;
import org.joml.Matrix4dc;
import org.selectiverenderer.runtime.camera.Camera;

/** Encodes the drawing order as integer sort keys. */
final class DrawOrder {
  private static final int INDEX_BITS = 24;

  /** The bits of a key that hold the item's index in the list. */
  static final int INDEX_MASK = (1 << INDEX_BITS) - 1;

  private DrawOrder() {}

  /**
   * Returns the sort key of an item: opaque before blended; opaque items by program and texture,
   * then front to back, which saves the shading of covered pixels; blended items back to front.
   * Sixteen bits hold the rank, 23 the distance, 24 the index in the list.
   */
  static long key(DrawItem item, int distance, int index) {
    long rank = item.blended() ? (1L << 15) : Math.min(item.rank(), (1 << 15) - 1);
    long depth = item.blended() ? (1 << 23) - 1 - distance : distance;
    return rank << (23 + INDEX_BITS) | depth << INDEX_BITS | index;
  }

  /**
   * Returns the depth from the nearest eye: to the centre of a blended item's bounding box, to the
   * far end of other boxes. So walls, whose boxes enclose everything else, are drawn last and fill
   * only the pixels that are left.
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
