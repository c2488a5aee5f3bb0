package org.selectiverenderer.apartment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.versions.ObjectFile;
import org.selectiverenderer.modelling.Model;

/** Writes the apartment: the same bytes every time. */
public final class ApartmentGenerator {
  private static final String INLINE_NODES = "inlineNodes";

  private final Map<String, Supplier<Model>> recipes = Recipes.all();
  private final ObjectFiles files = new ObjectFiles(recipes, PolygonCounts.load());

  /** The objects that there are recipes for. */
  public Collection<String> objects() {
    return List.copyOf(recipes.keySet());
  }

  /**
   * Writes the files of some objects into {@code inlineNodes}; nothing if one of them fails.
   *
   * @param folder where {@code inlineNodes} is or will be
   * @return file name to polygons
   * @throws IllegalArgumentException if there is no such object, or its polygons cannot be had
   */
  public Map<String, Integer> writeObjects(Path folder, Collection<String> names)
      throws IOException {
    List<ObjectFile> made = files.of(names);
    Path target = Files.createDirectories(folder.resolve(INLINE_NODES));
    Map<String, Integer> polygons = new TreeMap<>();
    for (ObjectFile file : made) {
      Files.write(target.resolve(file.name()), file.text().getBytes(StandardCharsets.UTF_8));
      polygons.put(file.name(), file.polygons());
    }
    return polygons;
  }
}
