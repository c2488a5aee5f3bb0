package org.selectiverenderer.apartment;

import java.util.List;
import org.selectiverenderer.apartment.plan.Footprint;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.apartment.plan.Room;

/** Where a person can walk: in rooms and doorways, apart from furniture. */
final class WalkableArea {
  private static final double SHOULDER = 0.2;

  private final List<Shadow> furniture;

  WalkableArea(List<PlacedObject> placed) {
    furniture =
        placed.stream()
            .map(Footprint::new)
            .filter(box -> box.top() >= 0.03 && box.bottom() <= 1.5)
            .map(box -> new Shadow(box.reach(true), box.reach(false)))
            .toList();
  }

  boolean isFree(double x, double z) {
    return (inRoom(x, z) || inDoorway(x, z))
        && furniture.stream().allMatch(shadow -> shadow.apart(x, z));
  }

  private static boolean inRoom(double x, double z) {
    for (Room room : Room.values()) {
      if (x > room.west() + SHOULDER
          && x < room.east() - SHOULDER
          && z > Room.NORTH + SHOULDER
          && z < Room.SOUTH - SHOULDER) {
        return true;
      }
    }
    return false;
  }

  private static boolean inDoorway(double x, double z) {
    boolean westDoor = x > -2.5 && x < -1.8 && Math.abs(z + 2.72) < 0.43 - SHOULDER;
    boolean eastDoor = x > 1.9 && x < 2.6 && Math.abs(z - 2.72) < 0.43 - SHOULDER;
    return westDoor || eastDoor;
  }

  /** What a piece of furniture covers of the floor: lowest and highest x, and z. */
  private record Shadow(double[] x, double[] z) {
    boolean apart(double eyeX, double eyeZ) {
      double dx = Math.max(x[0] - eyeX, eyeX - x[1]);
      double dz = Math.max(z[0] - eyeZ, eyeZ - z[1]);
      return Math.max(dx, dz) > SHOULDER;
    }
  }
}
