package org.selectiverenderer.apartment.textures;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The landscape seen from the flat, which is one storey up: a garden with trees, houses behind it,
 * woods and three ranges of hills in the haze, clouds. Directions go from -z, north, over +x, east.
 */
final class Landscape {
  /** Height of the eye above the ground, metres. */
  private static final double EYE = 5.2;

  /** Distance at which two thirds of the colour are haze, metres. */
  private static final double CLEAR = 420;

  private static final double[] HAZE = {0.8, 0.87, 0.92};
  private static final double[] CLOUD = {0.97, 0.98, 0.99};

  /** Direction of the sunlight, in turns: the south-west. */
  private static final double SUN = 0.63;

  /** Distance of the nearest trees, metres. */
  private static final double NEAR = 32;

  private static final double FAR = 150;

  private final PerlinNoise noise = new PerlinNoise(7);
  private final List<LandscapeBillboard> standers = new ArrayList<>();

  /** Shadows on the ground: x, z and radius for each tree and house, metres. */
  private final double[] shadows;

  Landscape() {
    for (int i = 0; i < 11; i++) {
      standers.add(
          new House(
              (i + 0.7 * noise.dice(i, 1)) / 11,
              75 + 60 * noise.dice(i, 2),
              10 + 6 * noise.dice(i, 3),
              noise.dice(i, 4)));
    }
    for (int i = 0; i < 170; i++) {
      double turn = (i * 0.618 + 0.1 * noise.dice(i, 5)) % 1;
      double far = noise.dice(i, 6);
      double distance = NEAR + (FAR - NEAR) * Math.sqrt(far) * (i % 6 == 0 ? 0.12 : 1);
      double tall = 6 + 7 * noise.dice(i, 7);
      double slim = i % 9 == 4 ? 0.32 : 0.8 + 0.35 * noise.dice(i, 8);
      double side = -Math.signum(StrictMath.sin(2 * Math.PI * (turn - SUN)));
      standers.add(new Tree(i, turn, distance, tall, slim, noise.dice(i, 9), 0.8 * side));
    }
    standers.sort(Comparator.comparingDouble(LandscapeBillboard::distance));
    shadows = new double[3 * standers.size()];
    for (int i = 0; i < standers.size(); i++) {
      LandscapeBillboard stander = standers.get(i);
      double angle = 2 * Math.PI * stander.turn();
      shadows[3 * i] = stander.distance() * StrictMath.sin(angle);
      shadows[3 * i + 1] = -stander.distance() * StrictMath.cos(angle);
      shadows[3 * i + 2] = stander.reach();
    }
  }

  /**
   * Returns the display colour r, g, b in a direction, and the alpha with which it covers the sky.
   *
   * @param x to the east
   * @param y up
   * @param z to the south; not both x and z are 0
   */
  double[] colour(double x, double y, double z) {
    double level = Math.sqrt(x * x + z * z);
    double turn = StrictMath.atan2(x, -z) / (2 * Math.PI);
    turn -= Math.floor(turn);
    double slope = y / level;
    for (LandscapeBillboard stander : standers) {
      double[] seen = seen(stander, turn, slope);
      if (seen != null) {
        return hazy(seen, stander.distance());
      }
    }
    double[] hill = hill(turn, slope);
    if (hill != null) {
      return hill;
    }
    return slope < 0 ? ground(-EYE * x / y, -EYE * z / y) : cloud(x, y, z);
  }

  private static double @Nullable [] seen(LandscapeBillboard stander, double turn, double slope) {
    double up = slope * stander.distance() + EYE;
    if (up < 0 || up > stander.top()) {
      return null;
    }
    double aside = turn - stander.turn();
    aside -= Math.rint(aside);
    double right = aside * 2 * Math.PI * stander.distance();
    return Math.abs(right) > stander.reach() ? null : stander.colour(right, up);
  }

