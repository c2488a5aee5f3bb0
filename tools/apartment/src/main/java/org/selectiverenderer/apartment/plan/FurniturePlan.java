package org.selectiverenderer.apartment.plan;

import static org.selectiverenderer.apartment.plan.Room.KITCHEN;
import static org.selectiverenderer.apartment.plan.Room.LOUNGE;
import static org.selectiverenderer.apartment.plan.Room.OFFICE;

import java.util.List;
import java.util.stream.Stream;
import org.selectiverenderer.apartment.plan.RoomPosition.Against;
import org.selectiverenderer.apartment.plan.RoomPosition.Ceiling;
import org.selectiverenderer.apartment.plan.RoomPosition.Floor;
import org.selectiverenderer.apartment.plan.RoomPosition.Hung;
import org.selectiverenderer.apartment.plan.RoomPosition.On;

/** The furniture plan: one row per object with its position. */
public final class FurniturePlan {

  private FurniturePlan() {}

  public static List<PlannedObject> all() {
    return Stream.of(kitchen(), lounge(), office()).flatMap(List::stream).toList();
  }

  private static List<PlannedObject> kitchen() {
    return List.of(
        row(KITCHEN, "kitchenFurniture", new Against(WallSide.EAST, -0.9, 0)),
        row(KITCHEN, "kitchenTable", new Floor(-0.95, 1.2, 0)),
        row(KITCHEN, "toaster", new On("kitchenFurniture", -1.2, 0.06, 12, 1.0)),
        row(KITCHEN, "mixer", new On("kitchenFurniture", 1.2, 0.04, -20, 1.0)),
        row(KITCHEN, "plates", new On("kitchenFurniture", 0.16, 0.1, 0, 1.0)),
        row(KITCHEN, "saucepan", new On("kitchenFurniture", 0.45, -0.1, -30, 1.0)),
        row(KITCHEN, "teapot", new On("kitchenTable", -0.45, 0.17, 160, 1.0)),
        row(KITCHEN, "glasses", new On("kitchenTable", 0.1, -0.25, 0, 1.0)),
        row(KITCHEN, "hamburger", new On("kitchenTable", 0.05, 0.2, 0, 1.0)),
        row(KITCHEN, "fruits", new On("kitchenTable", 0.45, -0.08, 0, 1.0)),
        row(KITCHEN, "saltcellar", new On("kitchenTable", -0.13, -0.05, 0, 1.0)),
        row(KITCHEN, "spoons", new On("kitchenTable", 0.4, 0.26, 10, 1.0)),
        row(KITCHEN, "refrigerator", new Against(WallSide.EAST, 0.95, 0.02)),
        row(KITCHEN, "kitchenChair", new Floor(-0.55, 0.62, 8)),
        again(KITCHEN, "kitchenChair", 2, new Floor(-1.35, 1.85, 172)),
        again(KITCHEN, "kitchenChair", 3, new Floor(-0.5, 1.9, 195)),
        row(KITCHEN, "fryingPan", new On("kitchenFurniture", 0.72, 0.1, 0, 1.0)),
        row(KITCHEN, "kitchenRoll", new On("kitchenFurniture", -0.98, -0.14, 0, 1.0)),
        row(KITCHEN, "shovel", new Against(WallSide.WEST, -1.3, 0.005)),
        row(KITCHEN, "kite", new Against(WallSide.SOUTH, -1.6, 0.005)),
        row(KITCHEN, "bicycleWheel", new Against(WallSide.WEST, -0.3, 0.02)),
        row(KITCHEN, "baseballBat", new Floor(-1.5, 0.2, 75)),
        row(KITCHEN, "hairDryer", new On("kitchenTable", -0.42, -0.2, 0, 1.0)),
        row(KITCHEN, "violin", new Floor(0.1, -2.6, 35)),
        again(KITCHEN, "kitchenChair", 4, new Floor(-1.3, 0.6, -6)),
        row(KITCHEN, "larder", new Against(WallSide.EAST, -2.77, 0)),
        row(KITCHEN, "bench", new Against(WallSide.NORTH, -0.67, 0.01)),
        row(KITCHEN, "kitchenBlind", new Hung(WallSide.NORTH, -0.1, 1.57)),
        row(KITCHEN, "kitchenRug", new Floor(1.1, -0.9, 90)));
  }

