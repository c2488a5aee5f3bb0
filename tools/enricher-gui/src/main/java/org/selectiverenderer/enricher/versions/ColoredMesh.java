package org.selectiverenderer.enricher.versions;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelPart;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The mesh of a version with one plain colour per triangle, for drawing it from all sides.
 * Immutable by convention.
 *
 * @param corners x, y, z of three corners per triangle, in the object's coordinates
 * @param colors 0xRRGGBB per triangle: the diffuse colours, without textures
 */
record ColoredMesh(float[] corners, int[] colors) {
  private static final int GREY = 0xCCCCCC; // the default diffuseColor of Material, 0.8

  static ColoredMesh of(Model model) {
    int count = model.polygons();
    float[] corners = new float[9 * count];
    int[] colors = new int[count];
    int triangle = 0;
    for (ModelPart part : model.parts()) {
      Mesh mesh = part.mesh();
      int plain = diffuse(part.appearance());
      for (int t = 0; t < mesh.polygons(); t++, triangle++) {
        for (int c = 0; c < 3; c++) {
          int vertex = mesh.indices()[3 * t + c];
          System.arraycopy(mesh.positions(), 3 * vertex, corners, 9 * triangle + 3 * c, 3);
        }
        float[] own = mesh.colors();
        colors[triangle] = own == null ? plain : rgb(own, 4 * mesh.indices()[3 * t]);
      }
    }
    return new ColoredMesh(corners, colors);
  }

  private static int diffuse(@Nullable NodeView appearance) {
    NodeView material = appearance == null ? null : appearance.node("material");
    if (material == null || material.type().field("diffuseColor").isEmpty()) {
      return GREY;
    }
    return rgb(material.floats("diffuseColor"), 0);
  }

  private static int rgb(float[] values, int at) {
    int rgb = 0;
    for (int i = 0; i < 3; i++) {
      rgb = rgb << 8 | Math.round(255 * Math.max(0, Math.min(1, values[at + i])));
    }
    return rgb;
  }

  int polygons() {
    return colors.length;
  }

  /** The bounding sphere, by which all versions are drawn to one scale. */
  BoundingSphere frame() {
    return BoundingSphere.around(corners);
  }
}
