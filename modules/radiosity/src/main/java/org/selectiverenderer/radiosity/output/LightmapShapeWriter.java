package org.selectiverenderer.radiosity.output;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.geometry.TriangleMath;
import org.selectiverenderer.radiosity.atlas.Atlas;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.bake.DiffuseTexture;
import org.selectiverenderer.radiosity.bake.LightmappedScene;
import org.selectiverenderer.radiosity.mesh.Facet;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.trace.ObjectVersionIndex;
import org.selectiverenderer.radiosity.trace.SceneTriangles;
import org.selectiverenderer.x3d.write.TupleListBuilder;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes the geometry of a shape whose light is in a lightmap: an IndexedTriangleStripSet with
 * lightmap texture coordinates, preceded by those of its own texture if that stays, and with
 * normals if it is glossy. Vertices are shared where all of these agree.
 */
final class LightmapShapeWriter {
  /**
   * Least number of coordinate steps across the extent of a room's surface, and of an object's: the
   * surfaces of rooms must meet without gaps, and objects make up nearly all of the text.
   */
  private static final double ROOM = 30_000;

  private static final double OBJECT = 3_000;

  /**
   * Steps of a texture coordinate in a texel, or in a pixel of an image: so coordinates are exact
   * to a 16th of it.
   */
  private static final double FINE = 8;

  private static final int NORMAL_DECIMALS = 2;
  private static final int MOST_DECIMALS = 9;

  /**
   * Ratio of height to longest edge below which a facet may count as degenerate, with a safety
   * margin.
   */
  private static final double FLAT = 1e-7;

  private final LightmappedScene lit;
  private final boolean apart;
  private final boolean normals;

  /**
   * @param apart whether the body's own texture stays a texture of its own
   * @param normals whether normals are written
   */
  LightmapShapeWriter(LightmappedScene lit, boolean apart, boolean normals) {
    this.lit = lit;
    this.apart = apart;
    this.normals = normals;
  }

  /**
   * The number lists of a shape: positions, normals, coordinates of its own texture, coordinates of
   * the lightmap, and the vertex of each corner.
   */
  private record Lists(
      TupleListBuilder points,
      TupleListBuilder turned,
      TupleListBuilder own,
      TupleListBuilder light,
      int[] index) {}

  void geometry(X3dWriter out, int number) {
    Body body = lit.scene().bodies().get(number);
    Lists lists = lists(body, number);
    out.open("IndexedTriangleStripSet");
    if (!body.mesh().solid()) {
      out.attribute("solid", "false");
    }
    out.numbers("index", GeometryNumberFormat.strips(lists.index()));
    out.open("Coordinate").numbers("point", lists.points().text()).close();
    if (normals) {
      out.open("Normal").numbers("vector", lists.turned().text()).close();
    }
    if (apart) {
      out.open("MultiTextureCoordinate");
      out.open("TextureCoordinate").numbers("point", lists.own().text()).close();
    }
    out.open("TextureCoordinate").numbers("point", lists.light().text()).close();
    if (apart) {
      out.close();
    }
    out.close();
  }

  private Lists lists(Body body, int number) {
    List<Facet> divided = lit.divided().get(number);
    int count = divided == null ? body.triangles() : divided.size();
    Atlas.Layout layout = lit.atlas().layouts().get(number);
    AtlasPage page = lit.atlas().pages().get(layout.page());
    int fine = decimals(Math.max(page.width(), page.height()));
    DiffuseTexture own = apart ? DiffuseTexture.of(body) : null;
    int decimals = decimals(body, divided, count);
    int[] index = new int[3 * count];
    Lists lists =
        new Lists(
            GeometryNumberFormat.lines(),
            GeometryNumberFormat.lines(),
            GeometryNumberFormat.lines(),
            GeometryNumberFormat.lines(),
            index);
    Map<String, Integer> known = new HashMap<>();
    StringBuilder key = new StringBuilder();
    int[] ends = new int[4];
    for (int facet = 0; facet < count; facet++) {
      for (int i = 0; i < 3; i++) {
        // A shape whose transform mirrors it is written with its original winding.
        int corner = body.mirrored() && i > 0 ? 3 - i : i;
        Corner at = corner(body, divided == null ? null : divided.get(facet), facet, corner);
        key.setLength(0);
        GeometryNumberFormat.tuple(key, at.local(), decimals);
        ends[0] = key.length();
        if (normals) {
          GeometryNumberFormat.tuple(key.append(';'), at.normal(body), NORMAL_DECIMALS);
        }
        ends[1] = key.length();
        if (own != null) {
          GeometryNumberFormat.tuple(
              key.append(';'), at.own(own), decimals(Math.max(own.width(), own.height())));
        }
        ends[2] = key.length();
        GeometryNumberFormat.tuple(key.append(';'), at.light(layout), fine);
        Integer id = known.get(key.toString());
        if (id == null) {
          id = known.size();
          known.put(key.toString(), id);
          lists.points().next().append(key, 0, ends[0]);
          add(lists.turned(), key, ends[0], ends[1]);
          add(lists.own(), key, ends[1], ends[2]);
          add(lists.light(), key, ends[2], key.length());
        }
        index[3 * facet + i] = id;
      }
    }
    return lists;
  }

