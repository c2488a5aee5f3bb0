package org.selectiverenderer.app.headset;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.app.head.SceneMapBuilder;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.study.headlog.SceneMap;

/** Teleports the user of a headset to the centre of the room that the user looks at. */
public final class RoomTeleport {
  /**
   * The share of the line of sight by which the point before the seen surface is nearer than the
   * surface.
   */
  private static final double BEFORE = 0.01;

  private RoomTeleport() {}

  /**
   * Moves the viewer so that the head is above the centre of the room in which the line of sight
   * ends; if it ends in no room, of the room that the viewer is in.
   *
   * @return the room's name; empty where there is no such room, and nothing is moved
   */
  public static Optional<String> go(World world) {
    Vector3dc head = world.viewer().position();
    List<SceneMap.Box> rooms = SceneMapBuilder.of(world.instances()).rooms();
    Optional<SceneMap.Box> here = around(rooms, head);
    Optional<SceneMap.Box> to =
        looked(world, head).flatMap(point -> around(rooms, point)).or(() -> here);
    to.ifPresent(room -> move(world, room, here));
    return to.map(SceneMap.Box::name);
  }

  private static Optional<Vector3d> looked(World world, Vector3dc head) {
    Vector3d direction = world.viewer().orientation().transform(new Vector3d(0, 0, -1));
    return new RayCaster(world.instances(), world.meshes())
        .cast(head, direction, Double.POSITIVE_INFINITY)
        .map(hit -> new Vector3d(direction).mul(hit.distance() * (1 - BEFORE)).add(head));
  }

  private static Optional<SceneMap.Box> around(List<SceneMap.Box> rooms, Vector3dc point) {
    return rooms.stream()
        .filter(room -> room.contains(point.x(), point.y(), point.z()))
        .findFirst();
  }

  private static void move(World world, SceneMap.Box to, Optional<SceneMap.Box> from) {
    double[] box = to.bounds();
    double rise = from.map(room -> box[1] - room.bounds()[1]).orElse(0.0);
    Vector3dc head = world.viewer().position();
    world
        .viewer()
        .moveTo(new Vector3d((box[0] + box[3]) / 2, head.y() + rise, (box[2] + box[5]) / 2));
  }
}
