package org.selectiverenderer.render.draw;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntConsumer;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.lighting.LightingPlanner;

/**
 * The shapes of an instance tree whose draw items are made later, and when that is. {@link
 * DrawItemCache} has the items.
 *
 * <p>The shapes of a large scene wait until an eye sees them or comes near ({@link UnseenShapes}):
 * so the memory and the first frame depend on what is seen and near, not on what there is. A group
 * of neighbours of which a shape is seen gets the items of its shown shapes in that frame, those of
 * its hidden ones as if they were new.
 *
 * <p>New shapes may be spread over the following frames, as many in each as {@link UploadBudget}
 * allows. A deferred hidden shape that becomes shown comes in that very frame. If more shown shapes
 * come into a running scene than one frame can upload, the rest appears in the next frames, as if
 * they had come in several files; shapes that were in the tree before are never late.
 *
 * <p>Shapes are numbered by their place in {@link InstanceTree#shapes()}.
 */
final class DeferredShapes {
  /** The least number of triangles that one shape counts for. */
  private static final int LEAST_OF_ONE = 40;

  private final GpuResourceCache assets;
  private final UnseenShapes unseen;
  private final UploadBudget budget = new UploadBudget();
  private @Nullable InstanceTree tree;
  private List<ShapeInstance> shapes = List.of();
  private final BitSet waiting = new BitSet();
  private final BitSet late = new BitSet(); // The waiting shapes that came shown.
  private final BitSet inView = new BitSet(); // The groups of which some item is in view.
  private Vector3dc eye = new Vector3d();

  /** The meshes of waiting shapes that are being packed. */
  private final Map<ShapeInstance, Mesh> packing = new IdentityHashMap<>();

  DeferredShapes(GpuResourceCache assets, UnseenShapes.Limits limits) {
    this.assets = assets;
    unseen = new UnseenShapes(limits);
  }

  /** Bounds the rounding error of drawing any unseen one, as {@link Culler.Items#terms}. */
  double terms() {
    return unseen.terms();
  }

  /** Bounds the pixels by which any unseen one reaches beyond its box. */
  double pixels() {
    return unseen.pixels();
  }

  /** Returns whether no shape waits until it is seen. */
  boolean allSeen() {
    return unseen.isEmpty();
  }

  /**
   * Follows a change of a shape.
   *
   * @return whether it has no item yet, because its turn comes later
   */
  boolean changed(int place) {
    if (unseen.contains(place)) {
      unseen.changed(place);
    }
    return waiting.get(place) || unseen.contains(place);
  }

  /** Returns the places of the shown shapes that wait until they are seen, and are now. */
  BitSet missing(Bvh.BoxTest test, Predicate<double[]> visible) {
    BitSet found = new BitSet();
    if (tree != null) {
      tree.boxes()
          .search(
              test,
              place -> {
                if (unseen.contains(place)
                    && shapes.get(place).shown()
                    && visible.test(shapes.get(place).bounds())) {
                  found.set(place);
                }
              });
    }
    return found;
  }

  /**
   * Takes the shown shapes of groups that are seen; the hidden ones follow.
   *
   * @param places of shapes that are seen
   * @param from the place of the eye in the world
   * @param most the most groups for which that is done now; the nearest
   */
  Arrivals see(BitSet places, Vector3dc from, int most) {
    Arrivals arrivals = new Arrivals(Long.MAX_VALUE);
    int[] groups = unseen.groups(places, from);
    for (int i = 0; i < Math.min(most, groups.length); i++) {
      unseen
          .unseen(groups[i])
          .forEach(
              place -> {
                if (shapes.get(place).shown()) {
                  arrivals.take(place);
                } else {
                  await(place);
                }
              });
    }
    return arrivals;
  }

  /** Notes what is seen in a frame, and from where, by which the next decides what to keep. */
  void seen(VisibleSet visible, Vector3dc from) {
    eye = new Vector3d(from);
    inView.clear();
    if (unseen.grouped()) {
      note(visible);
      visible.fading.forEach(version -> note(version.items()));
    }
  }

  private void note(VisibleSet visible) {
    visible.calls.forEach(item -> inView.set(unseen.group(item.shape().index())));
  }

  /**
   * Takes the shapes whose turn is in this frame.
   *
   * @param all whether that is all of them
   * @param triangles of all items that there are
   * @param candidates the places of shapes that may have become shown
   */
  Arrivals next(boolean all, long triangles, BitSet candidates) {
    if (all) {
      unseen.all().forEach(this::await);
      return waiting(Long.MAX_VALUE, candidates);
    }
    return waiting.isEmpty() ? near(triangles) : waiting(budget.deferred(), candidates);
  }

  /** Lets an unseen shape wait for its turn, as one that is near. */
  private void await(int place) {
    unseen.remove(place);
    waiting.set(place);
  }

  /** Takes some shapes that are near, though no eye has seen them. */
  private Arrivals near(long triangles) {
    Arrivals arrivals = new Arrivals(budget.ahead());
    if (unseen.isEmpty() || triangles >= unseen.limits().ahead()) {
      return arrivals;
    }
    int group = unseen.near(eye);
    for (int place : unseen.unseen(group).toArray()) {
      if (arrivals.left > 0) {
        arrivals.takeIfReady(place);
      }
    }
    return arrivals;
  }

