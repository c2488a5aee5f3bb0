package org.selectiverenderer.browser.nodes.particle;

import java.util.Arrays;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Builds the mesh of a system's particles by its {@code geometryType} (X3D 4.0, 40.4.9): POINT;
 * LINE along each particle's velocity; QUAD and TRIANGLE in the system's x-y plane; SPRITE facing
 * the viewer; GEOMETRY, a copy of a geometry at each particle.
 */
final class ParticleMeshBuilder {
  /** Largest number of vertices; the geometries of further particles are left out. */
  private static final int MAX_VERTICES = 2_000_000;

  /** Largest number of indices. */
  private static final int MAX_INDICES = 3 * MAX_VERTICES;

  private static final float[] QUAD = {0, 0, 1, 0, 1, 1, 0, 1};

  private final Node system;
  private final ParticlePool particles;
  private final double ahead;

  /**
   * @param ahead the time in seconds by which positions are extrapolated
   */
  ParticleMeshBuilder(Node system, ParticlePool particles, double ahead) {
    this.system = system;
    this.particles = particles;
    this.ahead = ahead;
  }

  /**
   * @param right the viewer's right in local coordinates, for sprites
   * @param up the viewer's up in local coordinates, for sprites
   * @param geometry the mesh to be copied to each particle, for GEOMETRY
   */
  Mesh make(Vector3dc right, Vector3dc up, @Nullable Mesh geometry) {
    return switch (system.string("geometryType")) {
      case "POINT" -> points();
      case "LINE" -> lines();
      case "GEOMETRY" -> geometry == null ? points() : copies(geometry);
      case "SPRITE" -> quads(right, up);
      default -> quads(new Vector3d(1, 0, 0), new Vector3d(0, 1, 0));
    };
  }

  private void put(int i, float[] xyz, int at) {
    Vector3d p = particles.positions[i];
    Vector3d v = particles.velocities[i];
    xyz[at] = (float) (p.x + ahead * v.x);
    xyz[at + 1] = (float) (p.y + ahead * v.y);
    xyz[at + 2] = (float) (p.z + ahead * v.z);
  }

  private Mesh points() {
    float[] xyz = new float[3 * particles.count()];
    for (int i = 0; i < particles.count(); i++) {
      put(i, xyz, 3 * i);
    }
    return mesh(Mesh.Primitive.POINTS, xyz, null, 1, null, identity(particles.count()));
  }

  private Mesh lines() {
    float half = system.floats("particleSize")[1] / 2;
    float[] xyz = new float[6 * particles.count()];
    for (int i = 0; i < particles.count(); i++) {
      put(i, xyz, 6 * i);
      System.arraycopy(xyz, 6 * i, xyz, 6 * i + 3, 3);
      Vector3d v = particles.velocities[i];
      double length = v.length();
      for (int axis = 0; axis < 3 && length > 0; axis++) {
        float reach = (float) (half * v.get(axis) / length);
        xyz[6 * i + axis] -= reach;
        xyz[6 * i + 3 + axis] += reach;
      }
    }
    float[] texCoords = texCoords(2, new float[] {0, 0, 1, 0});
    return mesh(Mesh.Primitive.LINES, xyz, null, 2, texCoords, identity(2 * particles.count()));
  }

  private Mesh quads(Vector3dc right, Vector3dc up) {
    int count = particles.count();
    float[] size = system.floats("particleSize");
    float[] xyz = new float[12 * count];
    float[] normals = new float[12 * count];
    int[] indices = new int[6 * count];
    Vector3d normal = right.cross(up, new Vector3d());
    for (int i = 0; i < count; i++) {
      put(i, xyz, 12 * i);
      float[] middle = Arrays.copyOfRange(xyz, 12 * i, 12 * i + 3);
      for (int corner = 0; corner < 4; corner++) {
        double x = (QUAD[2 * corner] - 0.5) * size[0];
        double y = (QUAD[2 * corner + 1] - 0.5) * size[1];
        for (int axis = 0; axis < 3; axis++) {
          int at = 12 * i + 3 * corner + axis;
          xyz[at] = (float) (middle[axis] + x * right.get(axis) + y * up.get(axis));
          normals[at] = (float) normal.get(axis);
        }
      }
      int[] two = {0, 1, 2, 0, 2, 3};
      for (int k = 0; k < 6; k++) {
        indices[6 * i + k] = 4 * i + two[k];
      }
    }
    return mesh(Mesh.Primitive.TRIANGLES, xyz, normals, 4, texCoords(4, QUAD), indices);
  }

