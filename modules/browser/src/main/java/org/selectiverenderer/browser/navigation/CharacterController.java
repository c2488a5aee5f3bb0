package org.selectiverenderer.browser.navigation;

import java.util.OptionalDouble;
import java.util.Set;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.CandidateTriangles;
import org.selectiverenderer.browser.collision.CollisionResponse;
import org.selectiverenderer.browser.collision.CollisionWorld;
import org.selectiverenderer.browser.collision.PlacedMesh;
import org.selectiverenderer.browser.collision.WallObstacleSet;

/**
 * The character controller of WALK (X3D 4.0, 23.2.4): moves a body that is stopped by walls, climbs
 * steps and falls under gravity; over a void without ground it does not fall. All lengths are in
 * world units; all coordinates are those of a frame whose +Y is up.
 */
final class CharacterController {
  /** Gravitational acceleration in metres per second squared. */
  static final double GRAVITY = 9.81;

  /** Slope (height per distance) of the steepest walkable ground. */
  private static final double SLOPE = Math.tan(Math.acos(WallObstacleSet.WALKABLE));

  private final CollisionWorld colliders;
  private final CandidateTriangles triangles = new CandidateTriangles();
  private double fallSpeed;
  private boolean grounded;

  CharacterController(CollisionWorld colliders) {
    this.colliders = colliders;
  }

  /** Resets the state after the body was placed elsewhere: it neither stands nor falls. */
  void landAnew() {
    fallSpeed = 0;
    grounded = false;
  }

  /**
   * The dimensions of a body.
   *
   * @param up the rotation from the frame to the world
   * @param gravity the gravitational acceleration in world units per second squared
   */
  record Body(Quaterniondc up, double radius, double height, double step, double gravity) {
    /** Returns the tolerance above the step height. */
    double ledge() {
      return step + 1e-4 * height;
    }

    /**
     * Returns the height of the body above the eye: half the radius, which is the distance of the
     * near plane (23.4.4).
     */
    double crown() {
      return radius / 2;
    }
  }

  /**
   * Moves the body by one step.
   *
   * @param eye the eye position, changed in place
   * @param by the horizontal step, shorter than the radius
   * @param dt the duration in seconds
   * @param walls whether walls stop the body
   * @param bumped receives the meshes that stopped the body
   */
  void step(
      Body body, Vector3d eye, Vector3dc by, double dt, boolean walls, Set<PlacedMesh> bumped) {
    double distance = by.length();
    Vector3d before = new Vector3d(eye);
    if (distance > 0) {
      eye.set(walls ? slide(body, eye, by, distance, bumped) : eye.add(by, new Vector3d()));
    }
    if (!settle(body, eye, distance, dt, walls)) {
      eye.set(before);
      settle(body, eye, 0, dt, walls);
    }
  }

  private Vector3d slide(
      Body body, Vector3dc eye, Vector3dc by, double distance, Set<PlacedMesh> bumped) {
    double reach = body.radius + 2 * distance;
    double low = eye.y() - body.height + body.ledge();
    double high = eye.y() + body.crown();
    double[] box = {eye.x() - reach, low, eye.z() - reach, eye.x() + reach, high, eye.z() + reach};
    colliders.gather(body.up, box, triangles);
    WallObstacleSet barrier = new WallObstacleSet(triangles, eye, low, high, bumped);
    return CollisionResponse.step(eye, by, body.radius, distance / 2, barrier);
  }

  /**
   * Puts the body onto the ground or lets it fall; returns false if there is no room to step up.
   */
  private boolean settle(Body body, Vector3d eye, double distance, double dt, boolean walls) {
    double feet = eye.y - body.height;
    double climb = body.ledge() + SLOPE * distance;
    // A body that was just placed here may be in the ground up to its eyes.
    double from = grounded ? Math.min(body.height, climb) : body.height;
    OptionalDouble below =
        ray(body, new Vector3d(eye.x, feet + from, eye.z), -1, Double.POSITIVE_INFINITY);
    if (below.isEmpty()) {
      fallSpeed = 0;
      return true;
    }
    double drop = below.getAsDouble() - from;
    if (drop <= 0) {
      return stepUp(body, eye, -drop, walls);
    }
    if (grounded && drop <= SLOPE * distance + 1e-6 * body.height) {
      eye.y -= drop;
      return true;
    }
    double fall = fallSpeed * dt + body.gravity * dt * dt / 2;
    fallSpeed += body.gravity * dt;
    grounded = fall >= drop;
    eye.y -= Math.min(fall, drop);
    if (grounded) {
      fallSpeed = 0;
    }
    return true;
  }

  private boolean stepUp(Body body, Vector3d eye, double rise, boolean walls) {
    boolean higher = rise > 1e-6 * body.height;
    if (walls && grounded && higher && ray(body, eye, 1, rise + body.crown()).isPresent()) {
      return false;
    }
    eye.y += rise;
    fallSpeed = 0;
    grounded = true;
    return true;
  }

  /** Returns the distance to the next surface straight up (1) or down (-1). */
  private OptionalDouble ray(Body body, Vector3dc from, int up, double limit) {
    return colliders.distance(
        body.up.transform(from, new Vector3d()), body.up.transform(new Vector3d(0, up, 0)), limit);
  }
}
