package org.selectiverenderer.apartment.building;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.WallSide;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.BoxBuilder;
import org.selectiverenderer.modelling.ModelMaterial;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.ParametricSurface;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.SimplePolygon;
import org.selectiverenderer.modelling.Spine;
import org.selectiverenderer.modelling.Sweep;

/** Builds the frame model of a room; meshes added under one name become one part. */
final class RoomModelBuilder {
  private final Room room;
  private final List<Opening> openings;
  private final Map<String, ModelMaterial> looks = new LinkedHashMap<>();
  private final Map<String, List<TriangleMesh>> meshes = new LinkedHashMap<>();

  RoomModelBuilder(Room room, List<Opening> openings, ModelMaterial wall, boolean bare) {
    this.room = room;
    this.openings = openings;
    RoomWalls walls = new RoomWalls(room, openings, bare);
    add("walls", wall, walls.walls());
    add("ceiling", RoomFinishes.CEILING, FloorAndCeiling.ceiling(room, bare));
    add("trim", RoomFinishes.TRIM, walls.skirting());
    for (Opening opening : openings) {
      if (opening.isDoor()) {
        add("trim", RoomFinishes.TRIM, new DoorModel(room, opening).trim());
      } else {
        WindowModel window = new WindowModel(room, opening);
        add("trim", RoomFinishes.TRIM, window.frame());
        add("steel", RoomFinishes.STEEL, window.handle());
      }
    }
  }

  void add(String name, ModelMaterial look, TriangleMesh mesh) {
    looks.putIfAbsent(name, look);
    meshes.computeIfAbsent(name, key -> new ArrayList<>()).add(mesh);
  }

  void floor(ModelMaterial look) {
    add("floor", look, FloorAndCeiling.floor(room));
  }

  void shutDoor(Opening opening) {
    DoorModel door = new DoorModel(room, opening);
    add("doors", RoomFinishes.DOOR, door.shutLeaf());
    add("steel", RoomFinishes.STEEL, door.shutHandle());
  }

  void openDoor(Opening opening, boolean hingesLeft, double degrees) {
    DoorModel door = new DoorModel(room, opening);
    add("doors", RoomFinishes.DOOR, door.openLeaf(hingesLeft, degrees));
    add("steel", RoomFinishes.STEEL, door.openHandle(hingesLeft, degrees));
  }

  void lightSwitch(WallSide side, double along) {
    add("plastic", RoomFinishes.PLASTIC, RoomFixtures.lightSwitch(room, side, along));
  }

  void radiator(WallSide side, double along, int columns) {
    add("plastic", RoomFinishes.PLASTIC, RoomFixtures.radiator(room, side, along, columns));
  }

  void hangingLamp(double x, double z, double length, int segments, ModelMaterial shade) {
    add("cords", RoomFinishes.STEEL, RoomFixtures.cord(x, z, length));
    add("shades", shade, RoomFixtures.shade(x, z, length, segments));
    add("bulbs", RoomFinishes.LIGHT, RoomFixtures.bulb(x, z, length));
  }

  /**
   * Returns the model of all parts; glass comes last, since it is blended over what lies behind it.
   */
  ParametricModel model(String name) {
    for (Opening opening : openings) {
      if (!opening.isDoor()) {
        add("glass", RoomFinishes.GLASS, new WindowModel(room, opening).glass());
      }
    }
    List<Part> parts = new ArrayList<>();
    meshes.forEach(
        (part, all) -> {
          Part made =
              Part.of(part, looks.getOrDefault(part, RoomFinishes.TRIM), TriangleMesh.of(all));
          parts.add(part.equals("glass") ? made : made.oneSided());
        });
    return new ParametricModel(name, parts);
  }

  /** Builds floors and ceilings as flat rectangles. */
  private static final class FloorAndCeiling {
    /** Distance that the floor extends under the walls, to their middles, metres. */
    private static final double UNDER = 0.06;

    /** Overlap with the walls so that no crack shows, metres. */
    private static final double TOUCH = 0.002;

    private FloorAndCeiling() {}

    /** Returns the floor, two triangles; boards and tiles are a texture. */
    static TriangleMesh floor(Room room) {
      return rectangle(room.west() - UNDER, Room.NORTH, room.east() + UNDER, Room.SOUTH);
    }

    /**
     * Returns the ceiling, which faces down.
     *
     * @param bare whether it ends at the walls: the part inside of them is never visible and would
     *     take facets of the radiosity mesh
     */
    static TriangleMesh ceiling(Room room, boolean bare) {
      double over = bare ? TOUCH : UNDER;
      return rectangle(room.west() - over, Room.NORTH - over, room.east() + over, Room.SOUTH + over)
          .move(0, Room.CEILING, 0)
          .flip();
    }

    private static TriangleMesh rectangle(double west, double north, double east, double south) {
      return ParametricSurface.field(east - west, south - north, 1, 1, (x, z) -> 0)
          .move((west + east) / 2, 0, (north + south) / 2);
    }
  }

  /** The parts of a window with two casements in a wall opening. */
  private record WindowModel(Room room, Opening opening) {
    private static final double BAR = 0.05;

    /** Returns the frame, the mullion, a casement's frame on each side, and the sill. */
    TriangleMesh frame() {
      double wing = opening.width() / 2 - BAR;
      TriangleMesh outer = bars(opening.width(), opening.height(), 0.07);
      TriangleMesh left = bars(wing + BAR, opening.height() - BAR, 0.05).move(-wing / 2, 0, 0.02);
      TriangleMesh sill =
          BoxBuilder.plain(opening.width() + 0.16, 0.03, 0.26)
              .move(0, -opening.height() / 2 - 0.03, 0.17);
      return placed(TriangleMesh.of(outer, left, left.mirrorX(), sill));
    }

    /** Returns a catch on the mullion. */
    TriangleMesh handle() {
      TriangleMesh lever = BoxBuilder.plain(0.018, 0.12, 0.02).move(0, -0.1, 0.085);
      TriangleMesh plate = BoxBuilder.plain(0.03, 0.07, 0.03).move(0, -0.04, 0.06);
      return placed(plate.append(lever));
    }

    TriangleMesh glass() {
      TriangleMesh pane =
          ParametricSurface.field(opening.width() - BAR, opening.height() - BAR, 1, 1, (x, z) -> 0);
      return placed(pane.turnX(90).move(0, 0, 0.02));
    }

    private static TriangleMesh bars(double width, double height, double depth) {
      SimplePolygon section = SimplePolygon.rectangle(BAR, depth);
      return Sweep.of(section, Spine.of(SimplePolygon.rectangle(width - BAR, height - BAR)));
    }

    /**
     * Moves a mesh from coordinates about the middle of the opening, halfway into the wall, to the
     * room's coordinates.
     */
    private TriangleMesh placed(TriangleMesh mesh) {
      double x = (opening.left() + opening.right()) / 2;
      double y = opening.sill() + opening.height() / 2;
      return opening.side().place(room, mesh.move(x, y, -0.13));
    }
  }
}
