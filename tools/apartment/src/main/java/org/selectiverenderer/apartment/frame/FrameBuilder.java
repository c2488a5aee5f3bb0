package org.selectiverenderer.apartment.frame;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.apartment.plan.Room;
import org.selectiverenderer.apartment.plan.Side;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

/** Builds the frame model of a room; meshes added under one name become one part. */
final class FrameBuilder {
  private final Room room;
  private final List<Opening> openings;
  private final Map<String, Look> looks = new LinkedHashMap<>();
  private final Map<String, List<TriangleMesh>> meshes = new LinkedHashMap<>();

  FrameBuilder(Room room, List<Opening> openings, Look wall, boolean bare) {
    this.room = room;
    this.openings = openings;
    Walls walls = new Walls(room, openings, bare);
    add("walls", wall, walls.walls());
    add("ceiling", Finish.CEILING, Floors.ceiling(room, bare));
    add("trim", Finish.TRIM, walls.skirting());
    for (Opening opening : openings) {
      if (opening.isDoor()) {
        add("trim", Finish.TRIM, new DoorParts(room, opening).trim());
      } else {
        RoomWindow window = new RoomWindow(room, opening);
        add("trim", Finish.TRIM, window.frame());
        add("steel", Finish.STEEL, window.handle());
      }
    }
  }

  void add(String name, Look look, TriangleMesh mesh) {
    looks.putIfAbsent(name, look);
    meshes.computeIfAbsent(name, key -> new ArrayList<>()).add(mesh);
  }

  void floor(Look look) {
    add("floor", look, Floors.floor(room));
  }

  void shutDoor(Opening opening) {
    DoorParts door = new DoorParts(room, opening);
    add("doors", Finish.DOOR, door.shutLeaf());
    add("steel", Finish.STEEL, door.shutHandle());
  }

  void openDoor(Opening opening, boolean hingesLeft, double degrees) {
    DoorParts door = new DoorParts(room, opening);
    add("doors", Finish.DOOR, door.openLeaf(hingesLeft, degrees));
    add("steel", Finish.STEEL, door.openHandle(hingesLeft, degrees));
  }

  void lightSwitch(Side side, double along) {
    add("plastic", Finish.PLASTIC, Fittings.lightSwitch(room, side, along));
  }

  void radiator(Side side, double along, int columns) {
    add("plastic", Finish.PLASTIC, Fittings.radiator(room, side, along, columns));
  }

  void hangingLamp(double x, double z, double length, int segments, Look shade) {
    add("cords", Finish.STEEL, Fittings.cord(x, z, length));
    add("shades", shade, Fittings.shade(x, z, length, segments));
    add("bulbs", Finish.LIGHT, Fittings.bulb(x, z, length));
  }

  /**
   * Returns the model of all parts; glass comes last, since it is blended over what lies behind it.
   */
  ParametricModel model(String name) {
    for (Opening opening : openings) {
      if (!opening.isDoor()) {
        add("glass", Finish.GLASS, new RoomWindow(room, opening).glass());
      }
    }
    List<Part> parts = new ArrayList<>();
    meshes.forEach(
        (part, all) -> {
          Part made = Part.of(part, looks.getOrDefault(part, Finish.TRIM), TriangleMesh.of(all));
          parts.add(part.equals("glass") ? made : made.oneSided());
        });
    return new ParametricModel(name, parts);
  }
}