  private static List<PlannedObject> lounge() {
    return List.of(
        row(LOUNGE, "sofa1", new Against(WallSide.SOUTH, -6.35, 0.05)),
        row(LOUNGE, "sofa2", new Against(WallSide.WEST, 0.95, 0.05)),
        row(LOUNGE, "sofa1Pillow", new On("sofa1", -0.62, 0.06, 12, 0.7)),
        row(LOUNGE, "sofa2Pillow", new On("sofa2", 0.45, 0.06, -10, 0.7)),
        row(LOUNGE, "carpet", new Floor(-6.3, 1.22, 0)),
        row(LOUNGE, "loungeTable", new On("carpet", 0, 0, 0, 0.3)),
        row(LOUNGE, "ashTray", new On("loungeTable", 0.12, 0.2, 0, 1.0)),
        row(LOUNGE, "cigaretteSet", new On("loungeTable", 0.28, 0.22, 20, 1.0)),
        row(LOUNGE, "candle", new On("loungeTable", 0, -0.05, 0, 1.0)),
        row(LOUNGE, "glass", new On("loungeTable", 0.42, 0.05, 0, 1.0)),
        row(LOUNGE, "wine", new On("loungeTable", 0.3, -0.15, 0, 1.0)),
        row(LOUNGE, "vase", new On("loungeTable", -0.42, -0.18, 0, 1.0)),
        row(LOUNGE, "keys", new On("loungeTable", -0.08, 0.24, 30, 1.0)),
        row(LOUNGE, "magazine", new On("loungeTable", -0.34, 0.14, 12, 1.0)),
        row(LOUNGE, "mobile", new On("sofa1", 0.25, 0.15, 25, 0.8)),
        row(LOUNGE, "remoteControl", new On("sofa2", -0.2, 0.15, -15, 0.8)),
        row(LOUNGE, "biblioteca", new Against(WallSide.EAST, 0.9, 0)),
        row(LOUNGE, "tv", new On("biblioteca", 0, 0, 0, 1.0)),
        row(LOUNGE, "speakers", new On("biblioteca", 0, 0.03, 0, 1.0)),
        row(LOUNGE, "loungeBooks", new On("biblioteca", 1.1, 0, 0, 0.7)),
        row(LOUNGE, "floorLamp", new Floor(-8.2, 2.55, 0)),
        row(LOUNGE, "painting", new Hung(WallSide.NORTH, -6.2, 1.25)),
        row(LOUNGE, "barrel", new Floor(-8.35, -2.8, 0)),
        row(LOUNGE, "hammer", new On("barrel", 0, 0, 30, 1.0)),
        row(LOUNGE, "basketball", new Floor(-3.2, -1.3, 0)),
        row(LOUNGE, "pumpkin", new Floor(-2.55, -0.75, -60)),
        row(LOUNGE, "sideboard", new Against(WallSide.NORTH, -6.2, 0.02)),
        row(LOUNGE, "bowl", new On("sideboard", 0.5, 0, 0, 1.0)),
        row(LOUNGE, "displayCabinet", new Against(WallSide.WEST, -1.7, 0.02)),
        row(LOUNGE, "chest", new Against(WallSide.EAST, 2.7, 0.03)),
        row(LOUNGE, "pouf", new Floor(-4.45, 2.2, 0)),
        row(LOUNGE, "wideCurtains", new Hung(WallSide.WEST, 0.9, 0.03)),
        row(LOUNGE, "narrowCurtains", new Hung(WallSide.SOUTH, -4.0, 0.03)),
        row(LOUNGE, "pendantLamp", new Ceiling(-6.3, 1.22)));
  }