  /**
   * Takes waiting shapes: all that have become shown, then late ones and then hidden ones up to the
   * portion.
   */
  private Arrivals waiting(long portion, BitSet candidates) {
    Arrivals arrivals = new Arrivals(portion);
    for (int i = late.nextSetBit(0); i >= 0; i = late.nextSetBit(i + 1)) {
      late.set(i, shapes.get(i).shown()); // A shape hidden meanwhile is no longer late.
    }
    for (int i = candidates.nextSetBit(0); i >= 0; i = candidates.nextSetBit(i + 1)) {
      if (waiting.get(i) && shapes.get(i).shown() && !late.get(i)) {
        arrivals.take(i);
      }
    }
    for (int i = late.nextSetBit(0); i >= 0 && arrivals.left > 0; i = late.nextSetBit(i + 1)) {
      arrivals.takeIfReady(i);
    }
    for (int i = waiting.nextSetBit(0);
        i >= 0 && arrivals.left > 0;
        i = waiting.nextSetBit(i + 1)) {
      arrivals.takeIfReady(i);
    }
    return arrivals;
  }

  /** Notes how long it took to make the items of shapes that were taken, in nanoseconds. */
  void made(Arrivals arrivals, long time) {
    arrivals.requests.forEach(request -> assets.forgetPacked(request.mesh()));
    budget.took(arrivals.taken, time);
  }

  /**
   * Lets groups that are far and not in view wait again, if there are too many items.
   *
   * @param triangles of all items that there are
   * @param gone loses its item
   * @return whether any shape has lost its item
   */
  boolean giveUp(LongSupplier triangles, IntConsumer gone) {
    BitSet kept = (BitSet) inView.clone();
    boolean any = false;
    while (unseen.grouped() && triangles.getAsLong() > unseen.limits().most()) {
      int group = unseen.farthest(eye, kept);
      if (group < 0) {
        return any;
      }
      kept.set(group);
      BitSet places = unseen.giveUp(group);
      waiting.andNot(places);
      late.andNot(places);
      places.stream().forEach(gone);
      any |= !places.isEmpty();
    }
    return any;
  }

  /**
   * Decides anew which shapes wait, after the tree or its structure has changed.
   *
   * @param all whether none is to wait
   * @param reflects whether there is a generated cube map: what it shows need not be in view
   * @param drawn whether a shape has had an item until now
   */
  void restructure(
      InstanceTree newTree, boolean all, boolean reflects, Predicate<ShapeInstance> drawn) {
    Set<ShapeInstance> older = older();
    boolean other = newTree != tree;
    tree = newTree;
    shapes = newTree.shapes();
    if (all || reflects) {
      unseen.clear();
    } else if (other) {
      unseen.begin(newTree, DeferredShapes::cost);
    } else {
      unseen.regroup(newTree, DeferredShapes::cost);
    }
    inView.clear();
    waiting.clear();
    late.clear();
    long left = all || other ? Long.MAX_VALUE : UploadBudget.PORTION;
    for (int i = 0; i < shapes.size(); i++) {
      ShapeInstance shape = shapes.get(i);
      if (unseen.contains(i)) {
        continue;
      }
      boolean fresh = !drawn.test(shape) && shape.shown() && !older.contains(shape);
      late.set(i, fresh && (left <= 0 || !(all || other || ready(shape))));
      left -= fresh && !late.get(i) ? cost(shape) : 0;
      waiting.set(i, late.get(i) || (!all && !drawn.test(shape) && !shape.shown()));
    }
    keepPacked();
  }

  /** Returns the shapes of the previous tree except those that are late already. */
  private Set<ShapeInstance> older() {
    Set<ShapeInstance> older = Collections.newSetFromMap(new IdentityHashMap<>());
    for (int i = 0; i < shapes.size(); i++) {
      if (!late.get(i)) {
        older.add(shapes.get(i));
      }
    }
    return older;
  }

  /** Forgets what was packed for shapes that are gone. */
  private void keepPacked() {
    Set<Mesh> wanted = Collections.newSetFromMap(new IdentityHashMap<>());
    IntStream.concat(waiting.stream(), unseen.all())
        .forEach(place -> shapes.get(place).mesh().ifPresent(wanted::add));
    assets.keepPacked(wanted);
    packing
        .keySet()
        .removeIf(shape -> shape.index() >= shapes.size() || shapes.get(shape.index()) != shape);
  }

  private boolean ready(ShapeInstance shape) {
    Mesh mesh = DrawItemCache.mesh(shape);
    return mesh == null || assets.ready(mesh);
  }

  /** Returns the cost of uploading a shape, in triangles. */
  private static long cost(ShapeInstance shape) {
    Mesh mesh = DrawItemCache.mesh(shape);
    return mesh == null ? 0 : Math.max(LEAST_OF_ONE, mesh.polygons());
  }

  /** The deferred shapes whose items are made in this frame. */
  final class Arrivals {
    final List<Integer> places = new ArrayList<>();
    final List<LightingPlanner.Request> requests = new ArrayList<>();
    private final long portion;
    private long left;
    private long taken;

    private Arrivals(long portion) {
      this.portion = portion;
      left = portion;
    }

    /** Takes a shape, unless its mesh is so large that it is still being packed. */
    private void takeIfReady(int place) {
      ShapeInstance shape = shapes.get(place);
      Mesh mesh = DrawItemCache.mesh(shape);
      if (portion == Long.MAX_VALUE || mesh == null || assets.ready(mesh)) {
        take(place);
        return;
      }
      Mesh before = packing.put(shape, mesh);
      if (before != null && before != mesh) {
        assets.forgetPacked(before);
        if (shape.shown()) {
          take(place); // It changes faster than it is packed, and would never come.
        }
      }
    }

    private void take(int place) {
      ShapeInstance shape = shapes.get(place);
      waiting.clear(place);
      late.clear(place);
      unseen.remove(place);
      packing.remove(shape);
      left -= cost(shape);
      taken += cost(shape);
      Mesh mesh = DrawItemCache.mesh(shape);
      if (mesh != null) {
        places.add(place);
        requests.add(new LightingPlanner.Request(shape, mesh, shape.lights(), true));
      }
    }
  }
}
