package org.selectiverenderer.apartment.office;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.modelling.ParametricModel;

/** The recipes of the office by object name, as in the thesis's tables (Figs 67, 69, 71). */
public final class OfficeRecipes {

  private OfficeRecipes() {}

  /**
   * Returns the recipes of all objects of the office. Models of listed objects have at most the
   * polygons of version 1 in the tables; the generator adds the missing ones.
   */
  public static Map<String, Supplier<ParametricModel>> all() {
    Map<String, Supplier<ParametricModel>> recipes = new TreeMap<>();
    recipes.put("bookcase", Bookcase::model);
    recipes.put("cd", Cd::model);
    recipes.put("clock", Clock::model);
    recipes.put("computerSet", ComputerSet::model);
    recipes.put("desk", Desk::model);
    recipes.put("deskLamp", DeskLamp::model);
    recipes.put("fireExtinguisher", FireExtinguisher::model);
    recipes.put("laptop", Laptop::model);
    recipes.put("libraryBooks", LibraryBooks::model);
    recipes.put("libraryMouse", LibraryMouse::model);
    recipes.put("libraryPencilHolder", LibraryPencilHolder::model);
    recipes.put("mug", Mug::model);
    recipes.put("pencilHolderDesk", PencilHolderDesk::model);
    recipes.put("plant", Plant::model);
    recipes.put("printer", Printer::model);
    recipes.put("ruler", Ruler::model);
    recipes.put("selotape", Selotape::model);
    recipes.put("telephoneLibrary", TelephoneLibrary::model);
    recipes.put("trashCan", TrashCan::model);
    recipes.put("folders", Folders::model);
    recipes.put("letterTray", LetterTray::model);
    recipes.put("notepad", Notepad::model);
    recipes.put("deskChair", DeskChair::model);
    recipes.put("poster", Poster::model);
    recipes.put("stapler", Stapler::model);
    recipes.put("trumpet", Trumpet::model);
    return recipes;
  }
}
