package org.selectiverenderer.apartment.textures;

import org.jspecify.annotations.Nullable;

/**
 * A tree in the landscape: a trunk, and tufts of leaves around a crown, lit from above and one
 * side.
 */
final class Tree implements LandscapeBillboard {
  private static final int TUFTS = 34;

  /** Height at which the crown begins, as a share of the tree's height. */
  private static final double CROWN_FOOT = 0.22;

  private final PerlinNoise noise = new PerlinNoise(6);
  private final int number;
  private final double turn;
  private final double distance;
  private final double tall;
  private final double breadth;
  private final double hue;
  private final double side;

  // Per tuft: x and y of its middle, its nearness to the viewer and its radius, metres.
  private final double[] right = new double[TUFTS];
  private final double[] up = new double[TUFTS];
  private final double[] near = new double[TUFTS];
  private final double[] radius = new double[TUFTS];

  /**
   * @param number number of the tree, used as its random seed
   * @param turn direction in which it stands, in turns from north over east
   * @param distance distance from the flat, metres
   * @param tall height, metres
   * @param slim ratio of the crown's breadth to the tree's height
   * @param hue 0 blue green to 1 yellow green
   * @param side side from which light comes as seen from the flat, -1 left to 1 right
   */
  Tree(
      int number, double turn, double distance, double tall, double slim, double hue, double side) {
    this.number = number;
    this.turn = turn;
    this.distance = distance;
    this.tall = tall;
    this.breadth = 0.8 * slim * tall;
    this.hue = hue;
    this.side = side;
    grow();
  }

  /**
   * Places tufts on a spiral from the crown's foot to its top; the crown is widest below its
   * middle.
   */
  private void grow() {
    for (int i = 0; i < TUFTS; i++) {
      double level = (i + 0.5) / TUFTS;
      double around = i * 0.382 + noise.dice(number, 200);
      around -= Math.floor(around);
      double wide = 1.75 * level - 0.78;
      double shell = 0.5 * breadth * Math.sqrt(Math.max(0, 1 - wide * wide));
      shell *= 0.75 + 0.5 * noise.dice(number, 300 + i);
      right[i] = (around < 0.5 ? 4 * around - 1 : 3 - 4 * around) * 0.75 * shell;
      near[i] = (around < 0.5 ? 0.5 : -0.5) * shell;
      up[i] = tall * (CROWN_FOOT + 0.7 * level);
      radius[i] = (0.1 + 0.13 * noise.dice(number, i)) * breadth * (1.12 - 0.4 * level);
    }
  }

  @Override
  public double turn() {
    return turn;
  }

  @Override
  public double distance() {
    return distance;
  }

  @Override
  public double reach() {
    return 0.75 * breadth;
  }

  @Override
  public double top() {
    return 1.08 * tall;
  }

  @Override
  public double @Nullable [] colour(double x, double y) {
    double nearest = Double.NEGATIVE_INFINITY;
    double light = 0;
    // Noise makes twigs reach out of a tuft and leave holes in it.
    double twigs = 0.55 * noise.layers(3, 1.4 * x + 40 * number, 1.4 * y);
    for (int i = 0; i < TUFTS; i++) {
      double u = (x - right[i]) / radius[i];
      double v = (y - up[i]) / radius[i];
      double inside = 1 - u * u - v * v + twigs;
      if (inside > 0) {
        double outward = Math.sqrt(Math.min(1, inside));
        double at = near[i] + radius[i] * outward;
        if (at > nearest) {
          nearest = at;
          double level = (double) i / TUFTS;
          light = 0.3 * side * u + 0.4 * v + 0.2 * outward + 0.8 * (level - 0.5);
          light += 0.35 * side * x / breadth;
        }
      }
    }
    if (nearest > Double.NEGATIVE_INFINITY) {
      double leaves = noise.layers(3, 3 * x + 90 * number, 3 * y);
      return leaf(0.4 + 0.4 * light + 0.3 * leaves);
    }
    boolean trunk = y < 0.5 * tall && Math.abs(x) < 0.022 * tall * (1.3 - y / tall);
    return trunk ? new double[] {0.3, 0.25, 0.2} : null;
  }

  private double[] leaf(double light) {
    double l = Math.max(0, Math.min(1, light));
    return new double[] {
      PerlinNoise.mix(0.2, 0.52 + 0.14 * hue, l),
      PerlinNoise.mix(0.26, 0.64 + 0.04 * hue, l),
      PerlinNoise.mix(0.17, 0.4 - 0.06 * hue, l)
    };
  }
}
