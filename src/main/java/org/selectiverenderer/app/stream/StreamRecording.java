package org.selectiverenderer.app.stream;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.DiskSync;
import org.selectiverenderer.base.files.FileNameLength;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.PrivateFiles;
import org.selectiverenderer.formats.csv.CsvWriter;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.lsl.LslInlet;
import org.selectiverenderer.lsl.LslLibrary;
import org.selectiverenderer.lsl.StreamInfo;

/**
 * The recording of one LSL stream into three files: samples, clock offsets and description. It is
 * confined to the recorder's thread.
 */
final class StreamRecording implements AutoCloseable {
  private static final int DECIMALS = 6;

  /** Markers of eye trackers' programs say so in words of their own, such as "calibration_end". */
  private static final Pattern CALIBRATION = Pattern.compile("calibrat", Pattern.CASE_INSENSITIVE);

  private static final int MOST_MARKS = 1000;
  private static final int LONGEST = 200;

  /** The number of samples after which other streams get their turn. */
  private static final int TURN = 4096;

  private final LslInlet inlet;
  private final StreamInfo stream;
  private final Path csv;

  /** Bytes for the number of a recording and the endings of its files. */
  private static final int ROOM = 32;

  private final FileChannel samples;
  private final FileChannel offsets;
  private long count;
  private int marked;
  private boolean compared;
  private boolean known;

  private StreamRecording(
      LslInlet inlet, StreamInfo stream, Path csv, FileChannel samples, FileChannel offsets) {
    this.inlet = inlet;
    this.stream = stream;
    this.csv = csv;
    this.samples = samples;
    this.offsets = offsets;
  }

  /**
   * Opens the files and starts recording.
   *
   * @param inlet closed with the recording, also when it cannot be opened
   * @throws IOException if its files cannot be written
   */
  static StreamRecording open(LslInlet inlet, StreamInfo stream, Path folder) throws IOException {
    try {
      inlet.pull().ifPresent(sample -> {}); // connects; a first sample comes later than this
      PrivateFiles.createFolders(folder);
      PrivateFiles.requireNoLink(folder);
      String stem = free(folder, stream.name());
      Path csv = folder.resolve(stem + ".csv");
      AtomicFileWriter.writeOnce(
          folder.resolve(stem + ".json"), description(stream), FileOperations.PRIVATE);
      FileChannel samples = create(csv);
      FileChannel offsets = create(folder.resolve(stem + ".offsets.csv"));
      List<String> header = new ArrayList<>(List.of("time"));
      stream.channels().forEach(channel -> header.add(channel.label()));
      write(samples, CsvWriter.bare().row(header).toString());
      write(offsets, "wall,mono,lsl,offset,uncertainty\n");
      DiskSync.forceFolder(folder);
      return new StreamRecording(inlet, stream, csv, samples, offsets);
    } catch (IOException e) {
      inlet.close();
      throw e;
    }
  }

