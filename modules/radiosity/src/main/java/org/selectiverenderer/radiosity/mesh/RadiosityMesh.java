package org.selectiverenderer.radiosity.mesh;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.RadiosityScene;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;

/**
 * The mesh on which light is stored at vertices: all facets and the vertices that they share.
 * Facets of a body are consecutive. Bodies without versions share vertices with each other, so that
 * light is continuous over the joints of a floor. Immutable once built.
 *
 * @param corners nine numbers per facet: x, y, z of its corners in world coordinates, metres
 * @param vertexOf the vertices of each facet, three numbers per facet
 * @param source the scene's triangle of each facet
 * @param firstOfBody the first facet of each body, and at the end the number of facets
 * @param vertices number of vertices
 * @param divided facets of subdivided bodies, by body
 */
public record RadiosityMesh(
    float[] corners,
    int[] vertexOf,
    int[] source,
    int[] firstOfBody,
    int vertices,
    Map<Integer, List<Facet>> divided) {

  /**
   * Key of a vertex: its position and normal, rounded, so that vertices which differ by rounding
   * only are one.
   */
  private record Weld(long place, int normal) {}

  public int count() {
    return source.length;
  }

  /**
   * @param divided facets of subdivided bodies, by body; all others have those of their triangles
   */
  public static RadiosityMesh of(RadiosityScene scene, Map<Integer, List<Facet>> divided) {
    List<Body> bodies = scene.bodies();
    int[] firstOfBody = new int[bodies.size() + 1];
    for (int i = 0; i < bodies.size(); i++) {
      List<Facet> parts = divided.get(i);
      firstOfBody[i + 1] =
          Math.addExact(firstOfBody[i], parts == null ? bodies.get(i).triangles() : parts.size());
    }
    int count = firstOfBody[bodies.size()];
    Builder builder = new Builder(count);
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      List<Facet> parts = divided.get(i);
      if (body.version() == ObjectVersionIndex.FIXED) {
        for (int k = 0; k < firstOfBody[i + 1] - firstOfBody[i]; k++) {
          builder.weld(parts == null ? Facet.of(body, k) : parts.get(k));
        }
      } else {
        builder.own(body);
      }
    }
    return new RadiosityMesh(
        builder.corners, builder.vertexOf, builder.source, firstOfBody, builder.vertices, divided);
  }

  private static final class Builder {
    final float[] corners;
    final int[] vertexOf;
    final int[] source;
    private final Map<Weld, Integer> welds = new HashMap<>();
    private int at;
    int vertices;

    Builder(int count) {
      corners = new float[9 * count];
      vertexOf = new int[3 * count];
      source = new int[count];
    }

    void weld(Facet facet) {
      source[at] = facet.source();
      System.arraycopy(facet.corners(), 0, corners, 9 * at, 9);
      for (int corner = 0; corner < 3; corner++) {
        Weld key =
            new Weld(place(facet.corners(), 3 * corner), direction(facet.normals(), 3 * corner));
        Integer known = welds.putIfAbsent(key, vertices);
        vertexOf[3 * at + corner] = known == null ? vertices++ : known;
      }
      at++;
    }

    /**
     * Adds a body that shares no vertices with other bodies, since no other version may share them.
     */
    void own(Body body) {
      int[] ids = new int[body.mesh().vertexCount()];
      Arrays.fill(ids, -1);
      for (int i = 0; i < body.triangles(); i++) {
        source[at] = body.firstTriangle() + i;
        for (int corner = 0; corner < 3; corner++) {
          int vertex = body.vertex(i, corner);
          System.arraycopy(body.positions(), 3 * vertex, corners, 9 * at + 3 * corner, 3);
          if (ids[vertex] < 0) {
            ids[vertex] = vertices++;
          }
          vertexOf[3 * at + corner] = ids[vertex];
        }
        at++;
      }
    }
  }

  /**
   * Returns a hash key of a position, rounded to a 50th of a millimetre; 21 bits an axis repeat
   * after 42 m, too far apart to be neighbours.
   */
  static long place(float[] xyz, int at) {
    long key = 0;
    for (int axis = 0; axis < 3; axis++) {
      key = key << 21 | Math.round(xyz[at + axis] * 50_000.0) & 0x1fffff;
    }
    return key;
  }

  private static int direction(float[] xyz, int at) {
    int key = 0;
    for (int axis = 0; axis < 3; axis++) {
      key = key << 9 | Math.round(xyz[at + axis] * 100) + 128;
    }
    return key;
  }

  /** Returns the facet corners at each vertex. */
  public Corners cornersByVertex() {
    int[] first = new int[vertices + 1];
    for (int vertex : vertexOf) {
      first[vertex + 1]++;
    }
    for (int i = 0; i < vertices; i++) {
      first[i + 1] += first[i];
    }
    int[] next = first.clone();
    int[] all = new int[vertexOf.length];
    for (int i = 0; i < vertexOf.length; i++) {
      all[next[vertexOf[i]]++] = i;
    }
    return new Corners(first, all);
  }

  /** Returns the facets of bodies that were divided. */
  public BitSet ofDividedBodies() {
    BitSet all = new BitSet(count());
    for (int body : divided.keySet()) {
      all.set(firstOfBody[body], firstOfBody[body + 1]);
    }
    return all;
  }

  /**
   * @param first per vertex: the index of its first corner; one more entry at the end
   * @param corners facet corners, each three times the facet plus the corner, vertex after vertex
   */
  public record Corners(int[] first, int[] corners) {}
}
