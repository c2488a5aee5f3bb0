package org.selectiverenderer.apartment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.versions.ObjectFile;

/** Writes the apartment: the same bytes every time. Nothing is written before all of it is made. */
public final class ApartmentGenerator {
  private static final String INLINE_NODES = "inlineNodes";
  private static final String SCENES = "scenes";

  private final PolygonCounts counts = PolygonCounts.load();
  private final ObjectFiles files = new ObjectFiles(Recipes.all(), counts);

  /**
   * Writes the files of some objects into {@code inlineNodes}.
   *
   * @param folder where {@code inlineNodes} is or will be
   * @return file name to polygons
   * @throws IllegalArgumentException if there is no such object, or its polygons cannot be had
   */
  public Map<String, Integer> writeObjects(Path folder, Collection<String> names)
      throws IOException {
    List<ObjectFile> made = files.of(names);
    writeInlineNodes(folder, made);
    Map<String, Integer> polygons = new TreeMap<>();
    made.forEach(file -> polygons.put(file.name(), file.polygons()));
    return polygons;
  }

  /**
   * Writes the scenes, their objects and the recorded walk.
   *
   * @param folder where {@code scenes} and {@code inlineNodes} are or will be
   * @return the number of files
   * @throws IllegalArgumentException if the recipes do not fit the plan or the polygon counts
   */
  public int writeAll(Path folder) throws IOException {
    Apartment apartment = Apartment.make(files, counts);
    writeInlineNodes(folder, apartment.inlineNodes());
    Files.createDirectories(folder.resolve(SCENES).resolve("paths"));
    for (Map.Entry<String, String> scene : apartment.scenes().entrySet()) {
      write(folder.resolve(SCENES).resolve(scene.getKey()), scene.getValue());
    }
    return apartment.inlineNodes().size() + apartment.scenes().size();
  }

  private static void writeInlineNodes(Path folder, List<ObjectFile> made) throws IOException {
    Path target = Files.createDirectories(folder.resolve(INLINE_NODES));
    for (ObjectFile file : made) {
      write(target.resolve(file.name()), file.text());
    }
  }

  private static void write(Path file, String text) throws IOException {
    Files.write(file, text.getBytes(StandardCharsets.UTF_8));
  }
}
