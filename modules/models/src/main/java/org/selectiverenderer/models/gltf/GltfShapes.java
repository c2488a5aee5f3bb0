package org.selectiverenderer.models.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes the primitives of glTF as Shapes. */
final class GltfShapes {
  private final GltfMaterials materials;
  private final X3dWriter out;
  private final GltfProblems problems;

  GltfShapes(GltfTranslation shared) {
    out = shared.out();
    problems = shared.problems();
    materials = new GltfMaterials(shared);
  }

  /**
   * The points and normals of a Shape.
   *
   * @param points x, y, z
   * @param coordinate the DEF name of the Coordinate; "" for none
   * @param normals x, y, z; empty for none
   * @param normal the DEF name of the Normal; "" for none
   * @param moving whether points or normals change, so that given tangents do not fit them
   */
  record Form(float[] points, String coordinate, float[] normals, String normal, boolean moving) {}

  /** The other arrays, all of which are read before anything is written. */
  private record Values(
      List<TextureChannel> channels, List<float[]> texCoords, float[] colors, float[] tangents) {}

  /**
   * Writes a Shape with its points and normals.
   *
   * @throws IOException if an array is damaged; nothing is written then
   */
  void write(GltfPrimitive from, Form form) throws IOException {
    Values values = values(from, !form.moving());
    out.open("Shape");
    materials.write(from.material(), from.faces());
    if (from.faces()) {
      triangles(from, form.normals().length > 0);
      coordinate(form.points(), form.coordinate());
      if (form.normals().length > 0) {
        out.open("Normal").def(form.normal()).ownLine();
        out.numbers("vector", Numbers.list(form.normals())).close();
      }
    } else if (from.mode() == PrimitiveIndices.POINTS) {
      boolean indexed = from.json().has("indices");
      out.open("PointSet");
      coordinate(
          indexed ? picked(form.points(), from.indices(), 3) : form.points(), form.coordinate());
    } else {
      out.open("IndexedLineSet");
      int[] lines = PrimitiveIndices.lines(from.mode(), from.indices());
      out.ownLine().numbers("coordIndex", Numbers.list(lines));
      coordinate(form.points(), form.coordinate());
    }
    finish(from, values);
  }

  /** The Shape of a skin, all arrays of which have been read. */
  @FunctionalInterface
  interface Skinned {
    /**
     * Writes it.
     *
     * @param coordinate the DEF name of the Coordinate, which has been written
     * @param normal that of the Normal; "" for none
     */
    void write(String coordinate, String normal);
  }

  /**
   * Returns the Shape of a skin of triangles.
   *
   * @throws IOException if an array is damaged
   */
  Skinned skinned(GltfPrimitive from) throws IOException {
    Values values = values(from, false);
    return (coordinate, normal) -> {
      out.open("Shape", "containerField", "skin");
      materials.write(from.material(), true);
      triangles(from, !normal.isEmpty());
      out.empty("Coordinate", "USE", coordinate);
      if (!normal.isEmpty()) {
        out.empty("Normal", "USE", normal);
      }
      finish(from, values);
    };
  }

  private void triangles(GltfPrimitive from, boolean withNormals) {
    boolean twoSided = materials.material(from.material()).isTwoSided();
    out.open("IndexedTriangleSet");
    if (twoSided) {
      out.attribute("solid", "false");
    }
    if (!withNormals) {
      out.attribute("normalPerVertex", "false");
    }
    int[] triangles = PrimitiveIndices.triangles(from.mode(), from.indices());
    out.ownLine().numbers("index", Numbers.list(triangles));
  }

  private void coordinate(float[] points, String def) {
    out.open("Coordinate").def(def).ownLine().numbers("point", Numbers.list(points)).close();
  }

  private Values values(GltfPrimitive from, boolean still) throws IOException {
    List<TextureChannel> channels =
        from.faces() ? materials.material(from.material()).channels() : List.of();
    List<float[]> texCoords = new ArrayList<>();
    if (GltfMaterials.plain(channels)) {
      int set = channels.isEmpty() ? -1 : from.attribute("TEXCOORD_0", 2);
      if (set >= 0) {
        texCoords.add(from.accessors().floats(set));
      }
    } else {
      for (TextureChannel channel : channels) {
        texCoords.add(texCoords(from, channel.set()));
      }
    }
    boolean bumpy = still && from.faces() && materials.material(from.material()).hasNormalTexture();
    int tangent = bumpy && from.attribute("NORMAL", 3) >= 0 ? from.attribute("TANGENT", 4) : -1;
    return new Values(
        channels,
        texCoords,
        colors(from),
        tangent < 0 ? new float[0] : from.accessors().floats(tangent));
  }

