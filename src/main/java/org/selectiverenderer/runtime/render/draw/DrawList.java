package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.light.LightPlanner;
import org.selectiverenderer.runtime.render.light.LightWatch;

/**
 * The draw items of all shapes of a tree, shown or not, kept between frames. Made anew when the
 * tree's structure changes; otherwise only where a shape has another mesh or surface.
 *
 * <p>Shapes that are new may wait: then a few of them are made ready with each frame. Those that
 * wait hidden and are shown meanwhile are made ready in that very frame. Those that came into a
 * running scene shown, more of them than one frame can make ready, follow in the next frames, as if
 * they had come in several files; what was in the tree before is never late.
 */
final class DrawList {
  /**
   * What has moved or changed more often than that, or its lights, is expected to go on: nothing is
   * made for the place where it is then.
   */
  private static final int MOST_MOVES = 3;

  /**
   * Triangles of waiting shapes that are made ready with a frame, a shape counting for at least
   * {@link #LEAST_OF_ONE}: about 5 ms.
   */
  private static final int PORTION = 20_000;

  private static final int LEAST_OF_ONE = 40;

  private final GpuAssets assets;
  private @Nullable InstanceTree tree;
  private long structureVersion;
  private List<ShapeInstance> shapes = List.of();
  private @Nullable DrawItem[] slots = {};
  private final BitSet waiting = new BitSet();
  private final BitSet late = new BitSet(); // Of those waiting the ones that came shown.
  private List<DrawItem> items = List.of();
  private final Map<ShapeInstance, Integer> moves = new IdentityHashMap<>();
  private LightWatch watch = new LightWatch(List.of());
  private long placementVersion;

  DrawList(GpuAssets assets) {
    this.assets = assets;
  }

  List<DrawItem> items() {
    return items;
  }

  /**
   * Follows the tree; what is not on the graphics card yet is uploaded.
   *
   * @param all whether new shapes that are not shown are uploaded now too, else they may wait
   */
  void follow(GL3 gl, InstanceTree newTree, boolean all) {
    boolean changed = newTree != tree || newTree.structureVersion() != structureVersion;
    boolean waited = !waiting.isEmpty();
    if (changed) {
      restructure(newTree, all);
    }
    boolean made = waited && !changed && arrive(gl, all ? Long.MAX_VALUE : PORTION);
    boolean otherLight = watch.changed();
    if (changed || otherLight || newTree.placementVersion() != placementVersion) {
      placementVersion = newTree.placementVersion();
      made |= update(gl, changed, otherLight);
    } // Else nothing moved, and nothing has another mesh, surface or light.
    if (changed || made) {
      publish(gl);
    }
  }

  /**
   * Makes waiting shapes ready: all that are shown but late ones, and of these and then of the
   * others so many.
   *
   * @param portion triangles
   */
  private boolean arrive(GL3 gl, long portion) {
    Arrivals arrivals = new Arrivals(portion);
    for (int i = late.nextSetBit(0); i >= 0; i = late.nextSetBit(i + 1)) {
      late.set(i, shapes.get(i).shown()); // What was hidden since waits like the others.
    }
    for (int i = waiting.nextSetBit(0); i >= 0; i = waiting.nextSetBit(i + 1)) {
      if (shapes.get(i).shown() && !late.get(i)) {
        arrivals.take(i);
      }
    }
    for (int i = late.nextSetBit(0); i >= 0 && arrivals.left > 0; i = late.nextSetBit(i + 1)) {
      arrivals.take(i);
    }
    for (int i = waiting.nextSetBit(0);
        i >= 0 && arrivals.left > 0;
        i = waiting.nextSetBit(i + 1)) {
      arrivals.take(i);
    }
    fill(arrivals.places, assets.prepare(gl, arrivals.requests, true));
    return !arrivals.places.isEmpty();
  }