  private Mesh copies(Mesh geometry) {
    int vertices = geometry.vertexCount();
    int each = geometry.indices().length;
    int room = Math.min(MAX_VERTICES / Math.max(1, vertices), MAX_INDICES / Math.max(1, each));
    int count = Math.min(particles.count(), room);
    float[] xyz = new float[3 * vertices * count];
    int[] indices = new int[each * count];
    float[] at = new float[3];
    for (int i = 0; i < count; i++) {
      put(i, at, 0);
      for (int k = 0; k < 3 * vertices; k++) {
        xyz[3 * vertices * i + k] = geometry.positions()[k] + at[k % 3];
      }
      for (int k = 0; k < each; k++) {
        indices[each * i + k] = geometry.indices()[k] + vertices * i;
      }
    }
    float[] texCoords = repeated(geometry.texCoords(), count);
    float[] colors = colors(vertices, count);
    return new Mesh(
        geometry.primitive(),
        xyz,
        repeated(geometry.normals(), count),
        colors != null ? colors : repeated(geometry.colors(), count),
        texCoords,
        indices,
        geometry.solid(),
        Mesh.boundsOf(xyz, indices));
  }

  private static float @Nullable [] repeated(float @Nullable [] values, int count) {
    if (values == null) {
      return null;
    }
    float[] all = new float[values.length * count];
    for (int i = 0; i < count; i++) {
      System.arraycopy(values, 0, all, i * values.length, values.length);
    }
    return all;
  }

  private Mesh mesh(
      Mesh.Primitive primitive,
      float[] xyz,
      float @Nullable [] normals,
      int corners,
      float @Nullable [] texCoords,
      int[] indices) {
    return new Mesh(
        primitive,
        xyz,
        normals,
        colors(corners, particles.count()),
        texCoords,
        indices,
        false,
        Mesh.boundsOf(xyz, indices));
  }

  private static int[] identity(int count) {
    int[] all = new int[count];
    Arrays.setAll(all, i -> i);
    return all;
  }

  /** Returns a particle's age as a fraction of its lifetime. */
  private float life(int i) {
    return (float) Math.min(1, (particles.ages[i] + ahead) / particles.lifetimes[i]);
  }

  /**
   * Returns the colours interpolated from the colour ramp by age, for each vertex of each particle.
   */
  private float @Nullable [] colors(int corners, int count) {
    Node ramp = system.node("color");
    if (ramp == null) {
      return null;
    }
    float[] key = system.floats("colorKey");
    float[] given = ramp.floats("color");
    int size = ramp.type().name().equals("ColorRGBA") ? 4 : 3;
    int keys = Math.min(key.length, given.length / size);
    if (keys == 0) {
      return null;
    }
    float[] colors = new float[4 * corners * count];
    for (int i = 0; i < count; i++) {
      float life = life(i);
      int low = RampLookup.at(key, keys, life);
      float part = RampLookup.part(key, keys, low, life);
      for (int c = 0; c < 4; c++) {
        float a = c < size ? given[size * low + c] : 1;
        float b = c < size ? given[size * Math.min(low + 1, keys - 1) + c] : 1;
        float mixed = Math.max(0, Math.min(a + part * (b - a), 1));
        for (int corner = 0; corner < corners; corner++) {
          colors[4 * (corners * i + corner) + c] = mixed;
        }
      }
    }
    return colors;
  }

  /** Returns the texture coordinates of the last key reached, or those of the whole texture. */
  private float[] texCoords(int corners, float[] whole) {
    int count = particles.count();
    float[] all = new float[2 * corners * count];
    Node ramp = system.node("texCoord");
    float[] key = system.floats("texCoordKey");
    float[] given =
        ramp != null && ramp.type().name().equals("TextureCoordinate")
            ? ramp.floats("point")
            : new float[0];
    int keys = Math.min(key.length, given.length / (2 * corners));
    for (int i = 0; i < count; i++) {
      int from = keys == 0 ? 0 : 2 * corners * RampLookup.at(key, keys, life(i));
      float[] source = keys == 0 ? whole : given;
      System.arraycopy(source, from, all, 2 * corners * i, 2 * corners);
    }
    return all;
  }

  /** Searches the keys of a colour or texture coordinate ramp for a particle's age. */
  private static final class RampLookup {
    private RampLookup() {}

    /** Returns the index of the last key that is not above the age; 0 below the first key. */
    static int at(float[] key, int count, float life) {
      int low = 0;
      while (low + 1 < count && key[low + 1] <= life) {
        low++;
      }
      return low;
    }

    /** Returns the position of the age between that key and the next, 0 to 1. */
    static float part(float[] key, int count, int low, float life) {
      if (low + 1 >= count || !(key[low + 1] > key[low])) {
        return 0;
      }
      return Math.max(0, Math.min((life - key[low]) / (key[low + 1] - key[low]), 1));
    }
  }
}
