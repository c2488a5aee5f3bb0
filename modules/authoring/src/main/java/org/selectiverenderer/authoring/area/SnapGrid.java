package org.selectiverenderer.authoring.area;

/**
 * A grid to which lengths and positions are snapped.
 *
 * @param step the grid spacing in the scene's unit; 0 for no grid
 */
public record SnapGrid(double step) {
  /** No grid. */
  public static final SnapGrid NONE = new SnapGrid(0);

  /** Returns the nearest position on the grid. */
  public double nearest(double place) {
    return step > 0 ? Math.rint(place / step) * step : place;
  }
}
