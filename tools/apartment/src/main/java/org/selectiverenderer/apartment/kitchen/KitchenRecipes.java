package org.selectiverenderer.apartment.kitchen;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.modelling.ParametricModel;

/** The recipes of the kitchen by object name, as in the thesis's tables (Figs 67, 69, 71). */
public final class KitchenRecipes {

  private KitchenRecipes() {}

  /**
   * Returns the recipes of all objects of the kitchen. Models of listed objects have at most the
   * polygons of version 1 in the tables; the generator adds the missing ones.
   */
  public static Map<String, Supplier<ParametricModel>> all() {
    Map<String, Supplier<ParametricModel>> recipes = new TreeMap<>();
    recipes.put("saltcellar", Saltcellar::model);
    recipes.put("fruits", Fruits::model);
    recipes.put("glasses", Glasses::model);
    recipes.put("plates", Plates::model);
    recipes.put("teapot", Teapot::model);
    recipes.put("hamburger", Hamburger::model);
    recipes.put("saucepan", Saucepan::model);
    recipes.put("spoons", Spoons::model);
    recipes.put("toaster", Toaster::model);
    recipes.put("mixer", Mixer::model);
    recipes.put("kitchenTable", KitchenTable::model);
    recipes.put("kitchenFurniture", KitchenFurniture::model);
    recipes.put("refrigerator", Refrigerator::model);
    recipes.put("kitchenChair", KitchenChair::model);
    recipes.put("fryingPan", FryingPan::model);
    recipes.put("kitchenRoll", KitchenRoll::model);
    recipes.put("shovel", Shovel::model);
    recipes.put("kite", Kite::model);
    recipes.put("baseballBat", BaseballBat::model);
    recipes.put("bicycleWheel", BicycleWheel::model);
    recipes.put("hairDryer", HairDryer::model);
    recipes.put("violin", Violin::model);
    return recipes;
  }
}