  /**
   * Returns the colour of the woods and three ranges of hills, each behind and above the one
   * before; null above them.
   */
  private double @Nullable [] hill(double turn, double slope) {
    double crowns = 0.004 * noise.layers(3, 150 * turn, 0, 150, 8);
    double woods = 0.004 + 0.012 * noise.layers(3, 12 * turn, 20, 12, 64) + crowns;
    if (slope > -0.03 && slope < woods) {
      double leaves = noise.layers(3, 400 * turn, 400 / (2 * Math.PI) * slope, 400, 1 << 20);
      double light = 0.1 * leaves + 3 * (slope - woods);
      return hazy(new double[] {0.3 + light, 0.42 + light, 0.24 + light}, 190);
    }
    for (int range = 0; range < 3; range++) {
      double high = 0.022 + 0.026 * range;
      double rough = noise.layers(5, 7 * turn, 40 + 3 * range, 7, 64);
      if (slope > 0 && slope < high + 0.024 * rough) {
        double folds = 0.06 * noise.layers(3, 40 * turn, 30 * slope + 9 * range, 40, 1 << 20);
        return hazy(new double[] {0.36 + folds, 0.47 + folds, 0.38 + folds}, 330 + 260 * range);
      }
    }
    return null;
  }

  /**
   * Returns the colour of the ground, lawn near by and meadows behind; x to the east, z to the
   * south, metres.
   */
  private double[] ground(double x, double z) {
    double distance = Math.sqrt(x * x + z * z);
    double patches = noise.layers(4, x / 11, z / 11);
    double blades = distance < 60 ? noise.layers(2, 2.2 * x, 2.2 * z) : 0;
    double fields =
        PerlinNoise.step(-0.1, 0.1, noise.at(x / 70 + 5, z / 70))
            * PerlinNoise.step(50, 90, distance);
    double worn = 0.08 * PerlinNoise.step(0.1, 0.7, noise.layers(3, x / 6 + 9, z / 6));
    double light = 0.06 * patches + 0.045 * blades;
    double shade = 1 - 0.42 * shadow(x, z);
    double[] colour = {
      shade * (0.45 + worn + 0.18 * fields + light),
      shade * (0.55 + worn / 2 + 0.06 * fields + light),
      shade * (0.33 + worn / 2 + 0.02 * fields + light / 2)
    };
    return hazy(colour, distance);
  }

  /** Returns the darkness of the shadows under trees, 0 to 1. */
  private double shadow(double x, double z) {
    double dark = 0;
    for (int i = 0; i < shadows.length; i += 3) {
      double dx = x - shadows[i];
      double dz = z - shadows[i + 1];
      double square = dx * dx + dz * dz;
      double reach = shadows[i + 2];
      if (square < 1.3 * reach * reach) {
        dark = Math.max(dark, 1 - PerlinNoise.step(0.4, 1.1, Math.sqrt(square) / reach));
      }
    }
    return dark;
  }

  /**
   * Returns the colour and alpha of cumulus clouds on a flat layer high above, thinner towards the
   * horizon.
   */
  private double[] cloud(double x, double y, double z) {
    double u = x / (y + 0.16);
    double v = z / (y + 0.16);
    double heap = noise.layers(5, 0.9 * u + 3, 0.9 * v);
    double cover = PerlinNoise.step(-0.05, 0.75, heap) * PerlinNoise.step(0.02, 0.2, y);
    double shade = 0.07 * PerlinNoise.step(0.2, 0.9, heap);
    return new double[] {CLOUD[0] - shade, CLOUD[1] - shade, CLOUD[2] - shade / 2, 0.85 * cover};
  }

  private static double[] hazy(double[] colour, double distance) {
    double haze = 1 - StrictMath.exp(-distance / CLEAR);
    return new double[] {
      PerlinNoise.mix(colour[0], HAZE[0], haze),
      PerlinNoise.mix(colour[1], HAZE[1], haze),
      PerlinNoise.mix(colour[2], HAZE[2], haze),
      1
    };
  }
}
