package org.selectiverenderer.document.area;

/**
 * A grid that lengths and places keep to.
 *
 * @param step between its lines in the scene's unit; 0 for none
 */
public record GridStep(double step) {
  /** No grid. */
  public static final GridStep NONE = new GridStep(0);

  /** The place on the grid that is nearest. */
  public double nearest(double place) {
    return step > 0 ? Math.rint(place / step) * step : place;
  }
}