  private static FileChannel create(Path file) throws IOException {
    return PrivateFiles.open(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /**
   * Returns an unused file name: several streams may have the same name, and a session may be
   * resumed.
   */
  private static String free(Path folder, String name) {
    String plain = name.replaceAll("[^0-9A-Za-z._-]+", "-").replaceAll("^[.-]+|[.-]+$", "");
    plain = FileNameLength.shortened(plain, ROOM);
    for (int run = 1; ; run++) {
      String stem =
          String.format(Locale.ROOT, "%s_run-%02d", plain.isEmpty() ? "stream" : plain, run);
      if (!Files.exists(folder.resolve(stem + ".json"))) {
        return stem;
      }
    }
  }

  private static String description(StreamInfo stream) {
    ObjectNode root = JsonTree.object();
    root.put("name", stream.name());
    root.put("type", stream.type());
    root.put("nominal_rate_hz", stream.rate());
    root.put("values", stream.texts() ? "texts" : "numbers");
    root.put("source_id", stream.sourceId());
    root.put("host", stream.host());
    root.put("uid", stream.uid());
    ArrayNode channels = root.putArray("channels");
    for (StreamInfo.Channel channel : stream.channels()) {
      channels
          .addObject()
          .put("label", channel.label())
          .put("unit", channel.unit())
          .put("type", channel.type());
    }
    ObjectNode columns = root.putObject("columns");
    columns.put("time", "seconds of the sender's clock; add the offset for this machine's");
    ObjectNode measured = root.putObject("offsets");
    measured.put("wall", "date and time of the measurement by this machine, UTC");
    measured.put("mono", "this machine's monotonic clock in seconds, as head logs have it");
    measured.put("lsl", "this machine's clock of the Lab Streaming Layer in seconds");
    measured.put("offset", "seconds to be added to time to get lsl; empty when it is not known");
    measured.put("uncertainty", "seconds that the offset may be wrong at most");
    return JsonWriter.of(root);
  }

  StreamInfo stream() {
    return stream;
  }

  Path file() {
    return csv;
  }

  /** Returns the number of samples recorded. */
  long count() {
    return count;
  }

  /**
   * Writes the samples that have arrived and returns whether there may be more.
   *
   * @param marks receives the texts that tell of a calibration, with the time of the sender's clock
   */
  boolean take(CalibrationMarks marks) throws IOException {
    CsvWriter text = CsvWriter.bare();
    int taken = 0;
    for (Optional<LslInlet.Sample> sample = inlet.pull();
        sample.isPresent();
        sample = taken < TURN ? inlet.pull() : Optional.empty()) {
      List<String> row = new ArrayList<>();
      row.add(DecimalFormatter.fixed(sample.get().time(), DECIMALS));
      row.addAll(sample.get().values());
      text.row(row);
      if (stream.texts()) {
        mark(sample.get(), marks);
      }
      taken++;
    }
    if (taken > 0) {
      count += taken;
      write(samples, text.toString());
    }
    return taken == TURN;
  }

  /** Receives marks of calibrations. */
  @FunctionalInterface
  interface CalibrationMarks {
    /**
     * Receives a mark.
     *
     * @param time seconds of the sender's clock
     */
    void marked(double time, String text);
  }

  private void mark(LslInlet.Sample sample, CalibrationMarks marks) {
    for (String value : sample.values()) {
      if (marked < MOST_MARKS && CALIBRATION.matcher(value).find()) {
        marked++;
        marks.marked(sample.time(), value.length() > LONGEST ? value.substring(0, LONGEST) : value);
      }
    }
  }

  /** Returns whether the offset of the sender's clock has been measured. */
  boolean known() {
    return known;
  }

  /**
   * Writes the present clock offset if it is known; the first time in any case.
   *
   * @param timeout the longest time to wait for the offset, in seconds
   */
  void compare(LslLibrary lsl, double timeout) throws IOException {
    Optional<LslInlet.Offset> offset = inlet.offset(timeout);
    known |= offset.isPresent();
    if (offset.isEmpty() && compared) {
      return;
    }
    compared = true;
    double mono = System.nanoTime() * 1e-9;
    double clock = lsl.clock();
    write(
        offsets,
        CsvWriter.line(
            Instant.now().truncatedTo(ChronoUnit.MILLIS),
            DecimalFormatter.fixed(mono, DECIMALS),
            DecimalFormatter.fixed(clock, DECIMALS),
            offset.map(value -> DecimalFormatter.fixed(value.seconds(), DECIMALS)).orElse(""),
            offset.map(value -> DecimalFormatter.fixed(value.uncertainty(), DECIMALS)).orElse("")));
  }

  /** Forces the written data to the disk. */
  void keep() throws IOException {
    samples.force(false);
    offsets.force(false);
  }

  private static void write(FileChannel channel, String text) throws IOException {
    DiskSync.write(channel, text.getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public void close() throws IOException {
    try (samples;
        offsets) {
      inlet.close();
    }
  }
}
