package org.selectiverenderer.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.joml.Vector3d;
import org.selectiverenderer.apartment.ApartmentGenerator;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.scene.ApartmentSceneWriter;
import org.selectiverenderer.apartment.scene.StreetScene;

/**
 * Writes many apartments of the thesis in one scene, as {@code apartment --street} does. An
 * apartment that is there already is not made again, as that takes many seconds.
 */
final class StreetSceneGenerator {
  /** Polygons of one apartment with all objects high: the sum of thesis Tables 3 to 5. */
  private static final long POLYGONS = 784_271;

  private static final Pattern INLINED = Pattern.compile("\"(\\.\\./inlineNodes/[^\"]+\\.x3d)\"");
  private static final Pattern SWITCH = Pattern.compile("<Switch ");
  private static final double EYE = Room.FLOOR + ApartmentSceneWriter.EYE;

  private StreetSceneGenerator() {}

  static BenchScene write(Path dir, int apartments) throws IOException {
    Path scenes = dir.resolve("scenes");
    Path apartment = scenes.resolve("apartment.x3d");
    if (!Files.exists(apartment)) {
      new ApartmentGenerator().writeAll(dir, false);
    }
    Path street = scenes.resolve(StreetScene.fileName(apartments));
    Files.writeString(street, StreetScene.text(apartments));
    String text = Files.readString(apartment);
    Set<String> files = new LinkedHashSet<>(List.of(street.toString(), apartment.toString()));
    for (Matcher url = INLINED.matcher(text); url.find(); ) {
      files.add(scenes.resolve(url.group(1)).toString());
    }
    long bytes = 0;
    for (String file : files) {
      bytes += Files.size(Path.of(file));
    }
    return new BenchScene(
        street,
        scenes.resolve("paths").resolve("apartment-tour.csv"),
        apartments * (int) SWITCH.matcher(text).results().count(),
        apartments * POLYGONS,
        bytes,
        new Vector3d(0, EYE, 0.1), // The kitchen.
        new Vector3d(-5.4, EYE, -0.5)); // The sofa's area of the first apartment's lounge.
  }
}
