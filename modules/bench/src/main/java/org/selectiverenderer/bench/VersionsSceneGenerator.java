package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Path;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Generates the heavy scene with two versions of each object and areas that switch them, at the
 * thesis's ratio: seen selectively, a sixth of the polygons is left, wherever the viewer is.
 *
 * <p>All objects show the lower version, but for two in each room that turn to the higher one while
 * the viewer is in it, as what one does not expect there (thesis 5.2).
 */
public final class VersionsSceneGenerator {
  /** The share of polygons that selective rendering leaves in the thesis's apartment, about. */
  public static final double SELECTIVE = 1.0 / 6;

  /** The number of objects that a room's area turns to the higher version. */
  static final int UNEXPECTED = 2;

  /** An area behind the house, to which the path does not lead. */
  private static final String GARDEN = "Garden";

  private static final String HIGH = "high";
  private static final String LOW = "low";

  private VersionsSceneGenerator() {}

  /**
   * Writes {@code scene.x3d}, the objects in folders {@code high} and {@code low}, and {@code
   * bench-path.csv}.
   *
   * @param dir created if it does not exist
   * @param share share of the 784,000 triangles that the higher versions have
   * @throws IOException when a file cannot be written
   */
  public static BenchScene write(Path dir, double share) throws IOException {
    double seen = (double) UNEXPECTED / HeavySceneGenerator.OBJECTS;
    HeavySceneGenerator.Written high = HeavySceneGenerator.objects(dir.resolve(HIGH), share, 0);
    HeavySceneGenerator.Written low =
        HeavySceneGenerator.objects(dir.resolve(LOW), share * (SELECTIVE - seen) / (1 - seen), 0);
    X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
    HeavySceneGenerator.surroundings(out);
    BenchCameraPath.write(out);
    int[] unexpected = new int[HeavySceneGenerator.OBJECTS + 1];
    HeavySceneGenerator.house(
        out,
        true,
        (i, x, z, room) -> {
          // Those in the middle of the rooms, where the path passes them.
          boolean turns = i >= HeavySceneGenerator.OBJECTS / 2 && unexpected[room]++ < UNEXPECTED;
          BenchSwitchWriter.versions(
              out,
              HIGH,
              LOW,
              HeavySceneGenerator.name(i),
              x,
              z,
              turns ? "Room" + room + "Schema" : GARDEN + "Schema");
        });
    BenchRoomsWriter.area(out, true, GARDEN, 0, 20, 17);
    Path scene = dir.resolve("scene.x3d");
    long bytes = high.bytes() + low.bytes() + HeavySceneGenerator.write(scene, out.finish());
    Path path = dir.resolve("bench-path.csv");
    HeavySceneGenerator.write(path, BenchCameraPath.csv());
    return new BenchScene(scene, path, HeavySceneGenerator.OBJECTS, high.triangles(), bytes);
  }
}
