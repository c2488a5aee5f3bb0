package org.selectiverenderer.enricher.images;

import java.awt.image.BufferedImage;

/**
 * A picture of a ball of a material, lit by a lamp from the upper left and a little from all
 * around, before a chequered ground where it is transparent. A quick picture for choosing colours;
 * what the scene looks like is told by the preview.
 */
public final class MaterialBall {
  private static final double[] LIGHT = unit(-0.5, 0.7, 0.75);
  private static final double[] HALF = unit(LIGHT[0], LIGHT[1], LIGHT[2] + 1);
  private static final int CHECK = 8;

  private MaterialBall() {}

  /**
   * The values of a material, colours from 0 to 1.
   *
   * @param base diffuse colour
   * @param specular colour of highlights
   * @param emissive colour without light
   * @param ambient share of the diffuse colour in the shade
   * @param exponent of the highlight (X3D 4.0, 17.2.2.4: 128 times the shininess)
   * @param transparency from 0 to 1
   */
  public record Look(
      float[] base,
      float[] specular,
      float[] emissive,
      double ambient,
      double exponent,
      double transparency) {}

  /** Draws a ball, with a margin of transparent pixels around. */
  public static BufferedImage picture(Look look, int side) {
    BufferedImage picture = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
    double radius = side / 2.0 - 1;
    for (int y = 0; y < side; y++) {
      for (int x = 0; x < side; x++) {
        double u = (x + 0.5 - side / 2.0) / radius;
        double v = (side / 2.0 - y - 0.5) / radius;
        double square = u * u + v * v;
        double edge = Math.min(1, (1 - Math.sqrt(square)) * radius + 0.5);
        if (edge > 0) {
          double z = Math.sqrt(Math.max(0, 1 - square));
          boolean light = (x / CHECK + y / CHECK) % 2 == 0;
          picture.setRGB(x, y, pixel(look, u, v, z, light ? 0.85 : 0.55, edge));
        }
      }
    }
    return picture;
  }

  private static int pixel(Look look, double u, double v, double z, double ground, double edge) {
    double lit = Math.max(0, u * LIGHT[0] + v * LIGHT[1] + z * LIGHT[2]);
    double shine =
        lit == 0
            ? 0
            : Math.pow(Math.max(0, u * HALF[0] + v * HALF[1] + z * HALF[2]), look.exponent());
    int argb = (int) Math.round(255 * edge) << 24;
    for (int i = 0; i < 3; i++) {
      double colour =
          look.emissive()[i] + look.base()[i] * (look.ambient() + lit) + look.specular()[i] * shine;
      double seen = Math.min(1, colour) * (1 - look.transparency()) + ground * look.transparency();
      argb |= (int) Math.round(255 * Math.max(0, Math.min(1, seen))) << (8 * (2 - i));
    }
    return argb;
  }

  private static double[] unit(double x, double y, double z) {
    double length = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / length, y / length, z / length};
  }
}
