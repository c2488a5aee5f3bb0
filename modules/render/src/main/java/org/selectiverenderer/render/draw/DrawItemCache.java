package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.VersionFades;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.lighting.LightChangeDetector;
import org.selectiverenderer.render.lighting.LightingPlanner;

/**
 * The draw items of all shapes of an instance tree, shown or not, kept between frames. All are
 * checked when the tree's structure or a light changes; otherwise only those of shapes that have
 * moved or changed, so that a frame's cost does not depend on how many shapes there are.
 *
 * <p>The shapes of a large scene have no items before an eye sees them or comes near ({@link
 * UnseenShapes}): so the memory and the first frame depend on what is seen and near, not on what
 * there is. A group of neighbours of which a shape is seen gets the items of its shown shapes in
 * that frame, those of its hidden ones as if they were new.
 *
 * <p>The upload of new shapes may be deferred and spread over the following frames. A deferred
 * hidden shape that becomes shown is uploaded in that very frame. If more shown shapes come into a
 * running scene than one frame can upload, the rest appears in the next frames, as if they had come
 * in several files; shapes that were in the tree before are never late.
 */
final class DrawItemCache implements Culler.Items {
  /**
   * A shape that has moved or changed (or whose lights have) more often than this is expected to go
   * on doing so: its mesh is then not refined for a particular place.
   */
  private static final int MOST_MOVES = 3;

  /**
   * The time of a frame that the upload of deferred shapes may take, in nanoseconds; and likewise
   * for shapes that are near, but that no eye has seen.
   */
  private static final double DEFERRED = 5e6;

  private static final double AHEAD = DEFERRED / 4;

  /** The triangles that are uploaded in such a time at first and at most. */
  private static final int PORTION = 20_000;

  /** The least number of triangles that one shape counts for. */
  private static final int LEAST_OF_ONE = 40;

  /**
   * Unused resources are freed when the triangles of replaced items exceed the number of shapes
   * divided by this: looking at all shapes then costs little beside making these items.
   */
  private static final int FREED_AFTER = 8;

  private final GpuResourceCache assets;
  private @Nullable InstanceTree tree;
  private long structureVersion;
  private List<ShapeInstance> shapes = List.of();
  private @Nullable DrawItem[] slots = {};
  private final BitSet waiting = new BitSet();
  private final BitSet late = new BitSet(); // The deferred shapes that came shown.
  private final BitSet anywhere = new BitSet(); // The items that no box bounds.
  private @Nullable List<DrawItem> items = List.of();
  private boolean reflects;
  private double terms;
  private double pixels;

  /** Triangles of items that were made anew since resources were freed, and one for each. */
  private long replaced;

  private final UnseenShapes unseen;
  private final BitSet inView = new BitSet(); // The groups of which some item is in view.
  private Vector3dc eye = new Vector3d();
  private long triangles; // Of all items.

  /** The measured time of making a triangle ready, in nanoseconds. */
  private double perTriangle = DEFERRED / PORTION;

  private final Map<ShapeInstance, Integer> moves = new IdentityHashMap<>();

  /** The meshes of waiting shapes that are being packed. */
  private final Map<ShapeInstance, Mesh> packing = new IdentityHashMap<>();

  private @Nullable LightChangeDetector watch;
  private long read;

  DrawItemCache(GpuResourceCache assets, UnseenShapes.Limits limits) {
    this.assets = assets;
    unseen = new UnseenShapes(limits);
  }

  /** Returns all items in the order of their shapes; the same list until one of them changes. */
  List<DrawItem> items() {
    List<DrawItem> known = items;
    if (known == null) {
      known = Arrays.stream(slots).filter(Objects::nonNull).toList();
      items = known;
    }
    return known;
  }

  /** Returns whether there is a generated cube map on any shape. */
  boolean reflects() {
    return reflects;
  }

  /** Returns the versions of the tree that are being faded. */
  List<VersionFades.FadingVersion> fades() {
    return tree == null ? List.of() : tree.fades().versions();
  }