  /** Appends the part of the key that follows a semicolon, if there is one. */
  private static void add(TupleListBuilder lines, StringBuilder key, int from, int to) {
    if (to > from) {
      lines.next().append(key, from + 1, to);
    }
  }

  /**
   * Returns the least number of decimals with which every facet keeps an area, since a browser does
   * not count degenerate facets.
   */
  private int decimals(Body body, @Nullable List<Facet> divided, int count) {
    double least = body.version() == ObjectVersionIndex.FIXED ? ROOM : OBJECT;
    int decimals = GeometryNumberFormat.decimals(body.mesh(), least);
    for (int facet = 0; facet < count; facet++) {
      Facet part = divided == null ? null : divided.get(facet);
      while (decimals < MOST_DECIMALS && flat(body, part, facet, decimals)) {
        decimals++;
      }
    }
    return decimals;
  }

  private boolean flat(Body body, @Nullable Facet part, int facet, int decimals) {
    double unit = DecimalFormatter.unit(decimals);
    float[] read = new float[9];
    for (int i = 0; i < 3; i++) {
      double[] local = corner(body, part, facet, i).local();
      for (int axis = 0; axis < 3; axis++) {
        read[3 * i + axis] = (float) (Math.rint(local[axis] * unit) / unit);
      }
    }
    return !TriangleMath.hasArea(read, 0, 3, 6, FLAT * FLAT);
  }

  private static int decimals(int pixels) {
    int digits = 1;
    for (double steps = 10; steps < FINE * pixels; steps *= 10) {
      digits++;
    }
    return digits;
  }

  /**
   * The corner of a facet as a point of a triangle of its body.
   *
   * @param triangle number of the triangle in the body
   * @param local x, y, z in the shape's local coordinates
   */
  private record Corner(int triangle, double u, double v, double[] local) {
    double[] light(Atlas.Layout layout) {
      return new double[] {layout.s(triangle, u, v), layout.t(triangle, u, v)};
    }

    double[] own(DiffuseTexture texture) {
      double[] st = new double[2];
      texture.place(triangle, u, v, st);
      return st;
    }

    /** Returns the interpolated unit normal in the shape's local coordinates. */
    double[] normal(Body body) {
      float[] all = body.mesh().normals();
      double[] sum = new double[3];
      if (all == null) {
        throw new IllegalStateException("a lit body without normals");
      }
      double[] weights = {1 - u - v, u, v};
      for (int corner = 0; corner < 3; corner++) {
        int at = 3 * body.vertex(triangle, corner);
        for (int axis = 0; axis < 3; axis++) {
          sum[axis] += weights[corner] * all[at + axis];
        }
      }
      TriangleMath.normalize(sum);
      return sum;
    }
  }

  private Corner corner(Body body, @Nullable Facet facet, int triangle, int corner) {
    double[] local = new double[3];
    if (facet == null) {
      int at = 3 * body.vertex(triangle, corner);
      for (int axis = 0; axis < 3; axis++) {
        local[axis] = body.mesh().positions()[at + axis];
      }
      return new Corner(triangle, corner == 1 ? 1 : 0, corner == 2 ? 1 : 0, local);
    }
    double[] point = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      local[axis] = facet.local()[3 * corner + axis];
      point[axis] = facet.corners()[3 * corner + axis];
    }
    double[] weights = new double[2];
    SceneTriangles.weights(lit.scene().triangles().corners(), facet.source(), point, weights);
    return new Corner(facet.source() - body.firstTriangle(), weights[0], weights[1], local);
  }
}
