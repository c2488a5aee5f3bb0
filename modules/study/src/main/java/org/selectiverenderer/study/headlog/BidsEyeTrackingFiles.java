package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;

/**
 * Converts the gaze data of a head log to BIDS eye-tracking data (Brain Imaging Data Structure
 * 1.11, "Physiological recordings", Eye-tracking): {@code *_recording-eye1_physio.tsv.gz} without a
 * header and {@code *_physio.json}, beside the motion data of the head, sample by sample. A headset
 * reports one gaze direction for both eyes, which BIDS calls cyclopean.
 */
final class BidsEyeTrackingFiles {
  private static final String NONE = "n/a";

  private BidsEyeTrackingFiles() {}

  /**
   * Returns the files by their names; none for a log without gaze data.
   *
   * @param stem name of the motion data up to the suffix
   */
  static Map<String, byte[]> files(HeadLog log, String stem, String task, String software) {
    Map<String, byte[]> files = new LinkedHashMap<>();
    if (log.samples().stream().anyMatch(sample -> sample.eyes() != null)) {
      String name = stem + "_recording-eye1_physio";
      files.put(name + ".json", sidecar(log, task, software).getBytes(StandardCharsets.UTF_8));
      files.put(name + ".tsv.gz", zipped(data(log)));
    }
    return files;
  }

  private static String data(HeadLog log) {
    StringBuilder text = new StringBuilder();
    double started = BidsMotionFiles.time(log.samples().get(0));
    for (HeadSample sample : log.samples()) {
      EyeSample eyes = sample.eyes();
      boolean known = eyes != null && eyes.tracked();
      text.append(
          String.join(
              "\t",
              number(BidsMotionFiles.time(sample) - started),
              known ? number(-eyes.yaw()) : NONE,
              known ? number(eyes.pitch()) : NONE,
              known ? number(eyes.distance() * log.description().metresPerUnit()) : NONE,
              sample.visible() ? "1" : "0"));
      text.append('\n');
    }
    return text.toString();
  }

  private static String number(double value) {
    return Double.isNaN(value) ? NONE : String.format(Locale.ROOT, "%.6f", value);
  }

  private static byte[] zipped(String text) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (GZIPOutputStream zip = new GZIPOutputStream(bytes)) {
      zip.write(text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException(e); // Memory throws no IOException.
    }
    return bytes.toByteArray();
  }

  private static String sidecar(HeadLog log, String task, String software) {
    ObjectNode root = JsonTree.object();
    root.put("TaskName", task);
    root.put("PhysioType", "eyetrack");
    root.put("RecordedEye", "cyclopean");
    root.put("SampleCoordinateSystem", "eye-in-head");
    root.put("SamplingFrequency", BidsMotionFiles.rate(log));
    root.put("StartTime", 0);
    root.put("Manufacturer", NONE);
    root.put("ManufacturersModelName", log.description().display());
    root.put("SoftwareVersions", software);
    root.put("RecordingDuration", DecimalRounding.to(3, BidsMotionFiles.recorded(log)));
    ArrayNode columns = root.putArray("Columns");
    List.of("timestamp", "x_coordinate", "y_coordinate", "distance", "visible")
        .forEach(columns::add);
    column(root, "timestamp", "since the first sample, which is that of the motion data", "s");
    column(
        root,
        "x_coordinate",
        "direction of the eyes from straight ahead of the head, positive to the right; n/a while"
            + " the eye tracker does not see them",
        "degree");
    column(root, "y_coordinate", "the same, positive up", "degree");
    column(root, "distance", "of the surface of the scene that the eyes look at", "m");
    root.putObject("visible")
        .put("Description", "whether the participant saw the picture")
        .putObject("Levels")
        .put("0", "black, or less than half as bright as it is")
        .put("1", "seen");
    return JsonWriter.of(root);
  }

  private static void column(ObjectNode root, String name, String description, String unit) {
    root.putObject(name).put("Description", description).put("Units", unit);
  }
}
