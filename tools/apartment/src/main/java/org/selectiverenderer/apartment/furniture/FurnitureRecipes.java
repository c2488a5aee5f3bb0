package org.selectiverenderer.apartment.furniture;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.apartment.materials.Materials;
import org.selectiverenderer.modelling.ParametricModel;

/** The recipes of the furniture by name. */
public final class FurnitureRecipes {

  private FurnitureRecipes() {}

  /** Returns the recipes of all pieces of the kitchen, the lounge and the office. */
  public static Map<String, Supplier<ParametricModel>> all() {
    Map<String, Supplier<ParametricModel>> recipes = new TreeMap<>();
    recipes.put("larder", Larder::model);
    recipes.put("bench", Bench::model);
    recipes.put("kitchenBlind", () -> RollerBlind.model("kitchenBlind", 1.6));
    recipes.put(
        "kitchenRug",
        () -> Rug.model("kitchenRug", 1.9, 0.75, 0.07, Materials.LINEN, Materials.TEAL_CLOTH));
    recipes.put("sideboard", Sideboard::model);
    recipes.put("bowl", Bowl::model);
    recipes.put("displayCabinet", DisplayCabinet::model);
    recipes.put("chest", Chest::model);
    recipes.put("pouf", Pouf::model);
    recipes.put("pendantLamp", PendantLamp::model);
    recipes.put("wideCurtains", () -> Curtains.model("wideCurtains", 2.2));
    recipes.put("narrowCurtains", () -> Curtains.model("narrowCurtains", 1.6));
    recipes.put("credenza", Credenza::model);
    recipes.put("whiteboard", Whiteboard::model);
    recipes.put("pinboard", Pinboard::model);
    recipes.put("filingCabinet", FilingCabinet::model);
    recipes.put("meetingTable", MeetingTable::model);
    recipes.put("visitorChair", VisitorChair::model);
    recipes.put(
        "officeRug",
        () -> Rug.model("officeRug", 2.2, 1.5, 0.1, Materials.RUST_CLOTH, Materials.LINEN));
    recipes.put("rollerBlind", () -> RollerBlind.model("rollerBlind", 2));
    return recipes;
  }
}
