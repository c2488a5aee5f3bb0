package org.selectiverenderer.apartment.lounge;

import java.util.function.Predicate;
import org.joml.Vector3d;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;

/**
 * A magazine that lies open, 0.42 m by 0.28 m: wavy pages with a picture of a room on the left, a
 * title, text and a picture on the right, where the leaf lifts a little.
 *
 * <p>Each sheet is drawn flat, cut by what is printed on it, and then bent.
 */
final class Magazine {
  private static final double PAGE = 0.208;
  private static final double HALF = 0.14;
  private static final double COVER = 0.0016;

  /** Number of rows of the sheets, two millimetres each; the print follows them. */
  private static final int ROWS = 140;

  private Magazine() {}

  static ParametricModel model() {
    TriangleMesh pages = ParametricSurface.field(2 * PAGE, 2 * HALF, 160, ROWS, (x, z) -> 0);
    TriangleMesh leaf =
        ParametricSurface.field(PAGE, 2 * HALF, 50, ROWS, (x, z) -> 0).move(PAGE / 2, 0, 0);
    ModelMaterial red = ModelMaterial.satin(ModelColour.of(0.68, 0.16, 0.12));
    ModelMaterial ink = ModelMaterial.satin(ModelColour.of(0.4, 0.4, 0.4));
    ModelMaterial wall = ModelMaterial.satin(ModelColour.of(0.72, 0.79, 0.77));
    ModelMaterial floor = ModelMaterial.satin(ModelColour.of(0.6, 0.44, 0.3));
    ModelMaterial sofa = ModelMaterial.satin(ModelColour.of(0.2, 0.36, 0.42));
    ModelMaterial lamp = ModelMaterial.satin(ModelColour.of(0.93, 0.76, 0.36));
    ModelMaterial paper = ModelMaterial.satin(ModelColour.of(0.93, 0.92, 0.88));
    return ModelPlacement.centred(
        ParametricModel.of(
            "magazine",
            Part.of("cover", red, BoxBuilder.plain(2 * PAGE + 0.004, COVER, 2 * HALF + 0.003)),
            page("paper", paper, pages, p -> !MagazinePrint.isPicture(p)),
            page("wall", wall, pages, MagazinePrint::isWall),
            page("floor", floor, pages, MagazinePrint::isFloor),
            page("sofa", sofa, pages, MagazinePrint::isSofa),
            page("lamp", lamp, pages, MagazinePrint::isLamp),
            Part.of("edges", paper, edges(pages)),
            leaf("leaf", paper, leaf, p -> !MagazinePrint.isType(p)),
            leaf("title", red, leaf, MagazinePrint::isTitle),
            leaf("text", ink, leaf, MagazinePrint::isText),
            leaf("photograph", sofa, leaf, MagazinePrint::isPhotograph)));
  }

  private static Part page(
      String name, ModelMaterial look, TriangleMesh flat, Predicate<Vector3d> where) {
    TriangleMesh mesh =
        SurfacePartition.where(flat, where).deform(p -> p.set(p.x, height(p.x, p.z), p.z));
    return Part.of(name, look, mesh).crease(60);
  }

  private static Part leaf(
      String name, ModelMaterial look, TriangleMesh flat, Predicate<Vector3d> where) {
    return Part.of(name, look, SurfacePartition.where(flat, where).deform(Magazine::lift))
        .crease(60);
  }

  /** Returns the height of the pages, which sink into the fold and wave towards the corners. */
  private static double height(double x, double z) {
    double out = Math.abs(x) / PAGE;
    double bulge = 0.0115 * out * 1.15 / (out + 0.15) - 0.0055 * out * out;
    double wave = 0.0013 * out * DegreeMath.sin(900 * z + 500 * x + 40);
    return COVER + 0.003 + bulge + wave;
  }

  /** Bends the flat leaf so that it rises from the fold and returns down to the page. */
  private static Vector3d lift(Vector3d p) {
    double along = Math.max(0, p.x / PAGE);
    double corner = 0.5 + p.z / (2 * HALF);
    double rise = (0.012 + 0.026 * corner) * DegreeMath.sin(180 * DegreeMath.power(along, 0.8));
    double curl = 0.016 * corner * corner * along * along * along;
    double x = p.x - 0.012 * along * corner;
    double y = height(p.x, p.z) + 0.001 + rise + curl;
    return p.set(x, y, p.z);
  }

  /**
   * Returns the cut edges of the pages, from the border of the uppermost page down to the cover.
   */
  private static TriangleMesh edges(TriangleMesh pages) {
    TriangleMesh walls = ParametricSurface.thicken(pages, 0, -1, 0);
    return SurfacePartition.where(walls, p -> Math.abs(p.y + 0.5) < 0.4)
        .deform(p -> p.set(p.x, p.y < -0.5 ? COVER : height(p.x, p.z), p.z));
  }
}
