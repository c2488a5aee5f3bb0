package org.selectiverenderer.experiment.headlog;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.joml.Quaterniond;

/**
 * A head log as BIDS motion data (Brain Imaging Data Structure 1.9 and later, "Motion"; Jeung and
 * others 2024, Motion-BIDS): {@code *_motion.tsv} without a header, {@code *_channels.tsv} naming
 * its columns, {@code *_motion.json} and {@code *_channels.json}.
 */
public final class Bids {
  /** A column of the data. */
  private record Channel(
      String name, String component, String type, String units, ToDoubleFunction<Row> value) {}

  /** A sample in metres and quaternions. */
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
          new Channel("latency", "n/a", "LATENCY", "s", r -> r.sample.t() - r.started));

  private Bids() {}

  /**
   * Writes the four files.
   *
   * @param folder made if it is not there
   * @param subject label of the participant: letters and digits
   * @return the data file
   * @throws IOException if a file cannot be written
   */
  public static Path write(HeadLog log, Path folder, String subject) throws IOException {
    Files.createDirectories(folder);
    String stem = "sub-" + subject + "_task-viewing_tracksys-head";
    Path data = folder.resolve(stem + "_motion.tsv");
    Files.writeString(data, motion(log), StandardCharsets.UTF_8);
    // Channels are of the recording, not of the task's run: the tracking system stays in their
    // name.
    Files.writeString(
        folder.resolve(stem + "_channels.tsv"), channels(log), StandardCharsets.UTF_8);
    Files.writeString(
        folder.resolve(stem + "_motion.json"), sidecar(log) + "\n", StandardCharsets.UTF_8);
    Files.writeString(
        folder.resolve(stem + "_channels.json"), frames() + "\n", StandardCharsets.UTF_8);
    return data;
  }

  private static String motion(HeadLog log) {
    StringBuilder text = new StringBuilder();
    double started = log.samples().get(0).t();
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

  private static double rate(HeadLog log) {
    return log.duration() > 0
        ? Math.round(1000 * (log.samples().size() - 1) / log.duration()) / 1000.0
        : 0;
  }

  private static String channels(HeadLog log) {
    StringBuilder text =
        new StringBuilder(
            "name\tcomponent\ttype\ttracked_point\tunits\tsampling_frequency\treference_frame\n");
    for (Channel channel : CHANNELS) {
      boolean latency = channel.type.equals("LATENCY");
      text.append(
          String.join(
              "\t",
              channel.name,
              channel.component,
              channel.type,
              latency ? "n/a" : "head",
              channel.units,
              Double.toString(rate(log)),
              latency ? "n/a" : "scene"));
      text.append('\n');
    }
    return text.toString();
  }

  private static String sidecar(HeadLog log) {
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("TaskName", "viewing");
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
    root.put("SoftwareVersions", "Selective Renderer");
    root.put("MotionChannelCount", CHANNELS.size());
    root.put("POSChannelCount", 3);
    root.put("ORNTChannelCount", 4);
    root.put("LATENCYChannelCount", 1);
    root.put("TrackedPointsCount", 1);
    root.put("RecordingDuration", Math.round(log.duration() * 1000) / 1000.0);
    root.put("MissingValues", "n/a");
    return root.toPrettyString();
  }

  private static String frames() {
    ObjectNode root = new ObjectMapper().createObjectNode();
    ObjectNode frame = root.putObject("reference_frame");
    frame.put("LongName", "reference frame");
    frame.put("Description", "the coordinates of the scene's world, X3D");
    ObjectNode scene = frame.putObject("Levels").putObject("scene");
    scene.put("SpatialAxes", "RSP");
    scene.put("RotationRule", "right-hand");
    scene.put("RotationOrder", "n/a");
    return root.toPrettyString();
  }
}
