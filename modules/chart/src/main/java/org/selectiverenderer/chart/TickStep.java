package org.selectiverenderer.chart;

/** Chooses the distance between the ticks of an axis. */
public final class TickStep {
  private TickStep() {}

  /** Returns 1, 2 or 5 times a power of ten, so that four to ten ticks divide a length above 0. */
  public static double of(double length) {
    double power = Math.pow(10, Math.floor(Math.log10(length / 4)));
    double ratio = length / 4 / power;
    return power * (ratio >= 5 ? 5 : ratio >= 2 ? 2 : 1);
  }
}