  /** Returns the item of a shape of the tree; null where it has none. */
  @Nullable DrawItem of(ShapeInstance shape) {
    return shape.index() < slots.length ? slots[shape.index()] : null;
  }

  @Override
  public int size() {
    return slots.length;
  }

  @Override
  public DrawItem get(int number) {
    return Objects.requireNonNull(slots[number]);
  }

  @Override
  public double terms() {
    return Math.max(terms, unseen.terms());
  }

  @Override
  public double pixels() {
    return Math.max(pixels, unseen.pixels());
  }

  /** Notes the bounds of an item, which count until the structure changes. */
  private void bound(DrawItem item) {
    terms = Math.max(terms, item.part().occluders().terms(item.place()));
    pixels = Math.max(pixels, Culler.pixels(item.stroke(), item.source().primitive()));
  }

  @Override
  public void search(Bvh.BoxTest test, IntConsumer found) {
    if (tree == null) {
      return;
    }
    tree.boxes()
        .search(
            test,
            i -> {
              if (slots[i] != null && !anywhere.get(i)) {
                found.accept(i);
              }
            });
    anywhere.stream().forEach(found);
  }

  @Override
  public boolean complete() {
    return unseen.isEmpty();
  }

  @Override
  public BitSet missing(Bvh.BoxTest test, Predicate<double[]> visible) {
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
   * Makes items of the shown shapes of groups that are seen; those of the hidden ones follow.
   *
   * @param places of shapes that are seen
   * @param from the place of the eye in the world
   * @param most the most groups for which that is done now; the nearest
   */
  void see(GL3 gl, BitSet places, Vector3dc from, int most) {
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
                  unseen.remove(place);
                  waiting.set(place);
                }
              });
    }
    take(gl, arrivals);
  }

  /** Notes what is seen in a frame, and from where, by which the next decides what to keep. */
  void seen(VisibleSet visible, Vector3dc from) {
    eye = new Vector3d(from);
    inView.clear();
    if (unseen.grouped()) {
      visible.calls.forEach(item -> inView.set(unseen.group(item.shape().index())));
    }
  }

  /**
   * Updates the items to the tree and uploads what is not on the graphics card yet.
   *
   * @param all whether new hidden shapes are uploaded now too; else they may be deferred
   */
  void follow(GL3 gl, InstanceTree newTree, boolean all) {
    boolean changed = newTree != tree || newTree.structureVersion() != structureVersion;
    boolean waited = !waiting.isEmpty();
    if (changed) {
      restructure(newTree, all);
    }
    LightChangeDetector lights = Objects.requireNonNull(watch);
    lights.look();
    boolean otherLight = lights.changed();
    BitSet candidates = candidates(newTree, changed || otherLight || lights.moved());
    if (all && !changed) {
      unseen.all().forEach(this::await);
    }
    if ((waited || all) && !changed) {
      arrive(gl, all ? Long.MAX_VALUE : portion(DEFERRED), candidates);
    } else if (!changed) {
      approach(gl);
    }
    update(gl, changed, otherLight, candidates);
    if (!changed && !all) {
      giveUp();
    }
    if (changed || replaced > slots.length / FREED_AFTER) {
      replaced = 0;
      assets.keepOnly(gl, items());
    }
  }

  /** Lets an unseen shape wait for its turn, as one that is near. */
  private void await(int place) {
    unseen.remove(place);
    waiting.set(place);
  }

  /** Makes some shapes ready that are near, though no eye has seen them. */
  private void approach(GL3 gl) {
    if (unseen.isEmpty() || triangles >= unseen.limits().ahead()) {
      return;
    }
    Arrivals arrivals = new Arrivals(portion(AHEAD));
    int group = unseen.near(eye);
    for (int place : unseen.unseen(group).toArray()) {
      if (arrivals.left > 0) {
        arrivals.takeIfReady(place);
      }
    }
    take(gl, arrivals);
  }

  /** Gives up the items of groups that are far and not in view, if there are too many. */
  private void giveUp() {
    BitSet kept = (BitSet) inView.clone();
    while (unseen.grouped() && triangles > unseen.limits().most()) {
      int group = unseen.farthest(eye, kept);
      if (group < 0) {
        return;
      }
      kept.set(group);
      BitSet gone = unseen.giveUp(group);
      gone.stream()
          .forEach(
              place -> {
                put(place, null);
                waiting.clear(place);
                late.clear(place);
              });
      replaced = gone.isEmpty() ? replaced : slots.length; // The resources are freed now.
    }
  }

  /** Returns the places of the shapes that may have changed since the last call. */
  private BitSet candidates(InstanceTree of, boolean all) {
    // What was read of another tree's log says nothing about this one's.
    Optional<List<ShapeInstance>> changed = all ? Optional.empty() : of.changes().since(read);
    read = of.changes().end();
    BitSet places = new BitSet();
    if (changed.isEmpty()) {
      places.set(0, slots.length);
    } else {
      changed.get().forEach(shape -> places.set(shape.index()));
    }
    return places;
  }

  /**
   * Uploads deferred shapes: all that have become shown, then late ones and then hidden ones up to
   * the portion.
   *
   * @param portion triangles
   * @param candidates the places of those that may have become shown
   */
  private void arrive(GL3 gl, long portion, BitSet candidates) {
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
    take(gl, arrivals);
  }

  /** Returns the triangles that can be made ready in some nanoseconds. */
  private long portion(double time) {
    return Math.max(1, Math.min(PORTION, Math.round(time / perTriangle)));
  }

  /** Makes shapes ready, and measures how long that takes. */
  private void take(GL3 gl, Arrivals arrivals) {
    long start = System.nanoTime();
    fill(arrivals.places, assets.prepare(gl, arrivals.requests, true));
    arrivals.requests.forEach(request -> assets.forgetPacked(request.mesh()));
    if (arrivals.taken > 0) {
      double now = (System.nanoTime() - start) / (double) arrivals.taken;
      perTriangle += (now - perTriangle) / 4; // One frame that was interrupted tells little.
    }
  }

  /** The deferred shapes that are uploaded with this frame. */
  private final class Arrivals {
    final List<Integer> places = new ArrayList<>();
    final List<LightingPlanner.Request> requests = new ArrayList<>();
    private final long portion;
    long left;
    long taken;

    Arrivals(long portion) {
      this.portion = portion;
      left = portion;
    }

    /** Takes a shape, unless its mesh is so large that it is still being packed. */
    void takeIfReady(int place) {
      ShapeInstance shape = shapes.get(place);
      Mesh mesh = mesh(shape);
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

    void take(int place) {
      ShapeInstance shape = shapes.get(place);
      waiting.clear(place);
      late.clear(place);
      unseen.remove(place);
      packing.remove(shape);
      left -= cost(shape);
      taken += cost(shape);
      Mesh mesh = mesh(shape);
      if (mesh != null) {
        places.add(place);
        requests.add(new LightingPlanner.Request(shape, mesh, shape.lights(), true));
      }
    }
  }

  private boolean ready(ShapeInstance shape) {
    Mesh mesh = mesh(shape);
    return mesh == null || assets.ready(mesh);
  }

  /** Returns the cost of uploading a shape, in triangles. */
  private static long cost(ShapeInstance shape) {
    Mesh mesh = mesh(shape);
    return mesh == null ? 0 : Math.max(LEAST_OF_ONE, mesh.polygons());
  }

  /** Makes those of the candidates anew that no longer match their shapes. */
  private void update(GL3 gl, boolean changed, boolean otherLight, BitSet candidates) {
    boolean together = changed || otherLight;
    List<Integer> places = new ArrayList<>();
    List<LightingPlanner.Request> requests = new ArrayList<>();
    for (int i = candidates.nextSetBit(0); i >= 0; i = candidates.nextSetBit(i + 1)) {
      if (unseen.contains(i)) {
        unseen.changed(i);
      }
      if (waiting.get(i) || unseen.contains(i)) {
        continue;
      }
      DrawItem slot = slots[i];
      ShapeInstance shape = shapes.get(i);
      Mesh mesh = mesh(shape);
      if (slot != null) {
        bound(slot); // Its shape may have moved.
      }
      boolean current = slot == null ? mesh == null : slot.current();
      boolean lit = slot == null || slot.lighting().current(shape);
      if (current && lit) {
        continue;
      }
      replaced += slot == null ? 0 : 1 + slot.source().polygons();
      // A lamp that moves affects many shapes, which are to stay batched together.
      together |= current && slot != null && slot.lighting().stands(shape);
      put(i, null);
      if (mesh != null) {
        int times = slot == null ? 0 : moves.merge(shape, 1, Integer::sum);
        places.add(i);
        requests.add(new LightingPlanner.Request(shape, mesh, shape.lights(), times <= MOST_MOVES));
      }
    }
    fill(places, assets.prepare(gl, requests, together));
  }

  private void fill(List<Integer> places, List<DrawItem> made) {
    for (int i = 0; i < made.size(); i++) {
      put(places.get(i), made.get(i));
      bound(made.get(i));
    }
  }

  private void put(int place, @Nullable DrawItem item) {
    DrawItem before = slots[place];
    triangles -= before == null ? 0 : before.source().polygons();
    triangles += item == null ? 0 : item.source().polygons();
    slots[place] = item;
    anywhere.set(place, item != null && item.anywhere());
    items = null;
  }

  private static @Nullable Mesh mesh(ShapeInstance shape) {
    return shape.mesh().filter(mesh -> !mesh.isEmpty()).orElse(null);
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

  private void restructure(InstanceTree newTree, boolean all) {
    Map<ShapeInstance, DrawItem> known = new IdentityHashMap<>();
    items().forEach(item -> known.put(item.shape(), item));
    Set<ShapeInstance> older = older();
    boolean other = newTree != tree;
    long left = all || other ? Long.MAX_VALUE : PORTION;
    tree = newTree;
    structureVersion = newTree.structureVersion();
    shapes = newTree.shapes();
    slots = new DrawItem[shapes.size()];
    reflects = shapes.stream().anyMatch(shape -> !shape.cubes().isEmpty());
    if (all || reflects) {
      unseen.clear();
    } else if (other) {
      unseen.begin(newTree, DrawItemCache::cost);
    } else {
      unseen.regroup(newTree, DrawItemCache::cost);
    }
    inView.clear();
    triangles = 0;
    items = null;
    terms = 0;
    pixels = 0;
    anywhere.clear();
    waiting.clear();
    late.clear();
    for (int i = 0; i < slots.length; i++) {
      DrawItem before = known.get(shapes.get(i));
      // An item with another light or effect in scope is made anew; its meshes and textures are
      // kept.
      put(
          i,
          before != null
                  && before.current()
                  && before.lighting().scope().equals(before.shape().lights())
                  && before.around().equals(before.shape().surroundings())
              ? before
              : null);
      if (unseen.contains(i)) {
        continue;
      }
      ShapeInstance shape = shapes.get(i);
      boolean fresh = before == null && shape.shown() && !older.contains(shape);
      late.set(i, fresh && (left <= 0 || !(all || other || ready(shape))));
      left -= fresh && !late.get(i) ? cost(shape) : 0;
      waiting.set(i, late.get(i) || (!all && before == null && !shape.shown()));
    }
    watch = new LightChangeDetector(newTree);
    Set<Mesh> wanted = Collections.newSetFromMap(new IdentityHashMap<>());
    IntStream.concat(waiting.stream(), unseen.all())
        .forEach(place -> shapes.get(place).mesh().ifPresent(wanted::add));
    assets.keepPacked(wanted);
    moves.keySet().retainAll(known.keySet());
    packing
        .keySet()
        .removeIf(shape -> shape.index() >= shapes.size() || shapes.get(shape.index()) != shape);
  }
}
