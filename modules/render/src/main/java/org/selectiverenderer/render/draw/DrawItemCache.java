package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
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
 * <p>Shapes that are not needed yet have none; {@link DeferredShapes} decides when they get theirs.
 */
final class DrawItemCache implements Culler.Items {
  /**
   * A shape that has moved or changed (or whose lights have) more often than this is expected to go
   * on doing so: its mesh is then not refined for a particular place.
   */
  private static final int MOST_MOVES = 3;

  /**
   * Unused resources are freed when the triangles of replaced items exceed the number of shapes
   * divided by this: looking at all shapes then costs little beside making these items.
   */
  private static final int FREED_AFTER = 8;

  private final GpuResourceCache assets;
  private final DeferredShapes deferred;
  private @Nullable InstanceTree tree;
  private long structureVersion;
  private List<ShapeInstance> shapes = List.of();
  private @Nullable DrawItem[] slots = {};
  private final BitSet anywhere = new BitSet(); // The items that no box bounds.
  private @Nullable List<DrawItem> items = List.of();
  private boolean reflects;
  private double terms;
  private double pixels;
  private long triangles; // Of all items.

  /** Triangles of items that were made anew since resources were freed, and one for each. */
  private long replaced;

  private final Map<ShapeInstance, Integer> moves = new IdentityHashMap<>();
  private @Nullable LightChangeDetector watch;
  private long read;

  DrawItemCache(GpuResourceCache assets, UnseenShapes.Limits limits) {
    this.assets = assets;
    deferred = new DeferredShapes(assets, limits);
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
    return Math.max(terms, deferred.terms());
  }

  @Override
  public double pixels() {
    return Math.max(pixels, deferred.pixels());
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
    return deferred.allSeen();
  }

  @Override
  public BitSet missing(Bvh.BoxTest test, Predicate<double[]> visible) {
    return deferred.missing(test, visible);
  }

  /**
   * Makes items of the shown shapes of groups that are seen; those of the hidden ones follow.
   *
   * @param places of shapes that are seen
   * @param from the place of the eye in the world
   * @param most the most groups for which that is done now; the nearest
   */
  void see(GL3 gl, BitSet places, Vector3dc from, int most) {
    make(gl, deferred.see(places, from, most));
  }

  /** Notes what is seen in a frame, and from where, by which the next decides what to keep. */
  void seen(VisibleSet visible, Vector3dc from) {
    deferred.seen(visible, from);
  }

  /**
   * Updates the items to the tree and uploads what is not on the graphics card yet.
   *
   * @param all whether new hidden shapes are uploaded now too; else they may be deferred
   */
  void follow(GL3 gl, InstanceTree newTree, boolean all) {
    boolean changed = newTree != tree || newTree.structureVersion() != structureVersion;
    if (changed) {
      restructure(newTree, all);
    }
    LightChangeDetector lights = Objects.requireNonNull(watch);
    lights.look();
    boolean otherLight = lights.changed();
    BitSet candidates = candidates(newTree, changed || otherLight || lights.moved());
    if (!changed) {
      make(gl, deferred.next(all, triangles, candidates));
    }
    update(gl, changed, otherLight, candidates);
    if (!changed && !all && deferred.giveUp(() -> triangles, place -> put(place, null))) {
      replaced = slots.length; // The resources are freed now.
    }
    if (changed || replaced > slots.length / FREED_AFTER) {
      replaced = 0;
      assets.keepOnly(gl, items());
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

  /** Makes the items of deferred shapes, and measures how long that takes. */
  private void make(GL3 gl, DeferredShapes.Arrivals arrivals) {
    long start = System.nanoTime();
    fill(arrivals.places, assets.prepare(gl, arrivals.requests, true));
    deferred.made(arrivals, System.nanoTime() - start);
  }

  /** Makes those of the candidates anew that no longer match their shapes. */
  private void update(GL3 gl, boolean changed, boolean otherLight, BitSet candidates) {
    boolean together = changed || otherLight;
    List<Integer> places = new ArrayList<>();
    List<LightingPlanner.Request> requests = new ArrayList<>();
    for (int i = candidates.nextSetBit(0); i >= 0; i = candidates.nextSetBit(i + 1)) {
      if (deferred.changed(i)) {
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

  /** Returns what a shape draws; null for nothing. */
  static @Nullable Mesh mesh(ShapeInstance shape) {
    return shape.mesh().filter(mesh -> !mesh.isEmpty()).orElse(null);
  }

  private void restructure(InstanceTree newTree, boolean all) {
    Map<ShapeInstance, DrawItem> known = new IdentityHashMap<>();
    items().forEach(item -> known.put(item.shape(), item));
    tree = newTree;
    structureVersion = newTree.structureVersion();
    shapes = newTree.shapes();
    slots = new DrawItem[shapes.size()];
    reflects = shapes.stream().anyMatch(shape -> !shape.cubes().isEmpty());
    triangles = 0;
    items = null;
    terms = 0;
    pixels = 0;
    anywhere.clear();
    for (int i = 0; i < slots.length; i++) {
      DrawItem before = known.get(shapes.get(i));
      put(i, before != null && keepable(before) ? before : null);
    }
    deferred.restructure(newTree, all, reflects, known::containsKey);
    watch = new LightChangeDetector(newTree);
    moves.keySet().retainAll(known.keySet());
  }

  /**
   * Returns whether an item is still right after a change of the tree's structure. One with another
   * light or effect in scope is made anew; its meshes and textures are kept.
   */
  private static boolean keepable(DrawItem item) {
    return item.current()
        && item.lighting().scope().equals(item.shape().lights())
        && item.around().equals(item.shape().surroundings());
  }
}
