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
  private long placementVersion;
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
    if (!changed && newTree.placementVersion() == placementVersion) {
      return; // Nothing moved and nothing has another mesh or surface.
    }
    placementVersion = newTree.placementVersion();
    if (changed) {
      restructure(newTree);
      fill(gl);
    }
    for (int i = 0; i < slots.length; i++) {
      DrawItem slot = slots[i];
      ShapeInstance shape = shapes.get(i);
      Mesh mesh = mesh(shape);
      boolean current = slot == null ? mesh == null : slot.current();
      if (!current) {
        slots[i] =
            mesh == null
                ? null
                : assets.item(shape, mesh, look(gl, shape, mesh), assets.part(gl, mesh));
        changed = true;
      }
    }
    if (changed) {
      publish(gl);
    }
  }

  private static @Nullable Mesh mesh(ShapeInstance shape) {
    return shape.mesh().filter(mesh -> !mesh.isEmpty()).orElse(null);
  }

  /** Makes the items of new shapes, in batches where that is worth it. */
  private void fill(GL3 gl) {
    List<BatchPlan.Candidate> fresh = new ArrayList<>();
    Map<DrawLook, DrawLook> looks = new HashMap<>();
    for (int i = 0; i < slots.length; i++) {
      ShapeInstance shape = shapes.get(i);
      Mesh mesh = mesh(shape);
      if (slots[i] == null && mesh != null) {
        // Equal looks are the same object, whose numbers are then sent once.
        DrawLook look = looks.computeIfAbsent(look(gl, shape, mesh), known -> known);
        fresh.add(new BatchPlan.Candidate(i, shape, mesh, look));
      }
    }
    Map<ShapeInstance, MeshPart> parts = assets.prepare(gl, fresh);
    for (BatchPlan.Candidate one : fresh) {
      MeshPart part = parts.get(one.shape());
      slots[one.number()] =
          assets.item(
              one.shape(),
              one.mesh(),
              one.look(),
              part == null ? assets.part(gl, one.mesh()) : part);
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
      slots[i] =
          before != null && before.current() && before.lights().equals(before.shape().lights())
              ? before
              : null;
      if (slots[i] != null) {
        scopes.putIfAbsent(before.lights(), before.lights());
      }
    }
  }

  private DrawLook look(GL3 gl, ShapeInstance shape, Mesh mesh) {
    return assets.look(gl, shape, mesh, scopes.computeIfAbsent(shape.lights(), lights -> lights));
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
