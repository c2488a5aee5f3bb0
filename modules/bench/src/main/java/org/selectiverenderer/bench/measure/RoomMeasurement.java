package org.selectiverenderer.bench.measure;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.selectiverenderer.apartment.plan.Room;

/**
 * Measures the gain of selective rendering: the apartment in the thesis's three conditions (6.1.3),
 * seen from the centre of each room in a full turn.
 */
final class RoomMeasurement {
  private static final List<String> CONDITIONS =
      List.of(ConditionComparison.HIGH, "high-low", ConditionComparison.SELECTIVE);

  /** The duration of the turn in seconds: 120 frames. */
  private static final String SECONDS = "2";

  /** The height of the eyes of a seated person above the scene's origin, in metres. */
  private static final double EYES = Room.FLOOR + 1.2;

  private final ConditionComparison comparison;
  private final Consumer<String> progress;

  RoomMeasurement(ConditionComparison comparison, Consumer<String> progress) {
    this.comparison = comparison;
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
      comparison.measure(scene, turn, SECONDS, CONDITIONS, node.putObject(name));
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
}
