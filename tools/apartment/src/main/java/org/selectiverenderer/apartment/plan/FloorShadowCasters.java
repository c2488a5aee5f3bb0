package org.selectiverenderer.apartment.plan;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Selects the objects that cast a painted shadow on the floor. */
public final class FloorShadowCasters {
  /**
   * Height up to which an object is flat, metres: it casts no shadow, and objects that stand on it
   * count as standing on the floor.
   */
  private static final double FLAT = 0.05;

  private FloorShadowCasters() {}

  /** Returns the objects on the floor, or on a carpet, that are not flat themselves. */
  public static List<PlacedObject> of(List<PlacedObject> placed) {
    Map<String, PlacedObject> byName = new HashMap<>();
    placed.forEach(object -> byName.put(object.placement().name(), object));
    return placed.stream()
        .filter(object -> !isFlat(object) && (onFloor(object) || onCarpet(object, byName)))
        .toList();
  }

  private static boolean onFloor(PlacedObject object) {
    return object.placement().place() instanceof RoomPosition.Floor
        || object.placement().place() instanceof RoomPosition.Against;
  }

  private static boolean onCarpet(PlacedObject object, Map<String, PlacedObject> byName) {
    if (!(object.placement().place() instanceof RoomPosition.On on)) {
      return false;
    }
    PlacedObject support = byName.get(on.support());
    return support != null && onFloor(support) && isFlat(support);
  }

  private static boolean isFlat(PlacedObject object) {
    return object.box().height() < FLAT;
  }
}
