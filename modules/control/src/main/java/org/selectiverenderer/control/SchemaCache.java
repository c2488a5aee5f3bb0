package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;

/**
 * Reads the schemas of objects and areas. Metadata that say the same are interpreted once, and
 * objects share the result: a file that is inlined many times repeats its metadata in each copy.
 * Metadata with problems are always interpreted, because each problem tells its node.
 */
final class SchemaCache {
  /** The results kept, beyond which they are forgotten: a Script may write ever new metadata. */
  private static final int MOST_RESULTS = 4_096;

  /** The number of nodes or values, and of letters of a text, beyond which nothing is kept. */
  private static final int MOST_PARTS = 256;

  private enum Bracket {
    SET,
    END
  }

  private final Map<List<Object>, Optional<SwitchSchemas>> objects = new HashMap<>();
  private final Map<List<Object>, Optional<SensorSchemas>> areas = new HashMap<>();

  /**
   * Reads the schemas of an object's versions.
   *
   * @param children the number of children of the Switch
   */
  Optional<SwitchSchemas> object(
      SaiMetadata metadata, int children, Consumer<SchemaProblem> problems) {
    List<Object> key = new ArrayList<>();
    key.add(children);
    return read(metadata, key, objects, problems, reader -> reader.switchNode(metadata, children));
  }

  /** Reads the schemas of an area. */
  Optional<SensorSchemas> area(SaiMetadata metadata, Consumer<SchemaProblem> problems) {
    return read(metadata, new ArrayList<>(), areas, problems, reader -> reader.sensor(metadata));
  }

  private static <S> Optional<S> read(
      SaiMetadata metadata,
      List<Object> key,
      Map<List<Object>, Optional<S>> results,
      Consumer<SchemaProblem> problems,
      Function<SchemaReader, Optional<S>> reading) {
    boolean comparable = describe(metadata, key);
    if (comparable && results.containsKey(key)) {
      return results.get(key);
    }
    AtomicBoolean faulty = new AtomicBoolean();
    Optional<S> read =
        reading.apply(
            new SchemaReader(
                problem -> {
                  faulty.set(true);
                  problems.accept(problem);
                }));
    if (comparable && !faulty.get()) {
      if (results.size() >= MOST_RESULTS) {
        results.clear();
      }
      results.put(key, read);
    }
    return read;
  }

  /**
   * Appends all that a reader of schemas sees of metadata; the name of a set has no meaning.
   *
   * @return false if there is too much of it, as in a set that contains itself
   */
  private static boolean describe(SaiMetadata metadata, List<Object> key) {
    if (key.size() > MOST_PARTS) {
      return false;
    }
    if (!metadata.isSet()) {
      key.add(metadata.name());
      key.add(metadata.values());
      return metadata.name().length() <= MOST_PARTS
          && metadata.values().size() <= MOST_PARTS
          && metadata.values().stream().allMatch(value -> value.length() <= MOST_PARTS);
    }
    key.add(Bracket.SET);
    for (SaiMetadata child : metadata.children()) {
      if (!describe(child, key)) {
        return false;
      }
    }
    key.add(Bracket.END);
    return true;
  }
}
