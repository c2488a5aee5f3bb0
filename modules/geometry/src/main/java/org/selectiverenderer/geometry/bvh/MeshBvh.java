package org.selectiverenderer.geometry.bvh;

import java.util.Optional;
import java.util.function.IntConsumer;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A bounding volume hierarchy over the triangles of a mesh, for ray casts and box queries in the
 * mesh's local coordinates. A mesh of lines or points has no triangles.
 *
 * <p>Immutable. It refers to the mesh's arrays but not to the mesh, so that a weak cache keyed by
 * the mesh can drop it.
 */
public final class MeshBvh {
  /** The sides of triangles that a ray can hit. */
  public enum Sides {
    /** The front side and the back side. */
    BOTH,
    /** Only the front side, seen from which a triangle is wound counter-clockwise. */
    FRONT
  }

  /**
   * The intersection of a ray and a triangle.
   *
   * @param distance the ray parameter, in lengths of the ray's direction
   * @param triangle the index of the triangle; its vertex indices begin at three times that
   * @param u barycentric coordinate of the second corner; that of the first is 1 - u - v
   * @param v barycentric coordinate of the third corner
   */
  public record MeshHit(double distance, int triangle, double u, double v) {}

  /** Barycentric tolerance at edges, so that no ray passes between two triangles. */
  private static final double EDGE = 1e-9;

  private final float[] positions;
  private final int[] indices;
  private final Bvh tree;

  /** Builds the hierarchy of a mesh. */
  public MeshBvh(Mesh mesh) {
    positions = mesh.positions();
    indices = mesh.primitive() == Mesh.Primitive.TRIANGLES ? mesh.indices() : new int[0];
    tree = BvhBuilder.build(indices.length / 3, this::box);
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
   * Returns the nearest intersection of a ray with the mesh.
   *
   * @param direction a vector of any length but 0
   * @param limit the greatest ray parameter, in lengths of the direction; may be infinite
   */
  public Optional<MeshHit> nearest(
      Vector3dc origin, Vector3dc direction, double limit, Sides sides) {
    Search search = new Search(origin, direction, sides);
    tree.ray(origin, direction, limit, search);
    return Optional.ofNullable(search.found);
  }

  /** Ray-triangle intersection (Möller and Trumbore 1997), in double precision. */
  private final class Search implements Bvh.ItemTest {
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
   * Reports the triangles whose bounding boxes overlap a box.
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
   * Returns a corner of a triangle.
   *
   * @param corner 0, 1 or 2
   * @return {@code out}
   */
  public Vector3d corner(int triangle, int corner, Vector3d out) {
    int at = 3 * indices[3 * triangle + corner];
    return out.set(positions[at], positions[at + 1], positions[at + 2]);
  }
}
