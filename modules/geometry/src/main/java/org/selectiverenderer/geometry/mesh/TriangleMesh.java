package org.selectiverenderer.geometry.mesh;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.function.UnaryOperator;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.DegreeMath;

/**
 * An immutable triangle mesh: operations return new meshes, and the arrays must not be modified.
 *
 * @param positions x, y, z per point, metres
 * @param triangles three point indices each, counter-clockwise seen from outside
 */
public record TriangleMesh(float[] positions, int[] triangles) {

  /** The mesh without triangles. */
  public static final TriangleMesh EMPTY = new TriangleMesh(new float[0], new int[0]);

  /** Returns the number of triangles. */
  public int triangleCount() {
    return triangles.length / 3;
  }

  /** Returns the number of points. */
  public int pointCount() {
    return positions.length / 3;
  }

  /** Returns a point by its index. */
  public Vector3d point(int index) {
    return new Vector3d(positions[3 * index], positions[3 * index + 1], positions[3 * index + 2]);
  }

  /** Returns the bounding box of the points. */
  public BoundingBox bounds() {
    return BoundingBox.around(positions);
  }

  /** Concatenates meshes without welding their points. */
  public static TriangleMesh of(TriangleMesh... meshes) {
    return of(List.of(meshes));
  }

  /** Concatenates meshes without welding their points. */
  public static TriangleMesh of(Collection<TriangleMesh> meshes) {
    float[] positions = new float[meshes.stream().mapToInt(m -> m.positions.length).sum()];
    int[] triangles = new int[meshes.stream().mapToInt(m -> m.triangles.length).sum()];
    int point = 0;
    int corner = 0;
    for (TriangleMesh mesh : meshes) {
      System.arraycopy(mesh.positions, 0, positions, 3 * point, mesh.positions.length);
      for (int index : mesh.triangles) {
        triangles[corner++] = point + index;
      }
      point += mesh.pointCount();
    }
    return new TriangleMesh(positions, triangles);
  }

  /** Concatenates this mesh and another without welding. */
  public TriangleMesh append(TriangleMesh other) {
    return of(this, other);
  }

  /** Maps every point by a function; the winding of the triangles is kept. */
  public TriangleMesh deform(UnaryOperator<Vector3d> function) {
    float[] moved = new float[positions.length];
    for (int i = 0; i < pointCount(); i++) {
      Vector3d p = function.apply(point(i));
      moved[3 * i] = (float) p.x;
      moved[3 * i + 1] = (float) p.y;
      moved[3 * i + 2] = (float) p.z;
    }
    return new TriangleMesh(moved, triangles);
  }

  /** Returns the mesh translated, in metres. */
  public TriangleMesh move(double x, double y, double z) {
    return deform(p -> p.add(x, y, z));
  }

  /** Returns the mesh scaled about the origin. */
  public TriangleMesh scale(double factor) {
    return scale(factor, factor, factor);
  }

  /** Returns the mesh scaled about the origin; a mirrored mesh is not turned inside out. */
  public TriangleMesh scale(double x, double y, double z) {
    TriangleMesh scaled = deform(p -> p.mul(x, y, z));
    return x * y * z < 0 ? scaled.flip() : scaled;
  }

  /** Returns the mesh rotated about the x axis; positive turns +y towards +z. */
  public TriangleMesh turnX(double degrees) {
    double s = DegreeMath.sin(degrees);
    double c = DegreeMath.cos(degrees);
    return deform(p -> p.set(p.x, c * p.y - s * p.z, s * p.y + c * p.z));
  }

  /** Returns the mesh rotated about the y axis; positive turns +z towards +x. */
  public TriangleMesh turnY(double degrees) {
    double s = DegreeMath.sin(degrees);
    double c = DegreeMath.cos(degrees);
    return deform(p -> p.set(c * p.x + s * p.z, p.y, c * p.z - s * p.x));
  }

  /** Returns the mesh rotated about the z axis; positive turns +x towards +y. */
  public TriangleMesh turnZ(double degrees) {
    double s = DegreeMath.sin(degrees);
    double c = DegreeMath.cos(degrees);
    return deform(p -> p.set(c * p.x - s * p.y, s * p.x + c * p.y, p.z));
  }

  /** Returns the mesh mirrored at the plane x = 0, its faces still outwards. */
  public TriangleMesh mirrorX() {
    return scale(-1, 1, 1);
  }

  /** Returns the mesh mirrored at the plane z = 0, its faces still outwards. */
  public TriangleMesh mirrorZ() {
    return scale(1, 1, -1);
  }

  /** Returns the mesh with reversed winding. */
  public TriangleMesh flip() {
    int[] turned = triangles.clone();
    for (int t = 0; t < turned.length; t += 3) {
      turned[t + 1] = triangles[t + 2];
      turned[t + 2] = triangles[t + 1];
    }
    return new TriangleMesh(positions, turned);
  }

  /** Returns the mesh with reversed winding if it encloses a negative volume. */
  public TriangleMesh outward() {
    return MeshMeasures.volume(this) < 0 ? flip() : this;
  }

  /** Returns whether the mesh is a closed 2-manifold: each edge has exactly one opposite. */
  public boolean isClosed() {
    return triangles.length > 0 && MeshMeasures.openEdges(this) == 0;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof TriangleMesh mesh
        && Arrays.equals(positions, mesh.positions)
        && Arrays.equals(triangles, mesh.triangles);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(positions) + Arrays.hashCode(triangles);
  }

  @Override
  public String toString() {
    return "TriangleMesh[" + pointCount() + " points, " + triangleCount() + " triangles]";
  }
}
