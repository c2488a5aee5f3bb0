package org.selectiverenderer.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.IntStream;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Generates a scene of the thesis's size: 70 inlined objects with 784,000 triangles in about 31 MB
 * of X3D text, in three rooms of 17 m by 7 m together. Selective rendering leaves a sixth of the
 * triangles.
 *
 * <p>Every object stands in a Switch with metadata: child 0 is the inlined object, child 1 a box in
 * its place. All show child 0 at first. The three areas' sensors are not enabled, so that a camera
 * path draws the same triangles in every browser; set {@code enabled} to have them switch.
 */
public final class HeavySceneGenerator {

  /** Objects, each in a file and a Switch of its own. */
  public static final int OBJECTS = 70;

  /** Triangles of the objects at a share of 1. */
  public static final int TRIANGLES = 784_000;

  /** Rows of triangle pairs of a middle object, and columns: 70 * 2 * 70 * 80 = 784,000. */
  private static final int ROWS = 70;

  private static final int COLUMNS = 80;

  private static final int PLACES_IN_A_ROW = 10;
  private static final double[] ROOM_BOUNDS = {-8.5, -1.7, 3.4, 8.5};

  private static final String FOLDER = "objects";

  private HeavySceneGenerator() {}

  /**
   * Writes the whole scene into a folder {@code heavy}.
   *
   * @param folder the folder in which this folder is created
   * @throws IOException when a file cannot be written
   */
  public static BenchScene heavy(Path folder) throws IOException {
    return write(folder.resolve("heavy"), 1);
  }

  /**
   * Writes the scene with a sixth of the triangles, as selective rendering leaves it, into a folder
   * {@code light}.
   */
  public static BenchScene light(Path folder) throws IOException {
    return write(folder.resolve("light"), 1.0 / 6);
  }

  /**
   * Writes {@code scene.x3d}, {@code objects/object00.x3d} to {@code object69.x3d} and {@code
   * bench-path.csv}. The same share gives the same bytes.
   *
   * @param dir created if it does not exist
   * @param share share of the 784,000 triangles, above 0 and at most 1; met to a thousandth
   * @throws IllegalArgumentException when the share is out of range
   * @throws IOException when a file cannot be written
   */
  public static BenchScene write(Path dir, double share) throws IOException {
    if (!(share > 0 && share <= 1)) {
      throw new IllegalArgumentException("share must be above 0 and at most 1: " + share);
    }
    Written objects = objects(dir.resolve(FOLDER), share, 0);
    Path scene = dir.resolve("scene.x3d");
    X3dWriter out = new X3dWriter().file("Immersive", "3.3").open("Scene");
    surroundings(out);
    BenchCameraPath.write(out);
    house(out, false, (i, x, z, room) -> BenchSwitchWriter.write(out, FOLDER, name(i), x, z, room));
    long bytes = objects.bytes() + write(scene, out.finish());
    Path path = dir.resolve("bench-path.csv");
    write(path, BenchCameraPath.csv());
    return new BenchScene(scene, path, OBJECTS, objects.triangles(), bytes);
  }

  /** The length of the objects' files, and their triangles. */
  record Written(long bytes, long triangles) {}

  /**
   * Writes {@code object00.x3d} to {@code object69.x3d}.
   *
   * @param folder created if it does not exist
   * @param share share of the 784,000 triangles
   * @param phase in radians: another one gives objects of other shapes
   */
  static Written objects(Path folder, double share, double phase) throws IOException {
    Files.createDirectories(folder);
    int columns = Math.max(3, (int) Math.round(COLUMNS * Math.sqrt(share)));
    int[] rows = rows(share, columns);
    long triangles = 2L * columns * IntStream.of(rows).sum();
    try {
      return new Written(
          IntStream.range(0, OBJECTS)
              .parallel()
              .mapToLong(i -> writeObject(folder, i, phase, rows[i], columns))
              .sum(),
          triangles);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  /**
   * Returns the rows of each object: objects differ in size, and rounding errors are carried to the
   * next one.
   */
  private static int[] rows(double share, int columns) {
    int[] rows = new int[OBJECTS];
    double perRow = share * COLUMNS / columns;
    double due = 0;
    int given = 0;
    for (int i = 0; i < OBJECTS; i++) {
      int size = ROWS + (i % 2 == 0 ? i / 2 : -(i / 2));
      due += size * perRow;
      rows[i] = Math.max(3, (int) Math.round(due) - given);
      given += rows[i];
    }
    return rows;
  }

  private static long writeObject(Path folder, int i, double phase, int rows, int columns) {
    BenchSurface form = BenchSurface.values()[i % BenchSurface.values().length];
    String name = name(i);
    SurfaceMesh mesh = SurfaceMesh.of(form, 0.7 * i + phase, rows, columns);
    try {
      return write(
          folder.resolve(name.toLowerCase(Locale.ROOT) + ".x3d"),
          BenchObjectWriter.text(name, i, mesh));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Writes how the viewer moves, the background and the lights. */
  static void surroundings(X3dWriter out) {
    out.empty(
        "NavigationInfo",
        "type",
        FieldValueFormatter.strings("WALK", "ANY"),
        "avatarSize",
        "0.25 1.7 0.6",
        "headlight",
        "false");
    out.empty("Background", "skyColor", "0.6 0.7 0.8");
    out.open("DirectionalLight", "direction", "-0.5 -0.75 -0.4", "intensity", "0.7");
    out.attribute("ambientIntensity", "0.6").close();
    out.empty("DirectionalLight", "direction", "0.7 -0.3 0.6", "intensity", "0.35");
  }

  /** Writes what stands at a place of the house. */
  interface ObjectWriter {
    /**
     * @param i number of the object
     * @param room number of the room, from 1
     */
    void write(int i, double x, double z, int room);
  }

  /**
   * Writes the rooms with their areas and objects.
   *
   * @param enabled whether the areas' sensors are
   */
  static void house(X3dWriter out, boolean enabled, ObjectWriter objects) {
    BenchRoomsWriter.write(out, enabled, ROOM_BOUNDS);
    for (int i = 0; i < OBJECTS; i++) {
      double x = -7.65 + 1.7 * (i % PLACES_IN_A_ROW);
      double z = -3 + i / PLACES_IN_A_ROW;
      objects.write(i, x, z, room(x));
    }
  }

  /** Number of the room, from 1. */
  private static int room(double x) {
    int room = 1;
    while (x > ROOM_BOUNDS[room]) {
      room++;
    }
    return room;
  }

  static String name(int i) {
    return String.format(Locale.ROOT, "Object%02d", i);
  }

  static long write(Path file, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    Files.write(file, bytes);
    return bytes.length;
  }
}
