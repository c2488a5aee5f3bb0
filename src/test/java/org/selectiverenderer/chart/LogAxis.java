package org.selectiverenderer.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;

/** A logarithmic axis from one power of ten to another, over a length in pixels. */
final class LogAxis {
  private final int low;
  private final int high;
  private final double length;

  /** Covers the values, which are above 0, and at least one power of ten. */
  LogAxis(DoubleStream values, double length) {
    this.length = length;
    double[] logs = values.map(Math::log10).toArray();
    low = (int) Math.floor(DoubleStream.of(logs).min().orElse(0) + 1e-9);
    high = Math.max(low + 1, (int) Math.ceil(DoubleStream.of(logs).max().orElse(0) - 1e-9));
  }

  /** Pixels from the low end. */
  double at(double value) {
    return (Math.log10(value) - low) / (high - low) * length;
  }

  /** The powers of ten, and between few of them 2 and 5 too. */
  List<Double> marks() {
    List<Double> marks = new ArrayList<>();
    for (int power = low; power < high; power++) {
      marks.add(Math.pow(10, power));
      if (high - low <= 2) {
        marks.add(2 * Math.pow(10, power));
        marks.add(5 * Math.pow(10, power));
      }
    }
    marks.add(Math.pow(10, high));
    return marks;
  }

  double lowest() {
    return Math.pow(10, low);
  }

  double highest() {
    return Math.pow(10, high);
  }
}
