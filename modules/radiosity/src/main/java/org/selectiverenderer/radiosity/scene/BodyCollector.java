package org.selectiverenderer.radiosity.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;

/**
 * Walks the instance tree and collects every instance of every shape as a body. The children of a
 * Switch or LOD are versions of one object; the version with most polygons is the reference that
 * stands for the object where others are lit. A Switch within a version contributes its shown child
 * only.
 */
final class BodyCollector {
  private static final SortedSet<String> MEMBERS = new TreeSet<>(Set.of("polygons"));

  private final double unit;
  private final ProblemCollector problems;
  private final List<Body> bodies = new ArrayList<>();
  private final ObjectVersionIndex versions = new ObjectVersionIndex();
  private final List<Integer> budgets = new ArrayList<>();
  private final Map<Mesh, float[]> reflectances = new IdentityHashMap<>();
  private int objects;
  private int triangles;

  BodyCollector(double unit, ProblemCollector problems) {
    this.unit = unit;
    this.problems = problems;
  }

  void gather(GroupInstance root) {
    walk(root, ObjectVersionIndex.FIXED, -1);
  }

  List<Body> bodies() {
    return bodies;
  }

  ObjectVersionIndex versions() {
    return versions;
  }

  int triangles() {
    return triangles;
  }

  int[] budgets() {
    return budgets.stream().mapToInt(Integer::intValue).toArray();
  }

  private void walk(Instance instance, int version, int budget) {
    if (instance instanceof ShapeInstance shape) {
      shape.mesh().ifPresent(mesh -> add(shape, mesh, version, budget));
      return;
    }
    if (!(instance instanceof GroupInstance group)) {
      return;
    }
    int region = version == ObjectVersionIndex.FIXED ? budget(group, budget) : -1;
    boolean choice = isChoice(group);
    if (!choice || version != ObjectVersionIndex.FIXED) {
      group.children().forEach(child -> walk(child, version, region));
      return;
    }
    objects++;
    int object = objects;
    Instance reference = reference(group);
    for (Instance child : group.children()) {
      walk(child, versions.add(object, child == reference), -1);
    }
  }

  private int budget(GroupInstance group, int above) {
    return PhotometricMetadata.of(group.node(), "radiosity", MEMBERS, problems)
        .flatMap(wishes -> wishes.number("polygons"))
        .map(
            polygons -> {
              budgets.add((int) Math.min(Integer.MAX_VALUE, Math.round(polygons)));
              return budgets.size() - 1;
            })
        .orElse(above);
  }

  private static boolean isChoice(GroupInstance group) {
    return group.node() instanceof SwitchNode || group.node().type().name().equals("LOD");
  }

  /**
   * Returns the child with most polygons, the first of equals; null if the Switch shows nothing.
   */
  private static @org.jspecify.annotations.Nullable Instance reference(GroupInstance group) {
    if (group.node() instanceof SwitchNode choice && choice.integer("whichChoice") < 0) {
      return null;
    }
    Instance best = null;
    int most = -1;
    for (Instance child : group.children()) {
      int polygons = polygons(child);
      if (polygons > most) {
        most = polygons;
        best = child;
      }
    }
    return best;
  }

  private static int polygons(Instance instance) {
    if (instance instanceof ShapeInstance shape) {
      return shape.mesh().map(Mesh::polygons).orElse(0);
    }
    return instance instanceof GroupInstance group
        ? group.children().stream().mapToInt(BodyCollector::polygons).sum()
        : 0;
  }

  private void add(ShapeInstance shape, Mesh mesh, int version, int budget) {
    SurfaceMaterial surface = shape.surface();
    boolean painted = !surface.lit() && shape.node().node("appearance") == null;
    boolean unlit = !surface.lit() && (painted || material(shape) == null);
    if (mesh.polygons() == 0 || mesh.normals() == null || unlit) {
      return;
    }
    Matrix4dc world = shape.world();
    if (world.determinant3x3() == 0) {
      return; // A scale of 0 leaves no surface that light could fall on.
    }
    float[] positions = moved(mesh.positions(), world);
    float[] normals = turned(mesh.normals(), world);
    for (float value : positions) {
      if (!Float.isFinite(value)) {
        problems.warning(
            shape.node().location(), "a coordinate of the shape is not finite; it is left out");
        return;
      }
    }
    float[] reflectance = surface.lit() ? reflectance(surface, mesh) : new float[] {0, 0, 0};
    float opaque = 1 - surface.transparency();
    float[] emission = Photometry.linear(surface.emissive());
    for (int c = 0; c < 3; c++) {
      emission[c] *= (float) (Photometry.WHITE * opaque);
    }
    bodies.add(
        new Body(
            shape,
            mesh,
            positions,
            normals,
            world.determinant3x3() < 0,
            version,
            budget,
            triangles,
            reflectance,
            emission,
            surface.transparency()));
    triangles += mesh.polygons();
  }

  private static @org.jspecify.annotations.Nullable Object material(ShapeInstance shape) {
    var appearance = shape.node().node("appearance");
    return appearance == null || !appearance.type().name().equals("Appearance")
        ? null
        : appearance.node("material");
  }

  /** Returns the reflectance of a mesh; instances of one mesh share it. */
  private float[] reflectance(SurfaceMaterial surface, Mesh mesh) {
    return mesh.colors() == null && surface.texture() == null
        ? TriangleReflectance.of(surface, mesh)
        : reflectances.computeIfAbsent(mesh, key -> TriangleReflectance.of(surface, mesh));
  }

  private float[] moved(float[] local, Matrix4dc world) {
    float[] out = new float[local.length];
    Vector3d v = new Vector3d();
    for (int i = 0; i < local.length; i += 3) {
      world.transformPosition(v.set(local[i], local[i + 1], local[i + 2])).mul(unit);
      out[i] = (float) v.x;
      out[i + 1] = (float) v.y;
      out[i + 2] = (float) v.z;
    }
    return out;
  }

  private static float[] turned(float[] local, Matrix4dc world) {
    float[] out = new float[local.length];
    org.joml.Matrix3d normal = world.normal(new org.joml.Matrix3d());
    Vector3d v = new Vector3d();
    for (int i = 0; i < local.length; i += 3) {
      normal.transform(v.set(local[i], local[i + 1], local[i + 2])).normalize();
      out[i] = (float) v.x;
      out[i + 1] = (float) v.y;
      out[i + 2] = (float) v.z;
    }
    return out;
  }
}
