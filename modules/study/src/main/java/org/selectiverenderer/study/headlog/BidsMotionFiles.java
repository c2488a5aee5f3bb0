package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.joml.Quaterniond;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;

/**
 * Converts a head log to BIDS motion data (Brain Imaging Data Structure 1.9 and later, "Motion";
 * Jeung and others 2024, Motion-BIDS): {@code *_motion.tsv} without a header, {@code
 * *_channels.tsv} naming its columns, {@code *_motion.json} and {@code *_channels.json}.
 */
public final class BidsMotionFiles {
  /** A channel: a column of the data. */
  private record Channel(
      String name, String component, String type, String units, ToDoubleFunction<Row> value) {}

  /** A sample, with the factor from scene units to metres and the orientation as a quaternion. */
  private record Row(HeadSample sample, double metres, double started, Quaterniond turn) {}

  private static final List<Channel> CHANNELS =
      List.of(
          new Channel("head_POS_x", "x", "POS", "m", r -> r.sample.x() * r.metres),
          new Channel("head_POS_y", "y", "POS", "m", r -> r.sample.y() * r.metres),
          new Channel("head_POS_z", "z", "POS", "m", r -> r.sample.z() * r.metres),
          new Channel("head_ORNT_x", "quat_x", "ORNT", "n/a", r -> r.turn.x),
          new Channel("head_ORNT_y", "quat_y", "ORNT", "n/a", r -> r.turn.y),
          new Channel("head_ORNT_z", "quat_z", "ORNT", "n/a", r -> r.turn.z),
          new Channel("head_ORNT_w", "quat_w", "ORNT", "n/a", r -> r.turn.w),
          new Channel("latency", "n/a", "LATENCY", "s", r -> time(r.sample) - r.started),
          new Channel("visible", "n/a", "MISC", "n/a", r -> r.sample.visible() ? 1 : 0));

  /** All channel types of BIDS; the sidecar has a count for each, 0 for most. */
  private static final List<String> TYPES =
      List.of(
          "ACCEL", "ANGACCEL", "GYRO", "JNTANG", "LATENCY", "MAGN", "MISC", "ORNT", "POS", "VEL");

  /** Suffix of the data file's name. */
  public static final String DATA = "_motion.tsv";

  /** Name of the program, for files in which its version is not known. */
  public static final String SOFTWARE = "selective-renderer";

  private BidsMotionFiles() {}

  /**
   * Writes the four files, and those of the eyes if the log has gaze data; or none.
   *
   * @param folder created if it does not exist
   * @param subject label of the participant: letters and digits
   * @return the data file
   * @throws IOException if a file cannot be written
   */
  public static Path write(HeadLog log, Path folder, String subject) throws IOException {
    String stem = "sub-" + subject + "_task-viewing_tracksys-head";
    FileTransaction writing = new FileTransaction(FileOperations.PRIVATE);
    files(log, stem, "viewing", SOFTWARE)
        .forEach(
            (name, text) ->
                writing.add(folder.resolve(name), text.getBytes(StandardCharsets.UTF_8)));
    eyes(log, stem, "viewing", SOFTWARE)
        .forEach((name, bytes) -> writing.add(folder.resolve(name), bytes));
    writing.commit();
    return folder.resolve(stem + DATA);
  }

  /**
   * Returns the texts of the four files by their names. The data file comes last, so that once it
   * has been written the others exist, too.
   *
   * @param stem the files' names up to their suffix: BIDS entities in their order
   * @param task label of the task, as in the stem
   * @param software name and version of the program that recorded the log
   */
  public static Map<String, String> files(HeadLog log, String stem, String task, String software) {
    Map<String, String> files = new LinkedHashMap<>();
    // Channels are of the recording, not of the task's run: the tracking system stays in their
    // name.
    files.put(stem + "_channels.tsv", channels(log));
    files.put(stem + "_channels.json", frames());
    files.put(stem + "_motion.json", sidecar(log, task, software));
    files.put(stem + DATA, motion(log));
    return files;
  }

