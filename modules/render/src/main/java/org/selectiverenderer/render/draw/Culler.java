package org.selectiverenderer.render.draw;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.DrawProperties;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.mesh.TriangleClusters;
import org.selectiverenderer.render.occlusion.MeshOccluders;
import org.selectiverenderer.render.occlusion.OcclusionCuller;

/**
 * Finds what at least one eye can see: first shapes, whose bounding boxes are tested against each
 * eye's frustum and occluders; then, within a shape, triangle clusters, which are left out if they
 * are outside of every frustum, occluded or, when the shape is solid, facing away from all eyes.
 * Conservative. Makes no GL calls.
 *
 * <p>A frame is {@link #begin}, then for a large scene {@link #missing} and {@code begin} again as
 * long as something is missing, whose items the caller makes, then {@link #finish}; {@link #cull}
 * where all items are there.
 *
 * <p>Visible items are sorted by program and texture, then front to back, which saves the shading
 * of covered pixels; a batch has the place of its nearest item.
 */
final class Culler {
  /** Draw items by number, in the order of their shapes, and a search for those in view. */
  interface Items {
    /** Returns a number that is greater than that of any item. */
    int size();

    /** Returns the item of a number that {@link #search} has reported. */
    DrawItem get(int number);

    /**
     * Reports the numbers of all items that may be in boxes that a test enters, each once and in
     * any order.
     */
    void search(Bvh.BoxTest test, IntConsumer found);

    /**
     * Returns the greatest of {@link MeshOccluders#terms} of the items, and so the rounding error
     * of drawing any of them.
     */
    double terms();

    /** Returns the greatest number of pixels by which an item reaches beyond its box. */
    double pixels();

    /**
     * Returns the numbers of shown shapes that have no item yet and are in boxes that a test
     * enters.
     *
     * @param visible receives each one's box; those for which it returns false are left out
     */
    BitSet missing(Bvh.BoxTest test, Predicate<double[]> visible);

    /** Returns whether all shapes have items. */
    boolean complete();

    /** Returns a list as items, of which each search reports all. */
    static Items of(List<DrawItem> list) {
      return new Items() {
        @Override
        public int size() {
          return list.size();
        }

        @Override
        public DrawItem get(int number) {
          return list.get(number);
        }

        @Override
        public double terms() {
          return Double.POSITIVE_INFINITY;
        }

        @Override
        public double pixels() {
          return 0;
        }

        @Override
        public BitSet missing(Bvh.BoxTest test, Predicate<double[]> visible) {
          return new BitSet();
        }

        @Override
        public boolean complete() {
          return true;
        }

        @Override
        public void search(Bvh.BoxTest test, IntConsumer found) {
          for (int i = 0; i < list.size(); i++) {
            found.accept(i);
          }
        }
      };
    }
  }

  /** Shapes with fewer clusters are not tested cluster by cluster. */
  private static final int FEWEST_CLUSTERS = 2;

  /**
   * The pixels by which points and lines of the usual width may reach beyond their bounding box.
   */
  private static final double LOOSE_PIXELS = 4;

  /** Counted as so many hidden indices: a hidden box of more shapes than a leaf has. */
  private static final long HIDDEN_BOX = 6000;

  private final VisibleSet out;
  private final RefinementLevelSelector stages = new RefinementLevelSelector();
  private final Matrix4d inverse = new Matrix4d();
  private List<Camera> eyes = List.of();
  private Frustum[] frusta = {};
  private Frustum[] local = {};
  private Vector3dc[] worldEyes = {};
  private Vector3d[] localEyes = {};
  private final double[] box = new double[6];
  private boolean apart;
  private long[] order = new long[16];
  private int inView;
  private int[] next = new int[16];
  private @Nullable OcclusionCuller occlusion;
  private long hidden;

  /**
   * @param out receives the visible items
   */
  Culler(VisibleSet out) {
    this.out = out;
  }

  /**
   * Fills the visible set with what at least one eye sees of the items, all of which are there.
   *
   * @param hiding the occlusion test, or null to keep what is hidden behind other things
   */
  void cull(Items items, List<Camera> seeing, @Nullable OcclusionCuller hiding) {
    begin(items, seeing, hiding);
    finish(items);
  }

