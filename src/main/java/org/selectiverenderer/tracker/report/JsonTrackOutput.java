package org.selectiverenderer.tracker.report;

import java.io.IOException;
import org.selectiverenderer.tracker.PoseSample;

/** One JSON object per record and line, and one with the figures at the end. */
public final class JsonTrackOutput implements TrackOutput {
  private final Appendable out;
  private final Flushing flushing;

  /** What makes written lines visible to a waiting reader. */
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
        .append(Decimals.of(time, 6))
        .append(",\"yaw\":")
        .append(Decimals.of(sample.yaw(), 4))
        .append(",\"pitch\":")
        .append(Decimals.of(sample.pitch(), 4))
        .append(",\"roll\":")
        .append(Decimals.of(sample.roll(), 4))
        .append("}\n");
  }

  @Override
  public void flush() throws IOException {
    flushing.flush();
  }

  @Override
  public void end(TrackFigures figures) throws IOException {
    out.append("{\"records\":")
        .append(Long.toString(figures.records()))
        .append(",\"rate_hz\":")
        .append(Decimals.of(figures.rateHz(), 2))
        .append(",\"jitter_ms\":")
        .append(Decimals.of(figures.jitterMs(), 3))
        .append(",\"bad\":")
        .append(Long.toString(figures.bad()))
        .append(",\"dropped\":")
        .append(Long.toString(figures.dropped()))
        .append(",\"age_ms\":{\"p50\":")
        .append(Decimals.of(figures.ageMedianMs(), 2))
        .append(",\"p99\":")
        .append(Decimals.of(figures.ageP99Ms(), 2))
        .append("}}\n");
    flushing.flush();
  }
}
