package org.selectiverenderer.geometry.tree;

import java.util.Optional;
import java.util.function.IntConsumer;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Finds the triangles of a mesh along a ray or near a place, in the mesh's local coordinates. Lines
 * and points have no surface: nothing is found in them.
 *
 * <p>Immutable once made. It keeps the mesh's arrays but not the mesh, so that a cache can let go
 * of it together with the mesh.
 */
public final class MeshTree {
  /** Which sides of the triangles a ray hits. */
  public enum Sides {
    BOTH,
    /** Only triangles seen from the side on which they are wound counter-clockwise. */
    FRONT
  }

  /**
   * Where a ray meets a triangle.
   *
   * @param distance from the ray's origin, in lengths of its direction
   * @param triangle its number; its indices begin at three times that
   * @param u weight of its second corner; the first corner's is 1 - u - v
   * @param v weight of its third corner
   */
  public record MeshHit(double distance, int triangle, double u, double v) {}

  /** How far beyond an edge a ray still hits, so that none slips between two triangles. */
  private static final double EDGE = 1e-9;

  private final float[] positions;
  private final int[] indices;
  private final BoxTree tree;

  public MeshTree(Mesh mesh) {
    positions = mesh.positions();
    indices = mesh.primitive() == Mesh.Primitive.TRIANGLES ? mesh.indices() : new int[0];
    tree = BoxTreeBuilder.build(indices.length / 3, this::box);
  }

  private void box(int triangle, float[] out) {
    int a = 3 * indices[3 * triangle];
    int b = 3 * indices[3 * triangle + 1];
    int c = 3 * indices[3 * triangle + 2];
    for (int axis = 0; axis < 3; axis++) {
      float pa = positions[a + axis];
      float pb = positions[b + axis];
      float pc = positions[c + axis];
      out[axis] = Math.min(pa, Math.min(pb, pc));
      out[axis + 3] = Math.max(pa, Math.max(pb, pc));
    }
  }

  /**
   * The first triangle that a ray hits.
   *
   * @param direction of any length but 0
   * @param limit how far the ray reaches, in lengths of its direction; may be infinite
   */
  public Optional<MeshHit> nearest(
      Vector3dc origin, Vector3dc direction, double limit, Sides sides) {
    Search search = new Search(origin, direction, sides);
    tree.ray(origin, direction, limit, search);
    return Optional.ofNullable(search.found);
  }

  /** Möller and Trumbore 1997, in double precision. */
  private final class Search implements BoxTree.ItemTest {
    private final Vector3dc origin;
    private final Vector3dc direction;
    private final Sides sides;
    private final Vector3d a = new Vector3d();
    private final Vector3d ab = new Vector3d();
    private final Vector3d ac = new Vector3d();
    private final Vector3d p = new Vector3d();
    private final Vector3d q = new Vector3d();
    private @Nullable MeshHit found;

    Search(Vector3dc origin, Vector3dc direction, Sides sides) {
      this.origin = origin;
      this.direction = direction;
      this.sides = sides;
    }

    @Override
    public double test(int triangle, double nearest) {
      corner(triangle, 0, a);
      corner(triangle, 1, ab).sub(a);
      corner(triangle, 2, ac).sub(a);
      direction.cross(ac, p);
      double facing = ab.dot(p);
      if (facing == 0 || (sides == Sides.FRONT && facing < 0)) {
        return nearest;
      }
      origin.sub(a, a);
      double u = a.dot(p) / facing;
      a.cross(ab, q);
      double v = direction.dot(q) / facing;
      double distance = ac.dot(q) / facing;
      if (u >= -EDGE && v >= -EDGE && u + v <= 1 + EDGE && distance >= 0 && distance <= nearest) {
        found = new MeshHit(distance, triangle, u, v);
        return distance;
      }
      return nearest;
    }
  }

  /**
   * Names the triangles whose own boxes touch a box.
   *
   * @param box min x, y, z, max x, y, z
   */
  public void inBox(double[] box, IntConsumer found) {
    float[] own = new float[6];
    tree.overlap(
        box,
        triangle -> {
          box(triangle, own);
          for (int axis = 0; axis < 3; axis++) {
            if (own[axis] > box[axis + 3] || own[axis + 3] < box[axis]) {
              return;
            }
          }
          found.accept(triangle);
        });
  }

  /**
   * A corner of a triangle.
   *
   * @param corner 0, 1 or 2
   * @return {@code out}
   */
  public Vector3d corner(int triangle, int corner, Vector3d out) {
    int at = 3 * indices[3 * triangle + corner];
    return out.set(positions[at], positions[at + 1], positions[at + 2]);
  }
}
