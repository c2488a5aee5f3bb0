package org.selectiverenderer.study.bids;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.joml.Quaterniond;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.TimeSeriesReader;
import org.selectiverenderer.formats.csv.TimeSeriesSpec;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.dataset.RecordedRun;

/**
 * Converts the records of a head tracker, which lie at the tracker's own rate in {@code
 * NAME_tracker.csv} beside the head log, to motion data of a separate tracking system, {@code
 * tracksys-tracker}.
 */
final class BidsTrackerMotion {
  private static final TimeSeriesSpec FORM =
      new TimeSeriesSpec(
          "the tracker's log",
          "the tracker's records are left out",
          List.of("t", "yaw", "pitch", "roll"),
          List.of("right", "up", "back"),
          false,
          true,
          true);

  private static final List<String> PARTS = List.of("quat_x", "quat_y", "quat_z", "quat_w");

  /** Position channels, for a tracker that measures the head's position: right, up and back. */
  private static final List<String> PLACE = List.of("x", "y", "z");

  /** Index of the first position column among those of {@link #FORM}. */
  private static final int RIGHT = 4;

  private BidsTrackerMotion() {}

  /**
   * Adds the files of a run's records, if there are any.
   *
   * @param stem path and name up to {@code _motion.tsv}
   * @param model the tracker's name, from the head log's description
   * @return whether the run has tracker records
   */
  static boolean add(
      RecordedRun run,
      String stem,
      String task,
      String model,
      BidsFileSet files,
      ProblemCollector problems)
      throws IOException {
    Path log = run.headLog().resolveSibling(run.headName() + "_tracker.csv");
    Optional<double[][]> read =
        Files.isRegularFile(log) ? TimeSeriesReader.read(FORM, log, problems) : Optional.empty();
    if (read.isEmpty()) {
      return false;
    }
    double[][] rows = read.get();
    double seconds = rows[rows.length - 1][0] - rows[0][0];
    double rate = seconds > 0 ? DecimalRounding.to(3, (rows.length - 1) / seconds) : 0;
    boolean placed = rows[0].length > RIGHT;
    files.add(stem + "_channels.tsv", channels(rate, placed));
    files.add(stem + "_channels.json", frames());
    files.add(stem + "_motion.json", sidecar(task, model, rate, seconds, placed));
    files.add(stem + "_motion.tsv", data(rows, placed));
    return true;
  }

  private static String data(double[][] rows, boolean placed) {
    StringBuilder text = new StringBuilder();
    Quaterniond turn = new Quaterniond();
    for (double[] row : rows) {
      turn.rotationYXZ(Math.toRadians(row[1]), Math.toRadians(row[2]), Math.toRadians(row[3]));
      text.append(
          String.format(Locale.ROOT, "%.6f\t%.6f\t%.6f\t%.6f\t", turn.x, turn.y, turn.z, turn.w));
      for (int i = 0; placed && i < PLACE.size(); i++) {
        double way = row[RIGHT + i];
        text.append(Double.isNaN(way) ? "n/a" : DecimalFormatter.fixed(way, 5)).append('\t');
      }
      text.append(DecimalFormatter.fixed(row[0] - rows[0][0], 6)).append('\n');
    }
    return text.toString();
  }

  private static String channels(double rate, boolean placed) {
    StringBuilder text =
        new StringBuilder(
            "name\tcomponent\ttype\ttracked_point\tunits\tsampling_frequency\treference_frame\n");
    for (String part : PARTS) {
      text.append("tracker_ORNT_%s\t%s\tORNT\thead\tn/a\t".formatted(part.substring(5), part))
          .append(rate)
          .append("\ttracker\n");
    }
    for (String part : placed ? PLACE : List.<String>of()) {
      text.append("tracker_POS_%s\t%s\tPOS\thead\tm\t".formatted(part, part))
          .append(rate)
          .append("\ttracker\n");
    }
    return text.append("latency\tn/a\tLATENCY\tn/a\ts\t").append(rate).append("\tn/a\n").toString();
  }

  private static String sidecar(
      String task, String model, double rate, double seconds, boolean placed) {
    int places = placed ? PLACE.size() : 0;
    ObjectNode root = JsonTree.object();
    root.put("TaskName", task);
    root.put(
        "TaskDescription",
        (placed ? "orientations and places" : "orientations")
            + " as the tracker told them, before the heading's reset");
    root.put("SamplingFrequency", rate);
    root.put("SamplingFrequencyEffective", rate);
    root.put("TrackingSystemName", "tracker");
    root.put("DeviceSerialNumber", "n/a");
    root.put("Manufacturer", "n/a");
    root.put("ManufacturersModelName", model.isEmpty() ? "n/a" : model);
    root.put("SoftwareVersions", "n/a");
    root.put("MotionChannelCount", PARTS.size() + places + 1);
    for (String type : List.of("ACCEL", "ANGACCEL", "GYRO", "JNTANG", "MAGN", "MISC", "VEL")) {
      root.put(type + "ChannelCount", 0);
    }
    root.put("POSChannelCount", places);
    root.put("ORNTChannelCount", PARTS.size());
    root.put("LATENCYChannelCount", 1);
    root.put("TrackedPointsCount", 1);
    root.put("RecordingDuration", DecimalRounding.to(3, seconds));
    root.put("MissingValues", "n/a");
    return JsonWriter.of(root);
  }

  private static String frames() {
    ObjectNode root = JsonTree.object();
    ObjectNode frame = root.putObject("reference_frame");
    frame.put("LongName", "reference frame");
    frame.put("Description", "X3D's viewer, who looks along -Z with +Y up, at the tracker's zero");
    frame
        .putObject("Levels")
        .putObject("tracker")
        .put("SpatialAxes", "RSP")
        .put("RotationRule", "right-hand")
        .put("RotationOrder", "n/a");
    return JsonWriter.of(root);
  }
}
