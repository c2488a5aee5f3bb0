package org.selectiverenderer.apartment.plan;

import static org.selectiverenderer.apartment.plan.Room.KITCHEN;
import static org.selectiverenderer.apartment.plan.Room.LOUNGE;
import static org.selectiverenderer.apartment.plan.Room.OFFICE;

import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.apartment.plan.Place.Against;
import org.selectiverenderer.apartment.plan.Place.Floor;
import org.selectiverenderer.apartment.plan.Place.Hung;
import org.selectiverenderer.apartment.plan.Place.On;

/** Where everything stands: one row per object. */
public final class Placements {

  private Placements() {}

  public static List<Placement> all() {
    return Stream.of(kitchen(), lounge(), office()).flatMap(List::stream).toList();
  }

  private static List<Placement> kitchen() {
    return List.of(
        row(KITCHEN, "kitchenFurniture", new Against(Side.EAST, -0.9, 0)),
        row(KITCHEN, "kitchenTable", new Floor(-0.95, 1.15, 0)),
        row(KITCHEN, "toaster", new On("kitchenFurniture", -1.3, 0.1, 0, 1.0)),
        row(KITCHEN, "mixer", new On("kitchenFurniture", -0.85, 0.1, 0, 1.0)),
        row(KITCHEN, "saucepan", new On("kitchenFurniture", 0.3, 0.1, 0, 1.0)),
        row(KITCHEN, "teapot", new On("kitchenFurniture", 0.75, 0.1, 0, 1.0)),
        row(KITCHEN, "glasses", new On("kitchenFurniture", 1.3, 0.1, 0, 1.0)),
        row(KITCHEN, "plates", new On("kitchenTable", -0.35, 0, 0, 1.0)),
        row(KITCHEN, "hamburger", new On("kitchenTable", 0.1, 0.2, 0, 1.0)),
        row(KITCHEN, "fruits", new On("kitchenTable", 0.4, -0.1, 0, 1.0)),
        row(KITCHEN, "saltcellar", new On("kitchenTable", 0.1, -0.15, 0, 1.0)),
        row(KITCHEN, "spoons", new On("kitchenTable", -0.05, -0.25, 0, 1.0)));
  }

  private static List<Placement> lounge() {
    return List.of(
        row(LOUNGE, "sofa1", new Against(Side.SOUTH, -6.4, 0.05)),
        row(LOUNGE, "sofa2", new Against(Side.WEST, 0.9, 0.05)),
        row(LOUNGE, "sofa1Pillow", new On("sofa1", -0.6, 0, 0, 1.2)),
        row(LOUNGE, "sofa2Pillow", new On("sofa2", 0.6, 0, 0, 1.2)),
        row(LOUNGE, "loungeTable", new Floor(-6.5, 1.1, 0)),
        row(LOUNGE, "biblioteca", new Against(Side.EAST, 0.6, 0)),
        row(LOUNGE, "tv", new On("biblioteca", 0, 0, 0, 1.2)),
        row(LOUNGE, "loungeBooks", new On("biblioteca", -0.8, 0, 0, 1.2)),
        row(LOUNGE, "speakers", new On("biblioteca", 0.8, 0, 0, 1.2)),
        row(LOUNGE, "ashTray", new On("loungeTable", 0.1, 0.15, 0, 1.0)),
        row(LOUNGE, "cigaretteSet", new On("loungeTable", 0.3, 0.2, 20, 1.0)),
        row(LOUNGE, "candle", new On("loungeTable", -0.1, -0.1, 0, 1.0)),
        row(LOUNGE, "glass", new On("loungeTable", 0.35, -0.1, 0, 1.0)),
        row(LOUNGE, "wine", new On("loungeTable", 0.2, -0.2, 0, 1.0)),
        row(LOUNGE, "vase", new On("loungeTable", -0.4, -0.1, 0, 1.0)),
        row(LOUNGE, "keys", new On("loungeTable", -0.15, 0.2, 30, 1.0)),
        row(LOUNGE, "magazine", new On("loungeTable", -0.38, 0.17, 15, 1.0)),
        row(LOUNGE, "mobile", new On("sofa1", 0.3, 0.1, 10, 1.2)),
        row(LOUNGE, "remoteControl", new On("sofa2", 0.0, 0.1, -15, 1.2)));
  }

  private static List<Placement> office() {
    return List.of(
        row(OFFICE, "desk", new Against(Side.EAST, 0.77, 0.05)),
        row(OFFICE, "bookcase", new Against(Side.WEST, -1.1, 0)),
        row(OFFICE, "computerSet", new On("desk", 0, -0.05, 0, 1.0)),
        row(OFFICE, "deskLamp", new On("desk", 0.65, -0.2, 0, 1.0)),
        row(OFFICE, "pencilHolderDesk", new On("desk", -0.5, -0.1, 0, 1.0)),
        row(OFFICE, "selotape", new On("desk", -0.5, 0.2, 30, 1.0)),
        row(OFFICE, "cd", new On("desk", 0.5, 0.2, -20, 1.0)),
        row(OFFICE, "ruler", new On("desk", -0.6, 0.05, 80, 1.0)),
        row(OFFICE, "trashCan", new Floor(8.4, -0.4, 0)),
        row(OFFICE, "plant", new Floor(8.3, 2.2, 0)),
        row(OFFICE, "clock", new Hung(Side.EAST, 0.77, 1.7)),
        row(OFFICE, "fireExtinguisher", new Hung(Side.SOUTH, 5.6, 0.9)),
        row(OFFICE, "libraryBooks", new On("bookcase", 0, 0, 0, 2.0)),
        row(OFFICE, "printer", new On("bookcase", -0.6, 0, 0, 2.0)),
        row(OFFICE, "laptop", new On("bookcase", 0.6, 0, 0, 2.0)),
        row(OFFICE, "mug", new On("bookcase", -0.6, 0, 0, 2.0)),
        row(OFFICE, "libraryMouse", new On("bookcase", 0.25, 0, 0, 2.0)),
        row(OFFICE, "telephoneLibrary", new On("bookcase", 0, 0, 0, 2.0)),
        row(OFFICE, "libraryPencilHolder", new On("bookcase", 0.5, 0, 0, 2.0)));
  }

  private static Placement row(Room room, String object, Place place) {
    return new Placement(room, object, place);
  }
}
