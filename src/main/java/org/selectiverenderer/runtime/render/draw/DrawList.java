package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.light.LightPlanner;
import org.selectiverenderer.runtime.render.light.LightWatch;

/**
 * The draw items of all shapes of a tree, shown or not, kept between frames. Made anew when the
 * tree's structure changes; otherwise only where a shape has another mesh or surface.
 */
final class DrawList {
  /**
   * What has moved or changed more often than that, or its lights, is expected to go on: nothing is
   * made for the place where it is then.
   */
  private static final int MOST_MOVES = 3;

  private final GpuAssets assets;
  private @Nullable InstanceTree tree;
  private long structureVersion;
  private List<ShapeInstance> shapes = List.of();
  private @Nullable DrawItem[] slots = {};
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

  /** Follows the tree; what is not on the graphics card yet is uploaded. */
  void follow(GL3 gl, InstanceTree newTree) {
    boolean changed = newTree != tree || newTree.structureVersion() != structureVersion;
    if (changed) {
      restructure(newTree);
    }
    boolean otherLight = watch.changed();
    if (!changed && !otherLight && newTree.placementVersion() == placementVersion) {
      return; // Nothing moved, and nothing has another mesh, surface or light.
    }
    placementVersion = newTree.placementVersion();
    boolean together = changed || otherLight;
    List<Integer> places = new ArrayList<>();
    List<LightPlanner.Request> requests = new ArrayList<>();
    for (int i = 0; i < slots.length; i++) {
      DrawItem slot = slots[i];
      ShapeInstance shape = shapes.get(i);
      Mesh mesh = shape.mesh().filter(m -> !m.isEmpty()).orElse(null);
      boolean current = slot == null ? mesh == null : slot.current();
      boolean lit = slot == null || slot.lighting().current(shape);
      if (current && lit) {
        continue;
      }
      changed = true;
      // A lamp that moves concerns many, which are to stay together.
      together |= current && slot != null && slot.lighting().stands(shape);
      slots[i] = null;
      if (mesh != null) {
        int times = slot == null ? 0 : moves.merge(shape, 1, Integer::sum);
        places.add(i);
        requests.add(new LightPlanner.Request(shape, mesh, shape.lights(), times <= MOST_MOVES));
      }
    }
    List<DrawItem> made = assets.prepare(gl, requests, together);
    for (int i = 0; i < made.size(); i++) {
      slots[places.get(i)] = made.get(i);
    }
    if (changed) {
      publish(gl);
    }
  }

  private void restructure(InstanceTree newTree) {
    Map<ShapeInstance, DrawItem> known = new IdentityHashMap<>();
    items.forEach(item -> known.put(item.shape(), item));
    tree = newTree;
    structureVersion = newTree.structureVersion();
    shapes = newTree.shapes();
    slots = new DrawItem[shapes.size()];
    for (int i = 0; i < slots.length; i++) {
      DrawItem before = known.get(shapes.get(i));
      // Another light may have come into scope: such items are made anew, their assets are kept.
      slots[i] =
          before != null
                  && before.current()
                  && before.lighting().scope().equals(before.shape().lights())
              ? before
              : null;
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
