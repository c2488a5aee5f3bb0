package org.selectiverenderer.apartment.lounge;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoublePredicate;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.LoftedSurface;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ModelPlacement;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/**
 * A basketball; nobody expects it in a lounge. Its seams are narrow rows and columns of the ball
 * itself: the equator and a circle at 45 degrees on both sides, and one circle through the poles.
 */
final class Basketball {
  private static final double RADIUS = 0.12;

  /** Half the width of a seam, degrees. */
  private static final double SEAM = 1.3;

  private Basketball() {}

  static ParametricModel model() {
    List<Vector3d[]> rows = new ArrayList<>();
    for (double latitude : angles(-90, 180, 12, a -> a == 0 || Math.abs(a) == 45)) {
      rows.add(row(latitude));
    }
    TriangleMesh ball = LoftedSurface.over(rows, LoftedSurface.Form.PIPE);
    ModelMaterial leather = ModelMaterial.satin(ModelColour.of(0.74, 0.36, 0.13));
    return ModelPlacement.centred(
        ParametricModel.of(
                "basketball",
                Part.of("leather", leather, SurfacePartition.where(ball, p -> !isSeam(p)))
                    .crease(60),
                Part.of(
                        "seams",
                        Materials.BLACK_PLASTIC,
                        SurfacePartition.where(ball, Basketball::isSeam))
                    .crease(60))
            .map(mesh -> mesh.turnZ(62).turnY(35)));
  }

  private static Vector3d[] row(double latitude) {
    double r = RADIUS * DegreeMath.cos(latitude);
    return angles(0, 345, 23, a -> a % 180 == 0).stream()
        .map(
            a ->
                new Vector3d(
                    r * DegreeMath.cos(a),
                    RADIUS * DegreeMath.sin(latitude),
                    -r * DegreeMath.sin(a)))
        .toArray(Vector3d[]::new);
  }

  /** Returns angles in equal steps; an angle on a seam is replaced by the two sides of the seam. */
  private static List<Double> angles(double from, double range, int steps, DoublePredicate seam) {
    List<Double> all = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double angle = from + range * i / steps;
      if (seam.test(angle)) {
        all.add(angle - SEAM);
        all.add(angle + SEAM);
      } else {
        all.add(angle);
      }
    }
    return all;
  }

  private static boolean isSeam(Vector3d p) {
    double latitude = DegreeMath.atan2(p.y, Math.sqrt(p.x * p.x + p.z * p.z));
    double fromCircle = Math.abs(DegreeMath.atan2(p.z, Math.abs(p.x)));
    double high = Math.abs(latitude);
    return high < SEAM || Math.abs(high - 45) < SEAM || fromCircle < SEAM;
  }
}
