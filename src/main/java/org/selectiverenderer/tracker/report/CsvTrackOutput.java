package org.selectiverenderer.tracker.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.selectiverenderer.base.csv.CsvText;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;

/**
 * A CSV file that {@code replay:} reads: t (seconds since the tracker was opened), yaw, pitch, roll
 * (degrees). Written out several times per second, so that a crash loses little.
 */
public final class CsvTrackOutput implements TrackOutput, AutoCloseable {
  private final BufferedWriter writer;

  /**
   * @throws IOException if the file cannot be made
   */
  public CsvTrackOutput(Path file) throws IOException {
    writer = Files.newBufferedWriter(file, StandardCharsets.UTF_8);
    writer.write(CsvText.line("t", "yaw", "pitch", "roll"));
  }

  @Override
  public void sample(double time, PoseSample sample) throws IOException {
    writer.write(
        CsvText.line(
            DecimalText.fixed(time, 6),
            DecimalText.fixed(sample.yaw(), 4),
            DecimalText.fixed(sample.pitch(), 4),
            DecimalText.fixed(sample.roll(), 4)));
  }

  @Override
  public void status(double time, PoseSample newest, TrackerHealth health) throws IOException {
    writer.flush();
  }

  @Override
  public void close() throws IOException {
    writer.close();
  }
}
