package org.selectiverenderer.apartment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.versions.MadeObject;
import org.selectiverenderer.apartment.versions.ObjectFile;
import org.selectiverenderer.modelling.Model;

/** Writes the apartment: the same bytes every time. Nothing is written before all of it is made. */
public final class ApartmentGenerator {
  private final PolygonCounts counts = PolygonCounts.load();
  private final Map<String, Supplier<Model>> recipes = Recipes.all();
  private final ObjectFiles files = new ObjectFiles(recipes, counts);

  /** The objects that there are recipes for. */
  public Set<String> objects() {
    return Set.copyOf(recipes.keySet());
  }

  /**
   * Writes the files of some objects into {@code inlineNodes}.
   *
   * @param folder where {@code inlineNodes} is or will be
   * @return file name to polygons
   * @throws IllegalArgumentException if there is no such object, or its polygons cannot be had
   */
  public Map<String, Integer> writeObjects(Path folder, Collection<String> names)
      throws IOException {
    List<MadeObject> made = files.of(names);
    Map<String, Integer> polygons = new TreeMap<>();
    for (MadeObject object : made) {
      for (ObjectFile file : object.files()) {
        write(folder.resolve("inlineNodes").resolve(file.name()), file.text());
        polygons.put(file.name(), file.polygons());
      }
    }
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
    Map<String, String> texts = Apartment.make(files, counts).texts();
    for (Map.Entry<String, String> file : texts.entrySet()) {
      write(folder.resolve(file.getKey()), file.getValue());
    }
    return texts.size();
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    Files.write(file, text.getBytes(StandardCharsets.UTF_8));
  }
}
