package org.selectiverenderer.browser.picking;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.bvh.PointInMesh;
import org.selectiverenderer.geometry.convex.ConvexShape;
import org.selectiverenderer.geometry.convex.GjkIntersection;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Picks with a convex body: an X3D primitive, which picks every shape that intersects it (X3D 4.0,
 * PrimitivePickSensor, 38.4.4), or the convex hull of any geometry, which picks shapes with a
 * vertex inside it (VolumePickSensor, 38.4.5). Shapes are sorted by the distance of their centres
 * from the body's centre, or from a cone's tip.
 */
final class ConvexBodyPicker implements Picker {
  private final ConvexShape body;
  private final BoundingBox box;
  private final Vector3dc middle;
  private final boolean vertices;

  /**
   * @param box the bounding box of the body
   * @param middle the point from which distances are measured
   * @param vertices whether only the vertices of shapes are tested
   */
  ConvexBodyPicker(ConvexShape body, BoundingBox box, Vector3dc middle, boolean vertices) {
    this.body = body;
    this.box = box;
    this.middle = middle;
    this.vertices = vertices;
  }

  @Override
  public BoundingBox box() {
    return box;
  }

  private Met met(PickTarget target) {
    return new Met(Picker.toMiddle(target, middle), List.of());
  }

  /** Always picks: the caller has tested the bounding boxes already. */
  @Override
  public Optional<Met> bounds(PickTarget target) {
    return Optional.of(met(target));
  }

  @Override
  public Optional<Met> mesh(PickTarget target) {
    boolean meets = vertices ? holdsVertex(target) : meetsPart(target) || isWithin(target);
    return meets ? Optional.of(met(target)) : Optional.empty();
  }

  private boolean holdsVertex(PickTarget target) {
    BitSet tried = new BitSet(); // Triangles share vertices.
    for (int index : target.mesh().indices()) {
      if (tried.get(index)) {
        continue;
      }
      tried.set(index);
      Vector3d at = vertex(target, index);
      if (box.contains(at) && GjkIntersection.of(body, ConvexShape.hull(at.x, at.y, at.z))) {
        return true;
      }
    }
    return false;
  }

  private static Vector3d vertex(PickTarget target, int index) {
    float[] p = target.mesh().positions();
    return target
        .toSensor()
        .transformPosition(new Vector3d(p[3 * index], p[3 * index + 1], p[3 * index + 2]));
  }

  private boolean meetsPart(PickTarget target) {
    if (target.mesh().primitive() != Mesh.Primitive.TRIANGLES) {
      int corners = target.mesh().primitive() == Mesh.Primitive.LINES ? 2 : 1;
      for (int i = 0; i + corners <= target.mesh().indices().length; i += corners) {
        if (meets(target, i, corners)) {
          return true;
        }
      }
      return false;
    }
    boolean[] found = new boolean[1];
    target
        .tree()
        .inBox(
            box.transformed(target.fromSensor()).toArray(),
            triangle -> found[0] = found[0] || meets(target, 3 * triangle, 3));
    return found[0];
  }

  /**
   * Returns whether the body intersects the primitive (point, line or triangle) that some indices
   * of a mesh form.
   */
  private boolean meets(PickTarget target, int first, int corners) {
    double[] points = new double[3 * corners];
    for (int corner = 0; corner < corners; corner++) {
      Vector3d at = vertex(target, target.mesh().indices()[first + corner]);
      points[3 * corner] = at.x;
      points[3 * corner + 1] = at.y;
      points[3 * corner + 2] = at.z;
    }
    return GjkIntersection.of(body, ConvexShape.hull(points));
  }

  /** Returns whether the body is inside a shape without touching its surface. */
  private boolean isWithin(PickTarget target) {
    Vector3d inside = box.min().add(box.max()).mul(0.5);
    target.fromSensor().transformPosition(inside);
    return target.mesh().polygons() > 0 && PointInMesh.contains(target.tree(), inside, 0);
  }
}
