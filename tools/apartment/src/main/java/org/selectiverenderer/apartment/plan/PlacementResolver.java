package org.selectiverenderer.apartment.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.DegreeMath;
import org.selectiverenderer.geometry.mesh.TriangleMesh;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * Resolves the positions of a plan, such as against a wall or on another object, into coordinates
 * by the dimensions of the objects.
 */
public final class PlacementResolver {
  /** Height up to which parts of the room, such as a rug, can be stood on, metres. */
  private static final double RUG = 0.03;

  private final Function<String, ParametricModel> models;
  private final Function<Room, TriangleMesh> floors;
  private final Map<String, PlannedObject> placements = new LinkedHashMap<>();
  private final Map<String, PlacedObject> placed = new LinkedHashMap<>();

  private PlacementResolver(
      List<PlannedObject> all,
      Function<String, ParametricModel> models,
      Function<Room, TriangleMesh> floors) {
    this.models = models;
    this.floors = floors;
    for (PlannedObject placement : all) {
      if (placements.put(placement.name(), placement) != null) {
        throw new IllegalArgumentException(placement.name() + " has two positions");
      }
    }
  }

  /**
   * Returns the objects at their positions, in the order of the placements.
   *
   * @param floors the models of the rooms, with flat things on their floors
   * @throws IllegalArgumentException if an object stands on one that the plan does not have, or
   *     does not lie above it
   */
  public static List<PlacedObject> of(
      List<PlannedObject> placements,
      Function<String, ParametricModel> models,
      Function<Room, TriangleMesh> floors) {
    PlacementResolver layout = new PlacementResolver(placements, models, floors);
    List<PlacedObject> all = new ArrayList<>();
    for (PlannedObject placement : placements) {
      all.add(layout.place(placement));
    }
    return all;
  }

  private PlacedObject place(PlannedObject placement) {
    PlacedObject known = placed.get(placement.name());
    if (known == null) {
      known = find(placement);
      placed.put(placement.name(), known);
    }
    return known;
  }

  private PlacedObject find(PlannedObject placement) {
    ParametricModel model = models.apply(placement.object());
    BoundingBox b = model.bounds();
    RoomPosition place = placement.place();
    if (place instanceof RoomPosition.Floor floor) {
      return down(new PlacedObject(placement, model, floor.x(), 0, floor.z(), floor.yaw()));
    }
    if (place instanceof RoomPosition.Against against) {
      return down(wall(placement, model, against.side(), against.along(), 0, against.gap()));
    }
    if (place instanceof RoomPosition.Hung hung) {
      return wall(placement, model, hung.side(), hung.along(), hung.height() - b.minY(), 0);
    }
    if (place instanceof RoomPosition.Ceiling ceiling) {
      double y = Room.CEILING - b.maxY();
      return new PlacedObject(placement, model, ceiling.x(), y, ceiling.z(), 0);
    }
    return on(placement, model, (RoomPosition.On) place);
  }

  /** Lowers an object to the room's floor or to a flat thing on it. */
  private PlacedObject down(PlacedObject above) {
    TriangleMesh floor = floors.apply(above.placement().room());
    return land(above, floor, RUG, "the floor");
  }

  private static PlacedObject land(
      PlacedObject above, TriangleMesh support, double from, String name) {
    ParametricModel model = above.model();
    double height =
        RestingHeight.height(above.mesh(), support, from)
            .orElseThrow(
                () -> new IllegalArgumentException(above.object() + " does not lie above " + name));
    return new PlacedObject(
        above.placement(),
        model,
        above.x(),
        height - model.bounds().minY(),
        above.z(),
        above.yaw());
  }

  private static PlacedObject wall(
      PlannedObject placement,
      ParametricModel model,
      WallSide side,
      double along,
      double y,
      double gap) {
    double away = gap - model.bounds().minZ();
    double face = side.face(placement.room());
    double inwards = side == WallSide.NORTH || side == WallSide.WEST ? face + away : face - away;
    return side.alongX()
        ? new PlacedObject(placement, model, along, y, inwards, side.yaw())
        : new PlacedObject(placement, model, inwards, y, along, side.yaw());
  }

  private PlacedObject on(PlannedObject placement, ParametricModel model, RoomPosition.On on) {
    PlannedObject below = placements.get(on.support());
    if (below == null) {
      throw new IllegalArgumentException(
          placement.object() + " stands on " + on.support() + ", which the plan does not have");
    }
    PlacedObject support = place(below);
    double s = DegreeMath.sin(support.yaw());
    double c = DegreeMath.cos(support.yaw());
    double x = support.x() + c * on.x() + s * on.z();
    double z = support.z() + c * on.z() - s * on.x();
    PlacedObject above = new PlacedObject(placement, model, x, 0, z, support.yaw() + on.yaw());
    return land(above, support.mesh(), on.from(), on.support());
  }
}
