package org.selectiverenderer.runtime.render.draw;

import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.runtime.render.gpu.GpuMesh;
import org.selectiverenderer.runtime.render.mesh.Clusters;
import org.selectiverenderer.runtime.render.occlude.Occlusion;

/**
 * Finds what some eye can see: by the boxes of shapes, in its frustum and not behind others, then,
 * within a shape, by clusters of triangles outside of every eye's frustum, hidden or, when the
 * shape is solid, turned away from all eyes. Keeps too much rather than too little. Makes no GL
 * calls.
 */
final class Culler {
  /** Fewer clusters are not worth looking at. */
  private static final int FEWEST_CLUSTERS = 2;

  /** How far points and lines reach beyond their box in the picture, at most. */
  private static final double LOOSE_PIXELS = 4;

  private final Visible out;
  private @Nullable Occlusion occlusion;
  private final List<Camera> eyes;
  private final Frustum[] frusta;
  private final Frustum[] local;
  private final Vector3d[] localEyes;
  private final Matrix4d inverse = new Matrix4d();
  private long hidden;

  private Culler(Visible out, List<Camera> eyes) {
    this.out = out;
    this.eyes = eyes;
    frusta = eyes.stream().map(Frustum::of).toArray(Frustum[]::new);
    local = new Frustum[frusta.length];
    localEyes = eyes.stream().map(eye -> new Vector3d()).toArray(Vector3d[]::new);
  }

  /**
   * Fills the list with what of the items some eye sees.
   *
   * @param occlusion null to keep what is hidden behind other things
   */
  static void cull(
      List<DrawItem> items, List<Camera> eyes, @Nullable Occlusion occlusion, Visible out) {
    out.clear();
    long[] order = new long[items.size()];
    Culler culler = new Culler(out, eyes);
    int count = culler.inView(items, order);
    if (occlusion != null && occlude(items, order, count, eyes, occlusion)) {
      culler.occlusion = occlusion;
    }
    culler.fill(items, order, count);
    if (culler.occlusion != null) {
      culler.occlusion.end(culler.hidden, out.indices());
    }
  }

  /** Which items lie in some eye's frustum. */
  private int inView(List<DrawItem> items, long[] indices) {
    int count = 0;
    for (int i = 0; i < items.size(); i++) {
      DrawItem item = items.get(i);
      if (item.shape().shown() && side(item.shape().bounds()) != Frustum.Side.OUTSIDE) {
        indices[count++] = i;
      }
    }
    return count;
  }

  private static boolean occlude(
      List<DrawItem> items, long[] indices, int count, List<Camera> eyes, Occlusion occlusion) {
    occlusion.begin(eyes);
    for (int i = 0; i < count; i++) {
      DrawItem item = items.get((int) indices[i]);
      if (item.opaque()) {
        occlusion.offer(item.mesh().occluders(), item.shape().world(), item.shape().bounds());
      }
    }
    return occlusion.cover();
  }

  private void fill(List<DrawItem> items, long[] order, int inView) {
    int count = 0;
    for (int i = 0; i < inView; i++) {
      DrawItem item = items.get((int) order[i]);
      if (hidden(item)) {
        hidden += item.mesh().indexCount();
      } else {
        order[count++] = key(item, (int) order[i]);
        out.opaque += item.blended() ? 0 : 1;
      }
    }
    Arrays.sort(order, 0, count);
    for (int i = 0; i < count; i++) {
      add(items.get((int) order[i] & INDEX_MASK));
    }
    // Clusters may have emptied items; those stay in the list without stretches.
  }

  private boolean hidden(DrawItem item) {
    if (occlusion == null) {
      return false;
    }
    occlusion.ask(item.shape().world(), item.source().bounds());
    double pixels = item.source().primitive() == Mesh.Primitive.TRIANGLES ? 0 : LOOSE_PIXELS;
    for (int eye = 0; eye < frusta.length; eye++) {
      if (!occlusion.hides(eye, item.shape().bounds(), pixels)) {
        return false;
      }
    }
    return true;
  }

