package org.selectiverenderer.apartment.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.selectiverenderer.modelling.Bounds;
import org.selectiverenderer.modelling.Degrees;
import org.selectiverenderer.modelling.Model;

/** Turns places as one says them into numbers, from the objects' own measures. */
public final class Layout {
  private final Function<String, Model> models;
  private final Map<String, Placement> placements = new LinkedHashMap<>();
  private final Map<String, Placed> placed = new LinkedHashMap<>();

  private Layout(List<Placement> all, Function<String, Model> models) {
    this.models = models;
    for (Placement placement : all) {
      if (placements.put(placement.object(), placement) != null) {
        throw new IllegalArgumentException(placement.object() + " stands in two places");
      }
    }
  }

  /**
   * The objects where they stand, in the order of the placements.
   *
   * @throws IllegalArgumentException if an object stands on one that is not there, or misses it
   */
  public static List<Placed> of(List<Placement> placements, Function<String, Model> models) {
    Layout layout = new Layout(placements, models);
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
      return new Placed(placement, model, floor.x(), -b.minY(), floor.z(), floor.yaw());
    }
    if (place instanceof Place.Against against) {
      return wall(placement, model, against.side(), against.along(), -b.minY(), against.gap());
    }
    if (place instanceof Place.Hung hung) {
      return wall(placement, model, hung.side(), hung.along(), hung.height() - b.minY(), 0);
    }
    return on(placement, model, (Place.On) place);
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
    double height =
        Landing.height(above.mesh(), support.mesh(), on.from())
            .orElseThrow(
                () -> new IllegalArgumentException(placement.object() + " misses " + on.support()));
    return new Placed(placement, model, x, height - model.bounds().minY(), z, above.yaw());
  }
}