  /**
   * Begins a frame; what is hidden is decided by the items that there are now.
   *
   * @param hiding the occlusion test, or null to keep what is hidden behind other things
   */
  void begin(Items items, List<Camera> seeing, @Nullable OcclusionCuller hiding) {
    look(seeing);
    if (next.length < items.size()) {
      next = new int[2 * items.size()];
      order = new long[2 * items.size()];
    }
    occlusion = hiding != null && occlude(items, hiding) ? hiding : null;
    if (occlusion != null) {
      occlusion.ask(items.terms());
    }
  }

  /** Returns the numbers of shapes that an eye may see and that have no items. */
  BitSet missing(Items items) {
    double pixels = items.pixels();
    return items.missing(
        inView(pixels),
        of -> side(of) != Frustum.Side.OUTSIDE && (occlusion == null || !hides(of, pixels)));
  }

  /** Fills the visible set with what at least one eye sees of the items. */
  void finish(Items items) {
    out.clear();
    hidden = 0;
    findInView(items, inView(items.pixels()));
    fill(items);
    if (occlusion != null) {
      occlusion.end(hidden, out.indices());
    }
  }

  /**
   * Puts the numbers of the items in some eye's frustum into the order, by size.
   *
   * @param test leaves out boxes of which no eye sees anything
   */
  private void findInView(Items items, Bvh.BoxTest test) {
    inView = 0;
    items.search(
        test,
        i -> {
          DrawItem item = items.get(i);
          if (item.shape().shown()
              && !(apart && item.shape().fading())
              && (side(item.shape().bounds()) != Frustum.Side.OUTSIDE || item.anywhere())) {
            order[inView++] = i;
          }
        });
    Arrays.sort(order, 0, inView);
  }

  private boolean enters(float[] boxes, int at, boolean leaf) {
    for (int i = 0; i < box.length; i++) {
      box[i] = boxes[at + i];
    }
    return side(box) != Frustum.Side.OUTSIDE;
  }

  /**
   * Returns a test that leaves out boxes that are out of view or hidden; items of leaves are asked
   * later.
   */
  private Bvh.BoxTest inView(double pixels) {
    return (boxes, at, leaf) -> {
      if (!enters(boxes, at, leaf)) {
        return false;
      }
      if (leaf || occlusion == null || !hides(box, pixels)) {
        return true;
      }
      hidden += HIDDEN_BOX;
      return false;
    };
  }

  private boolean occlude(Items items, OcclusionCuller hiding) {
    hiding.begin(eyes, !items.complete());
    findInView(items, (boxes, at, leaf) -> enters(boxes, at, leaf) && hiding.offers(box));
    for (int i = 0; i < inView; i++) {
      DrawItem item = items.get((int) order[i]);
      if (item.opaque()) {
        hiding.offer(item.part().occluders(), item.place(), item.shape().bounds());
      }
    }
    return hiding.cover();
  }

  private void fill(Items items) {
    int count = 0;
    for (int at = 0; at < inView; at++) {
      int i = (int) order[at];
      DrawItem item = items.get(i);
      if (hides(item)) {
        hidden += item.clusters().indexCount();
        continue;
      }
      DrawBatch batch = item.part().batch();
      if (batch == null) {
        order[count++] = DrawSortKey.key(item, DrawSortKey.distance(item, eyes), i);
      } else if (string(batch, i, DrawSortKey.distance(item, eyes))) {
        order[count++] = i;
      }
    }
    for (int i = 0; i < count; i++) {
      // The sort key of a batch is known only when all its items are.
      DrawItem item = items.get((int) order[i] & DrawSortKey.INDEX_MASK);
      DrawBatch batch = item.part().batch();
      order[i] = batch == null ? order[i] : DrawSortKey.key(item, batch.nearest, batch.first);
    }
    Arrays.sort(order, 0, count);
    for (int i = 0; i < count; i++) {
      add(items, (int) order[i] & DrawSortKey.INDEX_MASK);
    }
    // Items of which all clusters were culled stay in the list with no index range.
  }

  private boolean hides(DrawItem item) {
    if (occlusion == null || item.anywhere()) {
      return false;
    }
    occlusion.ask(item.place(), item.part().occluders());
    return hides(item.shape().bounds(), pixels(item.stroke(), item.source().primitive()));
  }

