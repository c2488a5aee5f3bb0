package org.selectiverenderer.apartment.building;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.WallSide;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * Builds the frame models of the rooms. A door in the north leads from the lounge to the kitchen,
 * outside the sofa's area, and a door in the south from the kitchen to the office, outside the
 * areas of desk and bookcase.
 */
public final class RoomModels {
  private static final Opening LOUNGE_TO_KITCHEN = Opening.door(WallSide.EAST, -2.72);
  private static final Opening KITCHEN_TO_LOUNGE = Opening.door(WallSide.WEST, -2.72);
  private static final Opening KITCHEN_TO_OFFICE = Opening.door(WallSide.EAST, 2.72);
  private static final Opening OFFICE_TO_KITCHEN = Opening.door(WallSide.WEST, 2.72);
  private static final Opening ENTRANCE = Opening.door(WallSide.SOUTH, -0.6);

  private RoomModels() {}

  /** Returns the frame of a room, named {@code kitchenFrame} and so on. */
  public static ParametricModel of(Room room) {
    return of(room, false);
  }

  /**
   * Returns the frame with walls of plain rectangles, which radiosity subdivides evenly, so that
   * the rest of the room's polygons is used for the light on its surfaces.
   */
  public static ParametricModel bare(Room room) {
    return of(room, true);
  }

  private static ParametricModel of(Room room, boolean bare) {
    return switch (room) {
      case KITCHEN -> kitchen(bare);
      case LOUNGE -> lounge(bare);
      case OFFICE -> office(bare);
    };
  }

  private static ParametricModel kitchen(boolean bare) {
    Opening window = new Opening(WallSide.NORTH, -0.1, 1.5, 1.1, 1.1);
    RoomModelBuilder frame =
        new RoomModelBuilder(
            Room.KITCHEN,
            List.of(KITCHEN_TO_LOUNGE, KITCHEN_TO_OFFICE, ENTRANCE, window),
            RoomFinishes.wall(0.9, 0.84, 0.66),
            bare);
    frame.floor(RoomFinishes.tiles(Room.KITCHEN, 0.4, 0.40375));
    frame.openDoor(KITCHEN_TO_OFFICE, false, 90);
    frame.shutDoor(ENTRANCE);
    frame.lightSwitch(WallSide.WEST, -2.1);
    frame.lightSwitch(WallSide.EAST, 2.1);
    frame.lightSwitch(WallSide.SOUTH, 0.05);
    frame.hangingLamp(-0.95, 1.15, 0.75, 28, ModelMaterial.satin(ModelColour.of(0.72, 0.2, 0.14)));
    return frame.model("kitchenFrame");
  }

  private static ParametricModel lounge(boolean bare) {
    Opening west = new Opening(WallSide.WEST, 0.9, 2.2, 0.95, 1.3);
    Opening south = new Opening(WallSide.SOUTH, -4.0, 1.6, 0.95, 1.3);
    RoomModelBuilder frame =
        new RoomModelBuilder(
            Room.LOUNGE,
            List.of(LOUNGE_TO_KITCHEN, west, south),
            RoomFinishes.wall(0.74, 0.78, 0.66),
            bare);
    frame.floor(RoomFinishes.parquet(Room.LOUNGE));
    frame.openDoor(LOUNGE_TO_KITCHEN, true, 90);
    frame.lightSwitch(WallSide.EAST, -2.1);
    frame.radiator(WallSide.SOUTH, -4.0, 10);
    return frame.model("loungeFrame");
  }

  private static ParametricModel office(boolean bare) {
    Opening north = new Opening(WallSide.NORTH, 6.6, 1.9, 0.95, 1.3);
    RoomModelBuilder frame =
        new RoomModelBuilder(
            Room.OFFICE,
            List.of(OFFICE_TO_KITCHEN, north),
            RoomFinishes.wall(0.87, 0.8, 0.66),
            bare);
    frame.floor(RoomFinishes.parquet(Room.OFFICE));
    frame.lightSwitch(WallSide.WEST, 2.1);
    List<TriangleMesh> rims = new ArrayList<>();
    List<TriangleMesh> lights = new ArrayList<>();
    for (double x : new double[] {4.3, 6.9}) {
      rims.add(RoomFixtures.panelRim(x, 0));
      lights.add(RoomFixtures.panelLight(x, 0));
    }
    frame.add("lampRims", RoomFinishes.PLASTIC, TriangleMesh.of(rims));
    frame.add("lampLights", RoomFinishes.LIGHT, TriangleMesh.of(lights));
    frame.radiator(WallSide.NORTH, 6.6, 11);
    return frame.model("officeFrame");
  }
}