  private static List<PlannedObject> office() {
    return List.of(
        row(OFFICE, "desk", new Against(WallSide.EAST, 0.77, 0.02)),
        row(OFFICE, "computerSet", new On("desk", 0, -0.03, 0, 1.0)),
        row(OFFICE, "deskLamp", new On("desk", 0.63, -0.19, 90, 1.0)),
        row(OFFICE, "pencilHolderDesk", new On("desk", -0.72, 0.2, 0, 1.0)),
        row(OFFICE, "selotape", new On("desk", -0.62, 0.09, 8, 1.0)),
        row(OFFICE, "ruler", new On("desk", -0.62, 0.33, 3, 1.0)),
        row(OFFICE, "cd", new On("desk", 0.62, 0.1, 0, 1.0)),
        row(OFFICE, "trashCan", new Floor(8.35, -0.35, 0)),
        row(OFFICE, "plant", new Floor(8.15, 2.55, 0)),
        row(OFFICE, "clock", new Hung(WallSide.EAST, 0.77, 1.6)),
        row(OFFICE, "fireExtinguisher", new Hung(WallSide.EAST, -0.85, 0.85)),
        row(OFFICE, "bookcase", new Against(WallSide.WEST, -1.1, 0)),
        row(OFFICE, "libraryBooks", new On("bookcase", 0, 0, 0, 0.3)),
        row(OFFICE, "printer", new On("bookcase", -0.388, 0, 0, 1.0)),
        row(OFFICE, "laptop", new On("bookcase", 0.5, -0.006, 0, 1.0)),
        row(OFFICE, "libraryMouse", new On("bookcase", 0.2, 0.04, 10, 1.0)),
        row(OFFICE, "mug", new On("bookcase", -0.11, 0.03, 30, 1.3)),
        row(OFFICE, "telephoneLibrary", new On("bookcase", 0.45, 0.02, 0, 1.3)),
        row(OFFICE, "libraryPencilHolder", new On("bookcase", 0.15, 0.02, 0, 1.3)),
        row(OFFICE, "deskChair", new Floor(7.2, 0.85, 75)),
        row(OFFICE, "folders", new On("bookcase", -0.55, -0.005, 0, 0.6)),
        row(OFFICE, "letterTray", new On("desk", -0.63, -0.2, 0, 1.0)),
        row(OFFICE, "notepad", new On("desk", 0.54, 0.29, 0, 1.0)),
        row(OFFICE, "stapler", new On("desk", 0.71, 0.28, 0, 1.0)),
        row(OFFICE, "poster", new Hung(WallSide.SOUTH, 6.6, 1.2)),
        row(OFFICE, "trumpet", new Floor(4.0, -2.85, 30)),
        row(OFFICE, "credenza", new Against(WallSide.WEST, 0.95, 0.02)),
        row(OFFICE, "whiteboard", new Hung(WallSide.WEST, 0.95, 1.05)),
        row(OFFICE, "pinboard", new Hung(WallSide.NORTH, 4.1, 1.15)),
        row(OFFICE, "filingCabinet", new Against(WallSide.EAST, -2.85, 0.02)),
        row(OFFICE, "meetingTable", new Floor(7.35, -1.95, 0)),
        row(OFFICE, "visitorChair", new Floor(7.25, -2.68, 6)),
        again(OFFICE, "visitorChair", 2, new Floor(8.13, -1.75, -104)),
        row(OFFICE, "officeRug", new Floor(4.75, -0.95, 0)),
        row(OFFICE, "rollerBlind", new Hung(WallSide.NORTH, 6.6, 1.61)));
  }

  private static PlannedObject row(Room room, String object, RoomPosition place) {
    return new PlannedObject(room, object, 1, place);
  }

  private static PlannedObject again(Room room, String object, int number, RoomPosition place) {
    return new PlannedObject(room, object, number, place);
  }
}
