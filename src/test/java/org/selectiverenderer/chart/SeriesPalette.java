package org.selectiverenderer.chart;

import java.util.List;

/** The colours of a plot's series, in the order of the series. */
final class SeriesPalette {
  private static final List<ChartColour> ORDER =
      List.of(
          ChartColour.BLUE,
          ChartColour.ORANGE,
          ChartColour.GREEN,
          ChartColour.VERMILION,
          ChartColour.SKY,
          ChartColour.PURPLE,
          ChartColour.GREY);

  private SeriesPalette() {}

  /** How many series of one plot can be told apart. */
  static int limit() {
    return ORDER.size();
  }

  /**
   * The colour of a series.
   *
   * @param index from 0, below {@link #limit()}
   */
  static ChartColour of(int index) {
    return ORDER.get(index);
  }

  /** What text on a series's colour is read best in: at least 4 to 1 for each. */
  static ChartColour lettering(int index) {
    return of(index) == ChartColour.BLUE ? ChartColour.PAPER : ChartColour.INK;
  }
}
