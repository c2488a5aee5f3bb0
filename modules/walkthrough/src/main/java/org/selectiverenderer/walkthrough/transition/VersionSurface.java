package org.selectiverenderer.walkthrough.transition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/** The shapes that a version of an object draws where it is shown. */
final class VersionSurface {
  static final VersionSurface NONE = new VersionSurface(List.of());

  private final List<ShapeInstance> shapes;
  private final List<Mesh> meshes;
  private @Nullable List<SurfaceSamples.Sample> samples;

  private VersionSurface(List<ShapeInstance> shapes) {
    this.shapes = List.copyOf(shapes);
    meshes = shapes.stream().map(shape -> shape.mesh().orElseThrow()).toList();
  }

  /** Returns what a version draws as its inner Switches are set now. */
  static VersionSurface of(Instance version) {
    List<ShapeInstance> shapes = new ArrayList<>();
    collect(version, shapes);
    return new VersionSurface(shapes);
  }

  private static void collect(Instance instance, List<ShapeInstance> found) {
    if (instance instanceof ShapeInstance shape) {
      if (shape.mesh().filter(mesh -> !mesh.isEmpty()).isPresent()) {
        found.add(shape);
      }
    } else if (instance instanceof GroupInstance group) {
      for (int i = 0; i < group.children().size(); i++) {
        if (group.node().shows(i)) {
          collect(group.children().get(i), found);
        }
      }
    }
  }

  /** Returns whether this has the same shapes with the same meshes as another. */
  boolean sameAs(VersionSurface other) {
    return same(shapes, other.shapes) && same(meshes, other.meshes);
  }

  private static boolean same(List<?> some, List<?> others) {
    boolean same = some.size() == others.size();
    for (int i = 0; same && i < some.size(); i++) {
      same = some.get(i) == others.get(i);
    }
    return same;
  }

  boolean isEmpty() {
    return shapes.isEmpty();
  }

  /** Returns the boxes of the shapes in the world. */
  List<double[]> boxes() {
    return shapes.stream().map(ShapeInstance::bounds).toList();
  }

  /** Returns points on the surface. */
  List<SurfaceSamples.Sample> samples() {
    List<SurfaceSamples.Sample> known = samples;
    if (known == null) {
      known = SurfaceSamples.of(shapes);
      samples = known;
    }
    return known;
  }

  /**
   * Returns where a ray first meets the surface, shown or not, in lengths of the ray; infinite if
   * nowhere.
   */
  double distance(Vector3dc from, Vector3dc ray, MeshBvhCache hierarchies) {
    double nearest = Double.POSITIVE_INFINITY;
    Matrix4d toLocal = new Matrix4d();
    for (int i = 0; i < shapes.size(); i++) {
      Mesh mesh = meshes.get(i);
      shapes.get(i).world().invertAffine(toLocal);
      if (mesh.polygons() == 0 || !toLocal.isFinite()) {
        continue;
      }
      Optional<MeshBvh.MeshHit> hit =
          hierarchies
              .of(mesh)
              .nearest(
                  toLocal.transformPosition(from, new Vector3d()),
                  toLocal.transformDirection(ray, new Vector3d()),
                  nearest,
                  mesh.solid() ? MeshBvh.Sides.FRONT : MeshBvh.Sides.BOTH);
      nearest = hit.map(MeshBvh.MeshHit::distance).orElse(nearest);
    }
    return nearest;
  }
}