  private boolean hides(double[] of, double pixels) {
    for (int eye = 0; eye < frusta.length; eye++) {
      if (!occlusion.hides(eye, of, pixels)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the pixels by which a shape may reach beyond its box: 0 for triangles. */
  static double pixels(DrawProperties stroke, Mesh.Primitive primitive) {
    return StrokePatterns.reach(stroke, primitive, LOOSE_PIXELS);
  }

  private void look(List<Camera> seeing) {
    eyes = seeing;
    stages.begin(seeing);
    frusta = eyes.stream().map(Frustum::of).toArray(Frustum[]::new);
    worldEyes = eyes.stream().map(Camera::eye).toArray(Vector3dc[]::new);
    if (local.length != frusta.length) {
      local = eyes.stream().map(eye -> new Frustum()).toArray(Frustum[]::new);
      localEyes = eyes.stream().map(eye -> new Vector3d()).toArray(Vector3d[]::new);
    }
  }

  /**
   * Appends an item to the linked list of its batch's visible items; returns true for the first.
   */
  private boolean string(DrawBatch batch, int index, int distance) {
    boolean first = batch.first < 0;
    if (first) {
      batch.first = index;
    } else {
      next[batch.last] = index;
    }
    batch.last = index;
    batch.nearest = Math.min(batch.nearest, distance);
    return first;
  }

  /** Adds an item, or all visible items of its batch in the order of the index buffer. */
  private void add(Items items, int index) {
    DrawBatch batch = items.get(index).part().batch();
    if (batch == null) {
      add(items.get(index));
      return;
    }
    for (int i = index; i != batch.last; i = next[i]) {
      add(items.get(i));
    }
    add(items.get(batch.last));
    batch.forget();
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
    TriangleClusters clusters = stages.of(item);
    out.begin(item, clusters.indexCount());
    int indexBytes = item.mesh().indexBytes();
    boolean few = clusters.size() < FEWEST_CLUSTERS || item.blended() || item.anywhere();
    boolean twoSided = !item.mesh().solid() && item.surface().lit();
    Matrix4dc place = item.place();
    boolean known = (!few || twoSided) && place.invertAffine(inverse).isFinite();
    for (int eye = 0; known && eye < frusta.length; eye++) {
      inverse.transformPosition(worldEyes[eye], localEyes[eye]);
    }
    if (twoSided && !(known && fronts(clusters))) {
      out.backs();
    }
    if (few) {
      out.range(clusters.firstIndex()[0], clusters.indexCount(), indexBytes);
      return;
    }
    boolean all = eyes.size() == 1 && side(item.shape().bounds()) == Frustum.Side.INSIDE;
    boolean solid = item.mesh().solid() && known;
    for (int eye = 0; eye < frusta.length; eye++) {
      frusta[eye].local(place, local[eye]);
    }
    if (occlusion != null) {
      occlusion.ask(place, item.part().occluders());
      occlusion.enter(place);
    }
    int[] first = clusters.firstIndex();
    for (int c = 0; c < clusters.size(); c++) {
      if (seen(clusters, c, all, solid)) {
        out.range(first[c], first[c + 1] - first[c], indexBytes);
      }
    }
  }

  /**
   * Leaves out shapes that are being faded from now on, which are then neither found nor hide
   * anything.
   */
  void withoutFading() {
    apart = true;
  }

  /** Adds the whole of an item to another set, if it may be in view of the eyes of the frame. */
  void addWhole(DrawItem item, VisibleSet to) {
    if (side(item.shape().bounds()) == Frustum.Side.OUTSIDE && !item.anywhere()) {
      return;
    }
    TriangleClusters clusters = stages.of(item);
    to.begin(item, clusters.indexCount());
    if (!item.mesh().solid()) {
      to.backs();
    }
    to.range(clusters.firstIndex()[0], clusters.indexCount(), item.mesh().indexBytes());
  }

  /** Returns whether all clusters face every eye with their front sides. */
  private boolean fronts(TriangleClusters clusters) {
    for (int c = 0; c < clusters.size(); c++) {
      for (Vector3d at : localEyes) {
        if (!clusters.facesTowards(c, at.x, at.y, at.z)) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean seen(TriangleClusters clusters, int cluster, boolean inside, boolean solid) {
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

  /** Encodes the drawing order as integer sort keys. */
  private static final class DrawSortKey {
    private static final int INDEX_BITS = 24;

    /** The bits of a key that hold the item's index in the list. */
    static final int INDEX_MASK = (1 << INDEX_BITS) - 1;

    private DrawSortKey() {}

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
     * Returns the depth from the nearest eye: to the centre of a blended item's bounding box, to
     * the far end of other boxes. So walls, whose boxes enclose everything else, are drawn last and
     * fill only the pixels that are left.
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
}
