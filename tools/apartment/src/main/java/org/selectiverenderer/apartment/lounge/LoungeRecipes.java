package org.selectiverenderer.apartment.lounge;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.modelling.ParametricModel;

/** The recipes of the lounge by object name, as in the thesis's tables (Figs 67, 69, 71). */
public final class LoungeRecipes {

  private LoungeRecipes() {}

  /**
   * Returns the recipes of all objects of the lounge. Models of listed objects have at most the
   * polygons of version 1 in the tables; the generator adds the missing ones.
   */
  public static Map<String, Supplier<ParametricModel>> all() {
    Map<String, Supplier<ParametricModel>> recipes = new TreeMap<>();
    recipes.put("ashTray", AshTray::model);
    recipes.put("biblioteca", Biblioteca::model);
    recipes.put("candle", Candle::model);
    recipes.put("cigaretteSet", CigaretteSet::model);
    recipes.put("glass", Glass::model);
    recipes.put("keys", DoorKeys::model);
    recipes.put("loungeBooks", LoungeBooks::model);
    recipes.put("loungeTable", LoungeTable::model);
    recipes.put("magazine", Magazine::model);
    recipes.put("mobile", Mobile::model);
    recipes.put("remoteControl", RemoteControl::model);
    recipes.put("sofa1", Sofa::first);
    recipes.put("sofa1Pillow", Pillow::first);
    recipes.put("sofa2", Sofa::second);
    recipes.put("sofa2Pillow", Pillow::second);
    recipes.put("speakers", Speakers::model);
    recipes.put("tv", Tv::model);
    recipes.put("vase", Vase::model);
    recipes.put("wine", Wine::model);
    addSingle(recipes);
    return recipes;
  }

  /**
   * Adds the objects with one version: furnishings, and four objects that nobody expects in a
   * lounge (rated 1.2 to 1.5 of 6 in thesis Appendix B).
   */
  private static void addSingle(Map<String, Supplier<ParametricModel>> recipes) {
    recipes.put("carpet", Carpet::model);
    recipes.put("floorLamp", FloorLamp::model);
    recipes.put("painting", Painting::model);
    recipes.put("barrel", Barrel::model);
    recipes.put("basketball", Basketball::model);
    recipes.put("hammer", Hammer::model);
    recipes.put("pumpkin", Pumpkin::model);
  }
}
