package org.selectiverenderer.tracker.report;

import java.io.IOException;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.tracker.PoseSample;

/** Writes JSON Lines: an object for each record, and one with the statistics at the end. */
public final class JsonTrackOutput implements TrackOutput {
  private final Appendable out;
  private final Flushing flushing;

  /** Flushes written lines to their reader. */
  public interface Flushing {
    void flush() throws IOException;
  }

  public JsonTrackOutput(Appendable out, Flushing flushing) {
    this.out = out;
    this.flushing = flushing;
  }

  @Override
  public void sample(double time, PoseSample sample) throws IOException {
    out.append("{\"t\":")
        .append(number(time, 6))
        .append(",\"yaw\":")
        .append(number(sample.yaw(), 4))
        .append(",\"pitch\":")
        .append(number(sample.pitch(), 4))
        .append(",\"roll\":")
        .append(number(sample.roll(), 4));
    if (sample.placed()) {
      out.append(",\"right\":")
          .append(number(sample.x(), 5))
          .append(",\"up\":")
          .append(number(sample.y(), 5))
          .append(",\"back\":")
          .append(number(sample.z(), 5));
    }
    out.append("}\n");
  }

  @Override
  public void flush() throws IOException {
    flushing.flush();
  }

  @Override
  public void end(TrackStatistics figures) throws IOException {
    out.append("{\"records\":")
        .append(Long.toString(figures.records()))
        .append(",\"rate_hz\":")
        .append(number(figures.rateHz(), 2))
        .append(",\"jitter_ms\":")
        .append(number(figures.jitterMs(), 3))
        .append(",\"bad\":")
        .append(Long.toString(figures.bad()))
        .append(",\"dropped\":")
        .append(Long.toString(figures.dropped()))
        .append(",\"age_ms\":{\"p50\":")
        .append(number(figures.ageMedianMs(), 2))
        .append(",\"p99\":")
        .append(number(figures.ageP99Ms(), 2))
        .append("}}\n");
    flushing.flush();
  }

  /** Formats a number as JSON libraries do: {@code 12.5}, {@code 0.0}. */
  private static String number(double value, int decimals) {
    return Double.toString(Double.parseDouble(DecimalFormatter.fixed(value, decimals)));
  }
}
