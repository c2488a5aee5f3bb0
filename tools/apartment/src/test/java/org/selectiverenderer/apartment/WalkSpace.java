package org.selectiverenderer.apartment;

import java.util.List;
import org.selectiverenderer.apartment.plan.Footprint;
import org.selectiverenderer.apartment.plan.PlacedObject;
import org.selectiverenderer.apartment.plan.Room;

/** Where a person can walk: in rooms and doorways, apart from furniture. */
final class WalkSpace {
  private static final double SHOULDER = 0.2;

  private WalkSpace() {}

  static boolean isFree(double x, double z, List<PlacedObject> placed) {
    return (inRoom(x, z) || inDoorway(x, z)) && placed.stream().allMatch(p -> apart(x, z, p));
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

  private static boolean apart(double x, double z, PlacedObject placed) {
    Footprint box = new Footprint(placed);
    double dx = Math.max(box.reach(true)[0] - x, x - box.reach(true)[1]);
    double dz = Math.max(box.reach(false)[0] - z, z - box.reach(false)[1]);
    return box.top() < 0.03 || box.bottom() > 1.5 || Math.max(dx, dz) > SHOULDER;
  }
}
