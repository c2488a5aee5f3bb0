package org.selectiverenderer.runtime.collide;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tree.BoxTree;
import org.selectiverenderer.geometry.tree.BoxTreeBuilder;
import org.selectiverenderer.geometry.tree.MeshTree;

/**
 * Finds placed meshes along a ray or in a box: first by their boxes in the world, then triangle by
 * triangle in their own coordinates. Whether one is present is asked at every search, so showing
 * and hiding costs nothing here.
 */
final class PlacedIndex<P extends PlacedMesh> {
  /** What a ray hits. */
  record PlacedHit<P extends PlacedMesh>(P placed, Mesh mesh, MeshTree.MeshHit at) {}

  /** Moves per element after which the tree's shape is worth making anew. */
  private static final int WORN = 4;

  private final MeshTrees meshes;
  private final List<P> all;
  private final double[][] known;
  private BoxTree tree;
  private long moves;

  PlacedIndex(List<P> all, MeshTrees meshes) {
    this.all = all;
    this.meshes = meshes;
    known = new double[all.size()][];
    for (int i = 0; i < known.length; i++) {
      known[i] = all.get(i).bounds();
    }
    tree = BoxTreeBuilder.build(known.length, this::box);
  }

  /** Rounds outwards, so that no float box is smaller than what it stands for. */
  private void box(int item, float[] out) {
    double[] box = known[item];
    for (int axis = 0; axis < 3; axis++) {
      out[axis] = Math.nextDown((float) box[axis]);
      out[axis + 3] = Math.nextUp((float) box[axis + 3]);
    }
  }

  /** Follows what moved since the last call. */
  void refresh() {
    for (int i = 0; i < known.length; i++) {
      double[] bounds = all.get(i).bounds();
      if (bounds != known[i]) {
        known[i] = bounds;
        tree.moved(i);
        moves++;
      }
    }
    if (moves > (long) WORN * known.length) {
      moves = 0;
      tree = BoxTreeBuilder.build(known.length, this::box);
    }
  }

  /**
   * The nearest hit of a ray.
   *
   * @param passBacks whether the ray passes through the unseen backs of solid geometry
   */
  Optional<PlacedHit<P>> ray(
      Vector3dc origin, Vector3dc direction, double limit, boolean passBacks) {
    RaySearch search = new RaySearch(origin, direction, passBacks);
    tree.ray(origin, direction, limit, search);
    return Optional.ofNullable(search.found);
  }

  private final class RaySearch implements BoxTree.ItemTest {
    private final Vector3dc origin;
    private final Vector3dc direction;
    private final boolean passBacks;
    private final Matrix4d toLocal = new Matrix4d();
    private @Nullable PlacedHit<P> found;

    RaySearch(Vector3dc origin, Vector3dc direction, boolean passBacks) {
      this.origin = origin;
      this.direction = direction;
      this.passBacks = passBacks;
    }

    @Override
    public double test(int item, double nearest) {
      P placed = all.get(item);
      Mesh mesh = placed.present() ? placed.mesh().orElse(null) : null;
      if (mesh == null || mesh.polygons() == 0) {
        return nearest;
      }
      placed.world().invertAffine(toLocal);
      if (!toLocal.isFinite()) {
        // Scaled to nothing: it has no surface.
        return nearest;
      }
      Optional<MeshTree.MeshHit> hit =
          meshes
              .of(mesh)
              .nearest(
                  toLocal.transformPosition(origin, new Vector3d()),
                  toLocal.transformDirection(direction, new Vector3d()),
                  nearest,
                  sides(mesh));
      hit.ifPresent(at -> found = new PlacedHit<>(placed, mesh, at));
      return hit.map(MeshTree.MeshHit::distance).orElse(nearest);
    }

    /** In local coordinates front is front, even where a transformation mirrors. */
    private MeshTree.Sides sides(Mesh mesh) {
      return passBacks && mesh.solid() ? MeshTree.Sides.FRONT : MeshTree.Sides.BOTH;
    }
  }

  /** Names what is present and whose box touches a box of the world. */
  void overlap(double[] box, Consumer<P> found) {
    tree.overlap(
        box,
        item -> {
          if (touches(known[item], box) && all.get(item).present()) {
            found.accept(all.get(item));
          }
        });
  }

  private static boolean touches(double[] a, double[] b) {
    return a[0] <= b[3]
        && a[3] >= b[0]
        && a[1] <= b[4]
        && a[4] >= b[1]
        && a[2] <= b[5]
        && a[5] >= b[2];
  }
}
