package org.selectiverenderer.tracker.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;

/**
 * Writes a CSV file that {@code replay:} reads: t (seconds since the tracker was opened), yaw,
 * pitch, roll (degrees), and, for a tracker that measures positions, right, up, back (metres),
 * empty in records without a position. Flushed several times per second, so that a crash loses
 * little.
 */
public final class CsvTrackOutput implements TrackOutput, AutoCloseable {
  private final BufferedWriter writer;
  private boolean placed;

  /**
   * @throws IOException if the file cannot be created
   */
  public CsvTrackOutput(Path file) throws IOException {
    writer =
        new BufferedWriter(
            Channels.newWriter(
                PrivateFiles.open(
                    file,
                    StandardOpenOption.CREATE,
                    StandardOpenOption.TRUNCATE_EXISTING,
                    StandardOpenOption.WRITE),
                StandardCharsets.UTF_8));
  }

  @Override
  public void begin(boolean placed) throws IOException {
    this.placed = placed;
    writer.write(
        placed
            ? CsvWriter.line("t", "yaw", "pitch", "roll", "right", "up", "back")
            : CsvWriter.line("t", "yaw", "pitch", "roll"));
  }

  @Override
  public void sample(double time, PoseSample sample) throws IOException {
    List<String> cells = new ArrayList<>();
    cells.add(DecimalFormatter.fixed(time, 6));
    cells.add(DecimalFormatter.fixed(sample.yaw(), 4));
    cells.add(DecimalFormatter.fixed(sample.pitch(), 4));
    cells.add(DecimalFormatter.fixed(sample.roll(), 4));
    if (placed) {
      for (double way : new double[] {sample.x(), sample.y(), sample.z()}) {
        cells.add(sample.placed() ? DecimalFormatter.fixed(way, 5) : "");
      }
    }
    writer.write(CsvWriter.line(cells.toArray()));
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
