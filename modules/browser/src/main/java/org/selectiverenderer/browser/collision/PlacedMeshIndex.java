package org.selectiverenderer.browser.collision;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.bvh.Bvh;
import org.selectiverenderer.geometry.bvh.BvhBuilder;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Finds placed meshes along a ray or in a box: a BVH over their world-space bounding boxes selects
 * candidates, whose triangles are then tested in local coordinates. Each search asks whether a mesh
 * is present, so that showing or hiding one costs nothing here.
 */
final class PlacedMeshIndex<P extends PlacedMesh> {
  /** The hit of a ray. */
  record PlacedHit<P extends PlacedMesh>(P placed, Mesh mesh, MeshBvh.MeshHit at) {}

  /** Number of moves per element after which the BVH is rebuilt instead of refitted. */
  private static final int WORN = 4;

  private final MeshBvhCache meshes;
  private final List<P> all;
  private final double[][] known;
  private final InstanceTree scene;

  /** For each shape of the scene the element that it is, or -1. */
  private final int[] elementOf;

  /** The elements that are no shapes of the scene. */
  private final int[] others;

  private long read;
  private Bvh tree;
  private long moves;
  private long looks;

  /**
   * @param scene the tree whose shapes are among the elements; for another structure of it another
   *     index is needed
   */
  PlacedMeshIndex(List<P> all, InstanceTree scene, MeshBvhCache meshes) {
    this.all = all;
    this.scene = scene;
    this.meshes = meshes;
    known = new double[all.size()][];
    elementOf = new int[scene.shapes().size()];
    Arrays.fill(elementOf, -1);
    IntStream.Builder apart = IntStream.builder();
    for (int i = 0; i < known.length; i++) {
      known[i] = all.get(i).bounds();
      if (all.get(i) instanceof PlacedMesh.OfShape drawn) {
        elementOf[drawn.shape().index()] = i;
      } else {
        apart.add(i);
      }
    }
    others = apart.build().toArray();
    read = scene.changes().end();
    tree = BvhBuilder.build(known.length, this::box);
  }

  /** Rounds outwards to float, so that the float box encloses the double box. */
  private void box(int item, float[] out) {
    double[] box = known[item];
    for (int axis = 0; axis < 3; axis++) {
      out[axis] = Math.nextDown((float) box[axis]);
      out[axis + 3] = Math.nextUp((float) box[axis + 3]);
    }
  }

  /**
   * Refits the BVH to the meshes that moved since the last call. It looks only at shapes in the
   * scene's log of changes, as long as that reaches back to the last call.
   */
  void refresh() {
    Optional<List<ShapeInstance>> changed = scene.changes().since(read);
    read = scene.changes().end();
    if (changed.isPresent()) {
      for (ShapeInstance shape : changed.get()) {
        int element = elementOf[shape.index()];
        if (element >= 0) {
          refresh(element);
        }
      }
      for (int element : others) {
        refresh(element);
      }
    } else {
      for (int i = 0; i < known.length; i++) {
        refresh(i);
      }
    }
    if (moves > (long) WORN * known.length) {
      moves = 0;
      tree = BvhBuilder.build(known.length, this::box);
    }
  }

  /** Returns how many elements were examined by refreshing, for the test of the complexity. */
  long looks() {
    return looks;
  }

  private void refresh(int element) {
    looks++;
    double[] bounds = all.get(element).bounds();
    if (bounds != known[element]) {
      known[element] = bounds;
      tree.moved(element);
      moves++;
    }
  }

  /**
   * Returns the nearest hit of a ray.
   *
   * @param passBacks whether the ray ignores back faces of solid geometry, which are not drawn
   */
  Optional<PlacedHit<P>> ray(
      Vector3dc origin, Vector3dc direction, double limit, boolean passBacks) {
    RaySearch search = new RaySearch(origin, direction, passBacks);
    tree.ray(origin, direction, limit, search);
    return Optional.ofNullable(search.found);
  }

  private final class RaySearch implements Bvh.ItemTest {
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
        // A scale of 0 leaves no surface.
        return nearest;
      }
      Optional<MeshBvh.MeshHit> hit =
          meshes
              .of(mesh)
              .nearest(
                  toLocal.transformPosition(origin, new Vector3d()),
                  toLocal.transformDirection(direction, new Vector3d()),
                  nearest,
                  sides(mesh));
      hit.ifPresent(at -> found = new PlacedHit<>(placed, mesh, at));
      return hit.map(MeshBvh.MeshHit::distance).orElse(nearest);
    }

    /**
     * Returns the sides to test; in local coordinates the winding is right even under a mirroring
     * transformation.
     */
    private MeshBvh.Sides sides(Mesh mesh) {
      return passBacks && mesh.solid() ? MeshBvh.Sides.FRONT : MeshBvh.Sides.BOTH;
    }
  }

  /** Passes on every present mesh whose bounding box touches a box in the world. */
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