  private static final int INDEX_BITS = 24;
  private static final int INDEX_MASK = (1 << INDEX_BITS) - 1;

  /**
   * The order of drawing as a number: opaque before blended; opaque ones by program and texture,
   * then front to back, which spares covered pixels; blended ones back to front. Sixteen bits of
   * rank, 23 of distance, 24 of place in the list.
   */
  private long key(DrawItem item, int index) {
    double[] box = item.shape().bounds();
    double nearest = Double.POSITIVE_INFINITY;
    for (Camera eye : eyes) {
      double x = (box[0] + box[3]) / 2;
      double y = (box[1] + box[4]) / 2;
      double z = (box[2] + box[5]) / 2;
      Matrix4dc v = eye.view();
      nearest = Math.min(nearest, -(v.m02() * x + v.m12() * y + v.m22() * z + v.m32()));
    }
    // The bits of a float that is not negative are in the order of its values.
    int distance = Float.floatToIntBits((float) Math.max(0, nearest)) >>> 8;
    long rank = item.blended() ? (1L << 15) : Math.min(item.rank(), (1 << 15) - 1);
    long depth = item.blended() ? (1 << 23) - 1 - distance : distance;
    return rank << (23 + INDEX_BITS) | depth << INDEX_BITS | index;
  }

  private Frustum.Side side(double[] box) {
    if (box[0] > box[3]) {
      return Frustum.Side.OUTSIDE;
    }
    Frustum.Side best = Frustum.Side.OUTSIDE;
    for (Frustum frustum : frusta) {
      Frustum.Side side = frustum.side(box);
      if (side == Frustum.Side.INSIDE) {
        return side;
      }
      best = side == Frustum.Side.ACROSS ? side : best;
    }
    return best;
  }

  private void add(DrawItem item) {
    GpuMesh mesh = item.mesh();
    if (mesh.clusters().size() < FEWEST_CLUSTERS || item.blended()) {
      out.range(0, mesh.indexCount());
    } else {
      Matrix4dc world = item.shape().world();
      boolean all = eyes.size() == 1 && side(item.shape().bounds()) == Frustum.Side.INSIDE;
      boolean solid = mesh.solid() && world.invertAffine(inverse).isFinite();
      for (int eye = 0; eye < frusta.length; eye++) {
        local[eye] = frusta[eye].local(world);
        if (solid) {
          inverse.transformPosition(eyes.get(eye).eye(), localEyes[eye]);
        }
      }
      if (occlusion != null) {
        occlusion.ask(world, item.source().bounds());
        occlusion.enter(world);
      }
      clusters(mesh, all, solid);
    }
    out.add(item);
  }

  private void clusters(GpuMesh mesh, boolean inside, boolean solid) {
    Clusters clusters = mesh.clusters();
    int[] first = clusters.firstIndex();
    int start = -1;
    for (int c = 0; c < clusters.size(); c++) {
      if (seen(clusters, c, inside, solid)) {
        start = start < 0 ? first[c] : start;
      } else if (start >= 0) {
        out.range((long) start * mesh.indexBytes(), first[c] - start);
        start = -1;
      }
    }
    if (start >= 0) {
      int end = first[clusters.size()];
      out.range((long) start * mesh.indexBytes(), end - start);
    }
  }

  private boolean seen(Clusters clusters, int cluster, boolean inside, boolean solid) {
    boolean behind = false;
    for (int eye = 0; eye < local.length; eye++) {
      Vector3d at = localEyes[eye];
      if ((!solid || !clusters.facesAway(cluster, at.x, at.y, at.z))
          && (inside || !local[eye].outside(clusters.spheres(), 4 * cluster))) {
        if (occlusion == null || !occlusion.hides(eye, clusters.spheres(), 4 * cluster)) {
          return true;
        }
        behind = true;
      }
    }
    hidden += behind ? clusters.firstIndex()[cluster + 1] - clusters.firstIndex()[cluster] : 0;
    return false;
  }
}
