package org.selectiverenderer.models;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ImportedModel.ImportedMesh;
import org.selectiverenderer.models.scene.Numbers;
import org.selectiverenderer.x3d.write.X3dWriter;

/** Writes meshes that are clouds of points, which no light shades, as PointSets. */
final class ImportedPointWriter {
  private static final float[] WHITE = {1, 1, 1};

  private final ImportedModel model;
  private final X3dWriter out;

  ImportedPointWriter(ImportedModel model, X3dWriter out) {
    this.model = model;
    this.out = out;
  }

  /** Returns whether a mesh consists of points only. */
  static boolean isPoints(ImportedMesh mesh) {
    return mesh.triangles().length == 0 && mesh.positions().length > 0;
  }

  /** Writes what a Shape has; a point at no finite place is at the origin. */
  void write(ImportedMesh mesh) {
    float[] diffuse = model.materials().get(mesh.material()).diffuse();
    out.open("Appearance").open("UnlitMaterial");
    out.attribute("emissiveColor", Numbers.of(color(diffuse))).close().close();
    out.open("PointSet").open("Coordinate").ownLine();
    out.numbers("point", Numbers.list(ImportedModelConverter.clean(mesh.positions()))).close();
    if (mesh.colors() != null) {
      out.open("ColorRGBA").ownLine();
      float[] colors = mesh.colors().clone();
      for (int i = 0; i < colors.length; i++) {
        colors[i] = (float) Numbers.unit(colors[i]);
      }
      out.numbers("color", Numbers.list(colors)).close();
    }
    out.close();
  }

  private static double[] color(float @Nullable [] diffuse) {
    float[] given = diffuse == null ? WHITE : diffuse;
    return new double[] {Numbers.unit(given[0]), Numbers.unit(given[1]), Numbers.unit(given[2])};
  }
}
