package org.selectiverenderer.tracker.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
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
    writer.write("t,yaw,pitch,roll\n");
  }

  @Override
  public void sample(double time, PoseSample sample) throws IOException {
    writer
        .append(Decimals.of(time, 6))
        .append(',')
        .append(Decimals.of(sample.yaw(), 4))
        .append(',')
        .append(Decimals.of(sample.pitch(), 4))
        .append(',')
        .append(Decimals.of(sample.roll(), 4))
        .append('\n');
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