  /**
   * Returns the two files of eye-tracking data by their names; none for a log without gaze data.
   *
   * @param stem as for {@link #files}
   */
  public static Map<String, byte[]> eyes(HeadLog log, String stem, String task, String software) {
    return BidsEyeTrackingFiles.files(log, stem, task, software);
  }

  private static String motion(HeadLog log) {
    StringBuilder text = new StringBuilder();
    double started = time(log.samples().get(0));
    for (HeadSample sample : log.samples()) {
      Row row =
          new Row(
              sample,
              log.description().metresPerUnit(),
              started,
              new Quaterniond()
                  .rotationYXZ(
                      Math.toRadians(sample.yaw()),
                      Math.toRadians(sample.pitch()),
                      Math.toRadians(sample.roll())));
      for (int i = 0; i < CHANNELS.size(); i++) {
        text.append(i == 0 ? "" : "\t")
            .append(String.format(Locale.ROOT, "%.6f", CHANNELS.get(i).value.applyAsDouble(row)));
      }
      text.append('\n');
    }
    return text.toString();
  }

  /**
   * Returns the time of a sample with pauses included, if the log has the monotonic clock: BIDS
   * wants real time.
   */
  static double time(HeadSample sample) {
    double mono = sample.moment().mono();
    return Double.isNaN(mono) ? sample.t() : mono;
  }

  static double rate(HeadLog log) {
    double seconds = log.duration(); // Pauses have no samples and do not count.
    return seconds > 0 ? Math.round(1000 * (log.samples().size() - 1) / seconds) / 1000.0 : 0;
  }

  static double recorded(HeadLog log) {
    return time(log.samples().get(log.samples().size() - 1)) - time(log.samples().get(0));
  }

  private static String channels(HeadLog log) {
    StringBuilder text =
        new StringBuilder(
            "name\tcomponent\ttype\ttracked_point\tunits\tsampling_frequency\treference_frame\n");
    for (Channel channel : CHANNELS) {
      boolean beside = channel.type.equals("LATENCY") || channel.type.equals("MISC");
      text.append(
          String.join(
              "\t",
              channel.name,
              channel.component,
              channel.type,
              beside ? "n/a" : "head",
              channel.units,
              Double.toString(rate(log)),
              beside ? "n/a" : "scene"));
      text.append('\n');
    }
    return text.toString();
  }

  private static String sidecar(HeadLog log, String task, String software) {
    ObjectNode root = JsonTree.object();
    root.put("TaskName", task);
    root.put(
        "TaskDescription",
        "looking about in the scene "
            + log.description().scene()
            + ", rendered "
            + log.description().condition());
    root.put("SamplingFrequency", rate(log));
    root.put("TrackingSystemName", "head");
    root.put("DeviceSerialNumber", "n/a");
    root.put("Manufacturer", "n/a");
    root.put("ManufacturersModelName", log.description().tracker());
    root.put("SoftwareVersions", software);
    root.put("SamplingFrequencyEffective", rate(log));
    root.put("MotionChannelCount", CHANNELS.size());
    for (String type : TYPES) {
      root.put(
          type + "ChannelCount",
          CHANNELS.stream().filter(channel -> channel.type.equals(type)).count());
    }
    root.put("TrackedPointsCount", 1);
    root.put("RecordingDuration", DecimalRounding.to(3, recorded(log)));
    root.put("MissingValues", "n/a");
    return JsonWriter.of(root);
  }

  private static String frames() {
    ObjectNode root = JsonTree.object();
    ObjectNode frame = root.putObject("reference_frame");
    frame.put("LongName", "reference frame");
    frame.put("Description", "the coordinates of the scene's world, X3D");
    ObjectNode scene = frame.putObject("Levels").putObject("scene");
    scene.put("SpatialAxes", "RSP");
    scene.put("RotationRule", "right-hand");
    scene.put("RotationOrder", "n/a");
    return JsonWriter.of(root);
  }
}
