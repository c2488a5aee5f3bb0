package org.selectiverenderer.apartment;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.apartment.furniture.Furniture;
import org.selectiverenderer.apartment.kitchen.KitchenObjects;
import org.selectiverenderer.apartment.lounge.LoungeObjects;
import org.selectiverenderer.apartment.office.OfficeObjects;
import org.selectiverenderer.modelling.ParametricModel;

/** The registry of all recipes by object name. */
final class Recipes {

  private Recipes() {}

  static Map<String, Supplier<ParametricModel>> all() {
    Map<String, Supplier<ParametricModel>> all = new TreeMap<>(KitchenObjects.all());
    add(all, LoungeObjects.all());
    add(all, OfficeObjects.all());
    add(all, Furniture.all());
    return all;
  }

  private static void add(
      Map<String, Supplier<ParametricModel>> all, Map<String, Supplier<ParametricModel>> room) {
    room.forEach(
        (name, recipe) -> {
          if (all.put(name, recipe) != null) {
            throw new IllegalStateException("two recipes are named " + name);
          }
        });
  }
}
