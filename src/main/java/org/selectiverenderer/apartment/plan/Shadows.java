package org.selectiverenderer.apartment.plan;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Which objects darken the floor below them. */
public final class Shadows {
  /** What lies flat casts none, and what stands on it stands on the floor. */
  private static final double FLAT = 0.05;

  private Shadows() {}

  /** The objects on the floor, or on a carpet, that are not flat themselves. */
  public static List<Placed> of(List<Placed> placed) {
    Map<String, Placed> byName = new HashMap<>();
    placed.forEach(object -> byName.put(object.object(), object));
    return placed.stream()
        .filter(object -> !isFlat(object) && (onFloor(object) || onCarpet(object, byName)))
        .toList();
  }

  private static boolean onFloor(Placed object) {
    return object.placement().place() instanceof Place.Floor
        || object.placement().place() instanceof Place.Against;
  }

  private static boolean onCarpet(Placed object, Map<String, Placed> byName) {
    if (!(object.placement().place() instanceof Place.On on)) {
      return false;
    }
    Placed support = byName.get(on.support());
    return support != null && onFloor(support) && isFlat(support);
  }

  private static boolean isFlat(Placed object) {
    return object.box().height() < FLAT;
  }
}
