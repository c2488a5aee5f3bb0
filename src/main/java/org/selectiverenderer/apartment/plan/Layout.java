package org.selectiverenderer.apartment.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.selectiverenderer.modelling.Bounds;
import org.selectiverenderer.modelling.Degrees;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.TriangleMesh;

/** Turns places as one says them into numbers, from the objects' own measures. */
public final class Layout {
  /** Higher things of the room itself are not for standing on. */
  private static final double RUG = 0.03;

  private final Function<String, Model> models;
  private final Function<Room, TriangleMesh> floors;
  private final Map<String, Placement> placements = new LinkedHashMap<>();
  private final Map<String, Placed> placed = new LinkedHashMap<>();

  private Layout(
      List<Placement> all, Function<String, Model> models, Function<Room, TriangleMesh> floors) {
    this.models = models;
    this.floors = floors;
    for (Placement placement : all) {
      if (placements.put(placement.object(), placement) != null) {
        throw new IllegalArgumentException(placement.object() + " stands in two places");
      }
    }
  }

  /**
   * The objects where they stand, in the order of the placements.
   *
   * @param floors the rooms themselves, with what lies flat on their floors
   * @throws IllegalArgumentException if an object stands on one that is not there, or misses it
   */
  public static List<Placed> of(
      List<Placement> placements,
      Function<String, Model> models,
      Function<Room, TriangleMesh> floors) {
    Layout layout = new Layout(placements, models, floors);
    List<Placed> all = new ArrayList<>();
    for (Placement placement : placements) {
      all.add(layout.place(placement));
    }
    return all;
  }

  private Placed place(Placement placement) {
    Placed known = placed.get(placement.object());
    if (known == null) {
      known = find(placement);
      placed.put(placement.object(), known);
    }
    return known;
  }

  private Placed find(Placement placement) {
    Model model = models.apply(placement.object());
    Bounds b = model.bounds();
    Place place = placement.place();
    if (place instanceof Place.Floor floor) {
      return down(new Placed(placement, model, floor.x(), 0, floor.z(), floor.yaw()));
    }
    if (place instanceof Place.Against against) {
      return down(wall(placement, model, against.side(), against.along(), 0, against.gap()));
    }
    if (place instanceof Place.Hung hung) {
      return wall(placement, model, hung.side(), hung.along(), hung.height() - b.minY(), 0);
    }
    return on(placement, model, (Place.On) place);
  }

  /** Down to the room's floor or to what lies on it. */
  private Placed down(Placed above) {
    TriangleMesh floor = floors.apply(above.placement().room());
    return land(above, floor, RUG, "the floor");
  }

  private static Placed land(Placed above, TriangleMesh support, double from, String name) {
    Model model = above.model();
    double height =
        Landing.height(above.mesh(), support, from)
            .orElseThrow(() -> new IllegalArgumentException(above.object() + " misses " + name));
    return new Placed(
        above.placement(),
        model,
        above.x(),
        height - model.bounds().minY(),
        above.z(),
        above.yaw());
  }

  private static Placed wall(
      Placement placement, Model model, Side side, double along, double y, double gap) {
    double away = gap - model.bounds().minZ();
    double face = side.face(placement.room());
    double inwards = side == Side.NORTH || side == Side.WEST ? face + away : face - away;
    return side.alongX()
        ? new Placed(placement, model, along, y, inwards, side.yaw())
        : new Placed(placement, model, inwards, y, along, side.yaw());
  }

  private Placed on(Placement placement, Model model, Place.On on) {
    Placement below = placements.get(on.support());
    if (below == null) {
      throw new IllegalArgumentException(
          placement.object() + " stands on " + on.support() + ", which is not there");
    }
    Placed support = place(below);
    double s = Degrees.sin(support.yaw());
    double c = Degrees.cos(support.yaw());
    double x = support.x() + c * on.x() + s * on.z();
    double z = support.z() + c * on.z() - s * on.x();
    Placed above = new Placed(placement, model, x, 0, z, support.yaw() + on.yaw());
    return land(above, support.mesh(), on.from(), on.support());
  }
}
