package org.selectiverenderer.apartment;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.versions.GeneratedObject;
import org.selectiverenderer.apartment.versions.ObjectVersionGenerator;
import org.selectiverenderer.modelling.ParametricModel;

/** Generates the files of objects from their recipes, in parallel. */
final class ObjectFileGenerator {
  private final Map<String, Supplier<ParametricModel>> recipes;
  private final PolygonCounts counts;
  private final ObjectVersionGenerator maker = new ObjectVersionGenerator();

  ObjectFileGenerator(Map<String, Supplier<ParametricModel>> recipes, PolygonCounts counts) {
    this.recipes = recipes;
    this.counts = counts;
  }

  /**
   * Generates the files of objects, in the order of the names: two for objects listed in the
   * thesis's tables, one for others.
   *
   * @throws IllegalArgumentException if a recipe has more polygons than version 1 may have, or
   *     cannot be reduced to those of version 2
   */
  List<GeneratedObject> of(Collection<String> names) {
    try {
      return names.parallelStream().map(this::make).toList();
    } catch (IllegalArgumentException e) {
      // A parallel stream wraps another thread's exception in one of the same type.
      throw e.getCause() instanceof IllegalArgumentException cause ? cause : e;
    }
  }

  /** Generates the file of a model that has one version. */
  GeneratedObject single(ParametricModel model) {
    return maker.single(model);
  }

  private GeneratedObject make(String name) {
    ParametricModel recipe = recipe(name);
    return counts
        .of(name)
        .map(count -> maker.versions(recipe, count.original(), count.reduced()))
        .orElseGet(() -> maker.single(recipe));
  }

  private ParametricModel recipe(String name) {
    Supplier<ParametricModel> recipe = recipes.get(name);
    if (recipe == null) {
      throw new IllegalArgumentException("there is no recipe named " + name);
    }
    return recipe.get().named(name);
  }
}
