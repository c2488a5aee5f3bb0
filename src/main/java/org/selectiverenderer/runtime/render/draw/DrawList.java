package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.LightInstance;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.ShapePrograms;

/**
 * The draw items of all shapes of a tree, shown or not, kept between frames. Made anew when the
 * tree's structure changes; otherwise only where a shape has another mesh or surface.
 */
final class DrawList {
  private final GpuAssets assets;
  private @Nullable InstanceTree tree;
  private long structureVersion;
  private List<ShapeInstance> shapes = List.of();
  private @Nullable DrawItem[] slots = {};
  private List<DrawItem> items = List.of();
  private final Map<List<LightInstance>, List<LightInstance>> scopes = new HashMap<>();

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
    if (changed) {
      assets.prepare(gl, shapes);
    }
    for (int i = 0; i < slots.length; i++) {
      DrawItem slot = slots[i];
      ShapeInstance shape = shapes.get(i);
      Mesh mesh = shape.mesh().filter(m -> !m.isEmpty()).orElse(null);
      boolean current = slot == null ? mesh == null : slot.current();
      if (!current) {
        slots[i] = mesh == null ? null : item(gl, shape, mesh);
        changed = true;
      }
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
    scopes.clear();
    for (int i = 0; i < slots.length; i++) {
      DrawItem before = known.get(shapes.get(i));
      // Another light may have come into scope: such items are made anew, their assets are kept.
      slots[i] = before != null && before.lights().equals(before.shape().lights()) ? before : null;
      if (slots[i] != null) {
        scopes.putIfAbsent(before.lights(), before.lights());
      }
    }
  }

  private DrawItem item(GL3 gl, ShapeInstance shape, Mesh mesh) {
    List<LightInstance> scope = scopes.computeIfAbsent(shape.lights(), lights -> lights);
    return assets.item(gl, shape, mesh, scope);
  }

  private void publish(GL3 gl) {
    List<DrawItem> all = new ArrayList<>(slots.length);
    Arrays.stream(slots).filter(java.util.Objects::nonNull).forEach(all::add);
    items = all;
    assets.keepOnly(gl, items);
  }

  /** A program and texture, which decide the order of drawing. */
  record State(ShapePrograms.Family programs, @Nullable GpuTexture texture) {}
}
