package org.selectiverenderer.tracker.report;

import java.io.IOException;
import java.util.Locale;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.tracker.report.JsonTrackOutput.Flushing;

/**
 * Writes status lines for people a few times per second: the pose and statistics of the records.
 */
public final class TextTrackOutput implements TrackOutput {
  private final Appendable out;
  private final Flushing flushing;

  public TextTrackOutput(Appendable out, Flushing flushing) {
    this.out = out;
    this.flushing = flushing;
  }

  @Override
  public void status(double time, PoseSample newest, TrackerHealth health) throws IOException {
    out.append(String.format(Locale.ROOT, "%8.2f s  ", time));
    if (newest.number() == 0) {
      out.append("no record yet");
    } else {
      out.append(
          String.format(
              Locale.ROOT,
              "yaw %7.2f  pitch %7.2f  roll %7.2f   %6.1f Hz  jitter %5.2f ms",
              newest.yaw(),
              newest.pitch(),
              newest.roll(),
              health.rateHz(),
              health.jitterMs()));
      if (newest.placed()) {
        out.append(
            String.format(
                Locale.ROOT,
                "  right %6.3f  up %6.3f  back %6.3f m",
                newest.x(),
                newest.y(),
                newest.z()));
      }
    }
    out.append("  bad ").append(Long.toString(health.bad()));
    out.append("  dropped ").append(Long.toString(health.dropped()));
    if (health.stale()) {
      out.append(String.format(Locale.ROOT, "  silent for %.1f s", health.silentSeconds()));
    }
    out.append('\n');
    flushing.flush();
  }

  @Override
  public void end(TrackStatistics figures) throws IOException {
    out.append(
        String.format(
            Locale.ROOT,
            "%d records, %.1f per second, jitter %.2f ms, %d bad, %d dropped%n",
            figures.records(),
            figures.rateHz(),
            figures.jitterMs(),
            figures.bad(),
            figures.dropped()));
    if (figures.records() > 0) {
      out.append(
          String.format(
              Locale.ROOT,
              "age of a record when a display draws it, %d times per second: median %.1f ms, 99 %%"
                  + " up to %.1f ms%n",
              TrackSession.FRAME_RATE,
              figures.ageMedianMs(),
              figures.ageP99Ms()));
    }
    flushing.flush();
  }
}