  private float[] texCoords(GltfPrimitive from, int set) throws IOException {
    int accessor = from.attribute("TEXCOORD_" + set, 2);
    if (accessor < 0) {
      problems.tell(from.path(), "its material needs TEXCOORD_%d, which it lacks".formatted(set));
    }
    return accessor < 0 ? new float[2 * from.vertices()] : from.accessors().floats(accessor);
  }

  /** Writes the rest of a geometry node and ends it and its Shape. */
  private void finish(GltfPrimitive from, Values values) {
    if (values.tangents().length > 0) {
      out.open("Tangent", "containerField", "tangent").ownLine();
      out.numbers("vector", Numbers.list(values.tangents())).close();
    }
    boolean several = !GltfMaterials.plain(values.channels());
    if (several) {
      out.open("MultiTextureCoordinate");
    }
    for (int i = 0; i < values.texCoords().size(); i++) {
      texCoord(values.texCoords().get(i), several ? GltfMaterials.mappingName(i) : "");
    }
    if (several) {
      out.close();
    }
    if (values.colors().length > 0) {
      out.open(4 * vertices(from) == values.colors().length ? "ColorRGBA" : "Color");
      out.ownLine().numbers("color", Numbers.list(values.colors())).close();
    }
    out.close().close();
    if (from.json().path("attributes").has("COLOR_1")) {
      problems.tell(from.path(), "X3D has one colour for each vertex; COLOR_1 is left out");
    }
  }

  /** Returns the number of vertices that are written. */
  private static int vertices(GltfPrimitive from) {
    return isPicked(from) ? from.indices().length : from.vertices();
  }

  /** Returns whether indices pick points, for which X3D has no indices. */
  private static boolean isPicked(GltfPrimitive from) {
    return from.mode() == PrimitiveIndices.POINTS && from.json().has("indices");
  }

  private void texCoord(float[] uv, String mapping) {
    for (int i = 1; i < uv.length; i += 2) {
      uv[i] = 1 - uv[i]; // glTF's v goes down, X3D's t goes up
    }
    out.open("TextureCoordinate");
    if (!mapping.isEmpty()) {
      out.attribute("mapping", mapping);
      out.attribute("containerField", "texCoord");
    }
    out.ownLine().numbers("point", Numbers.list(uv)).close();
  }

  /** Returns vertex colours, which glTF multiplies by the material's and X3D takes instead. */
  private float[] colors(GltfPrimitive from) throws IOException {
    JsonNode attributes = from.json().path("attributes");
    int components =
        from.accessors().components(GltfFile.index(attributes, "COLOR_0")) == 4 ? 4 : 3;
    int index = from.attribute("COLOR_0", components);
    if (index < 0) {
      return new float[0];
    }
    float[] colors = from.accessors().floats(index);
    double[] base = materials.material(from.material()).baseColor();
    boolean unlit = !from.faces() || materials.material(from.material()).isUnlit();
    int size = components == 4 || base[3] < 1 ? 4 : 3;
    float[] mixed = new float[from.vertices() * size];
    for (int v = 0; v < from.vertices(); v++) {
      double[] color = {1, 1, 1, 1};
      for (int k = 0; k < 4; k++) {
        double own = k < components ? colors[v * components + k] : 1;
        color[k] = Numbers.unit(own * base[k]);
      }
      double[] shown = unlit ? GltfMaterials.srgb(color) : color;
      for (int k = 0; k < size; k++) {
        mixed[v * size + k] = (float) (k < 3 ? shown[k] : color[3]);
      }
    }
    return isPicked(from) ? picked(mixed, from.indices(), size) : mixed;
  }

  private static float[] picked(float[] values, int[] indices, int size) {
    float[] picked = new float[Math.multiplyExact(indices.length, size)];
    for (int i = 0; i < indices.length; i++) {
      System.arraycopy(values, indices[i] * size, picked, i * size, size);
    }
    return picked;
  }
}
