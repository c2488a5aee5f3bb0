package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.base.decimal.DecimalRounding;

/**
 * Measures the gain of selective rendering: the apartment in the thesis's three conditions (6.1.3),
 * seen from the centre of each room in a full turn. The conditions alternate, so that temporary
 * load of the machine affects all of them, and ratios are those of neighbouring runs.
 */
final class RoomMeasurement {
  private static final List<String> CONDITIONS = List.of("high", "high-low", "selective");
  private static final String HIGH = CONDITIONS.get(0);
  private static final String SELECTIVE = CONDITIONS.get(2);

  /** The duration of the turn in seconds: 120 frames. */
  private static final String SECONDS = "2";

  /** The height of the eyes of a seated person above the scene's origin, in metres. */
  private static final double EYES = Room.FLOOR + 1.2;

  private final ChildProcessRun child;
  private final int runs;
  private final Consumer<String> progress;

  RoomMeasurement(ChildProcessRun child, int runs, Consumer<String> progress) {
    this.child = child;
    this.runs = runs;
    this.progress = progress;
  }

  /**
   * @param scene the apartment
   * @param folder for the paths
   */
  void measure(Path scene, Path folder, ObjectNode node) throws IOException, InterruptedException {
    for (Room room : Room.values()) {
      String name = room.name().toLowerCase(Locale.ROOT);
      progress.accept("apartment: " + name);
      Path turn = folder.resolve(name + ".csv");
      Files.writeString(turn, turn(room.middle()));
      Map<String, List<JsonNode>> figures = new LinkedHashMap<>();
      for (int run = 0; run < runs; run++) {
        for (String condition : CONDITIONS) {
          figures
              .computeIfAbsent(condition, unused -> new ArrayList<>())
              .add(child.once(scene, turn, SECONDS, "--condition", condition));
        }
      }
      put(node.putObject(name), figures);
    }
  }

  static String turn(double x) {
    StringBuilder path = new StringBuilder("t,x,y,z,yaw,pitch,roll\n");
    for (int quarter = 0; quarter <= 4; quarter++) {
      path.append(
          String.format(
              Locale.ROOT, "%.1f,%.3f,%.3f,0,%d,-8,0\n", quarter / 2.0, x, EYES, 90 * quarter));
    }
    return path.toString();
  }

  static void put(ObjectNode node, Map<String, List<JsonNode>> figures) {
    figures.forEach(
        (condition, all) ->
            node.putObject(condition)
                .put("first_frame_ms", ChildProcessRun.median(all, "/first_frame_ms"))
                .put("fps", ChildProcessRun.median(all, "/fps"))
                .put("frame_p50_ms", ChildProcessRun.median(all, "/frame_ms/p50"))
                .put("polygons_drawn", ChildProcessRun.median(all, "/polygons_drawn/mean"))
                .put("polygons", ChildProcessRun.median(all, "/polygons/mean"))
                .put("rss_mb", ChildProcessRun.median(all, "/peak_rss_mb")));
    node.put("selective_to_high", ratio(figures.get(SELECTIVE), figures.get(HIGH)));
  }

  /** Returns the median ratio of the frame rates of pairs of runs. */
  private static double ratio(List<JsonNode> ones, List<JsonNode> others) {
    double[] ratios = new double[ones.size()];
    for (int i = 0; i < ratios.length; i++) {
      ratios[i] = ones.get(i).at("/fps").asDouble() / others.get(i).at("/fps").asDouble();
    }
    return DecimalRounding.to(2, Medians.median(ratios));
  }
}