  /** What is made ready of the waiting shapes. */
  private final class Arrivals {
    final List<Integer> places = new ArrayList<>();
    final List<LightPlanner.Request> requests = new ArrayList<>();
    long left;

    Arrivals(long portion) {
      left = portion;
    }

    void take(int place) {
      ShapeInstance shape = shapes.get(place);
      waiting.clear(place);
      late.clear(place);
      left -= cost(shape);
      Mesh mesh = mesh(shape);
      if (mesh != null) {
        places.add(place);
        requests.add(new LightPlanner.Request(shape, mesh, shape.lights(), true));
      }
    }
  }

  /** What making a shape ready counts for, in triangles. */
  private static long cost(ShapeInstance shape) {
    Mesh mesh = mesh(shape);
    return mesh == null ? 0 : Math.max(LEAST_OF_ONE, mesh.polygons());
  }

  /** Makes anew what is no longer as its shape is; whether anything was. */
  private boolean update(GL3 gl, boolean changed, boolean otherLight) {
    boolean together = changed || otherLight;
    List<Integer> places = new ArrayList<>();
    List<LightPlanner.Request> requests = new ArrayList<>();
    boolean any = false;
    for (int i = 0; i < slots.length; i++) {
      if (waiting.get(i)) {
        continue;
      }
      DrawItem slot = slots[i];
      ShapeInstance shape = shapes.get(i);
      Mesh mesh = mesh(shape);
      boolean current = slot == null ? mesh == null : slot.current();
      boolean lit = slot == null || slot.lighting().current(shape);
      if (current && lit) {
        continue;
      }
      any = true;
      // A lamp that moves concerns many, which are to stay together.
      together |= current && slot != null && slot.lighting().stands(shape);
      slots[i] = null;
      if (mesh != null) {
        int times = slot == null ? 0 : moves.merge(shape, 1, Integer::sum);
        places.add(i);
        requests.add(new LightPlanner.Request(shape, mesh, shape.lights(), times <= MOST_MOVES));
      }
    }
    fill(places, assets.prepare(gl, requests, together));
    return any;
  }

  private void fill(List<Integer> places, List<DrawItem> made) {
    for (int i = 0; i < made.size(); i++) {
      slots[places.get(i)] = made.get(i);
    }
  }

  private static @Nullable Mesh mesh(ShapeInstance shape) {
    return shape.mesh().filter(mesh -> !mesh.isEmpty()).orElse(null);
  }

  /** The shapes of the tree as it was, but for those that are late already. */
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
    items.forEach(item -> known.put(item.shape(), item));
    Set<ShapeInstance> older = older();
    long left = all || newTree != tree ? Long.MAX_VALUE : PORTION;
    tree = newTree;
    structureVersion = newTree.structureVersion();
    shapes = newTree.shapes();
    slots = new DrawItem[shapes.size()];
    waiting.clear();
    late.clear();
    for (int i = 0; i < slots.length; i++) {
      DrawItem before = known.get(shapes.get(i));
      // Another light may have come into scope: such items are made anew, their assets are kept.
      slots[i] =
          before != null
                  && before.current()
                  && before.lighting().scope().equals(before.shape().lights())
                  && before.around().equals(before.shape().surroundings())
              ? before
              : null;
      ShapeInstance shape = shapes.get(i);
      boolean fresh = before == null && shape.shown() && !older.contains(shape);
      late.set(i, fresh && left <= 0);
      left -= fresh ? cost(shape) : 0;
      waiting.set(i, late.get(i) || (!all && before == null && !shape.shown()));
    }
    watch = new LightWatch(newTree.lights());
    moves.keySet().retainAll(known.keySet());
  }

  private void publish(GL3 gl) {
    List<DrawItem> all = new ArrayList<>(slots.length);
    Arrays.stream(slots).filter(java.util.Objects::nonNull).forEach(all::add);
    items = all;
    assets.keepOnly(gl, items);
  }
}
