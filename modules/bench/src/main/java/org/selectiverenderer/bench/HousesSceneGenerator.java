package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Generates houses of the heavy scene in a row, each in a file of its own that inlines 70 objects
 * of its own shapes: no two files of the scene are the same. The camera path goes through the first
 * house, whose walls hide the others.
 */
final class HousesSceneGenerator {
  /** The distance between two houses in metres; one is 7.2 m deep. */
  private static final double STEP = 8;

  /** The phase between the shapes of two houses; no multiple of it is one of the objects' 0.7. */
  private static final double PHASE = 0.0531;

  private HousesSceneGenerator() {}

  /**
   * Writes {@code scene.x3d}, {@code house00.x3d} and its following, the objects of each in a
   * folder {@code objects00}, and {@code bench-path.csv}.
   *
   * @param share share of the triangles of each object, above 0 and at most 1
   */
  static BenchScene write(Path dir, int houses, double share) throws IOException {
    Files.createDirectories(dir);
    X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
    HeavySceneGenerator.surroundings(out);
    BenchCameraPath.write(out);
    long bytes = 0;
    long triangles = 0;
    for (int i = 0; i < houses; i++) {
      String folder = String.format(Locale.ROOT, "objects%02d", i);
      HeavySceneGenerator.Written objects =
          HeavySceneGenerator.objects(dir.resolve(folder), share, PHASE * i);
      String file = String.format(Locale.ROOT, "house%02d.x3d", i);
      bytes += objects.bytes() + HeavySceneGenerator.write(dir.resolve(file), house(folder));
      triangles += objects.triangles();
      out.open("Transform", "translation", "0 0 " + DecimalFormatter.rounded(-STEP * i, 0));
      out.empty("Inline", "url", FieldValueFormatter.strings(file)).close();
    }
    Path scene = dir.resolve("scene.x3d");
    bytes += HeavySceneGenerator.write(scene, out.finish());
    Path path = dir.resolve("bench-path.csv");
    HeavySceneGenerator.write(path, BenchCameraPath.csv());
    int switches = houses * HeavySceneGenerator.OBJECTS;
    return new BenchScene(scene, path, switches, triangles, bytes);
  }

  private static String house(String folder) {
    X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
    HeavySceneGenerator.house(
        out,
        false,
        (i, x, z, room) ->
            BenchSwitchWriter.write(out, folder, HeavySceneGenerator.name(i), x, z, room));
    return out.finish();
  }
}
