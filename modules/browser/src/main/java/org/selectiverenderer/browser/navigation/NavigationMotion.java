package org.selectiverenderer.browser.navigation;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.CandidateTriangles;
import org.selectiverenderer.browser.collision.CollisionResponse;
import org.selectiverenderer.browser.collision.CollisionWorld;
import org.selectiverenderer.browser.collision.PlacedMesh;
import org.selectiverenderer.browser.collision.TriangleObstacleSet;
import org.selectiverenderer.browser.nodes.group.CollisionNode;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.browser.viewer.YawPitch;

/**
 * Moves the viewer by the user's input and the navigation type (X3D 4.0, 23.2.2 and 23.4.4).
 *
 * <p>WALK moves horizontally on the ground and is stopped by walls. FLY and EXPLORE move in the
 * viewing direction and are stopped by every surface. EXAMINE and LOOKAT orbit about {@link
 * #pivot(Vector3dc)} without collisions. NONE does not move. In all modes the view stays upright,
 * pitched at most 90 degrees either way.
 *
 * <p>A frame is divided into substeps of at most 1/60 s and half the collision distance, so that
 * neither a slow frame nor a fast viewer passes through a wall, and the path hardly depends on the
 * frame rate. The same input gives the same path. Belongs to the thread that steps the world.
 */
public final class NavigationMotion implements ViewerMotion {
  /** Largest duration of a substep in seconds. */
  private static final double PART = 1.0 / 60;

  /** Largest number of substeps in a frame; beyond it the viewer moves less far than requested. */
  private static final int MAX_PARTS = 2000;

  private final CollisionWorld colliders;
  private final MotionSource input;
  private final CharacterController walking;
  private final CandidateTriangles triangles = new CandidateTriangles();
  private final Set<PlacedMesh> bumped = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Vector3d lastEye = new Vector3d(Double.NaN);
  private final Vector3d pivot = new Vector3d();
  private NavigationParameters navigation = NavigationParameters.WALKING;
  private ViewpointFrame frame = ViewpointFrame.WORLD;
  private NavigationMode mode = NavigationMode.WALK;
  private boolean collisions = true;

  public NavigationMotion(CollisionWorld colliders, MotionSource input) {
    this.colliders = colliders;
    this.input = input;
    walking = new CharacterController(colliders);
  }

  /**
   * Uses the parameters of another NavigationInfo in its initial mode, scaled by a viewpoint's
   * coordinates.
   */
  public void use(NavigationParameters newNavigation, ViewpointFrame newFrame) {
    navigation = newNavigation;
    frame = newFrame;
    mode(newNavigation.initial());
  }

  /** Uses changed parameters of the NavigationInfo or viewpoint and keeps the mode. */
  public void adapt(NavigationParameters newNavigation, ViewpointFrame newFrame) {
    navigation = newNavigation;
    frame = newFrame;
  }

  public NavigationParameters navigation() {
    return navigation;
  }

  public NavigationMode mode() {
    return mode;
  }

  /** Changes the mode; ANY means WALK. The caller checks that the author allows it. */
  public void mode(NavigationMode newMode) {
    mode = newMode == NavigationMode.ANY ? NavigationMode.WALK : newMode;
    walking.landAnew();
  }

  /** Sets whether walls stop the viewer. In WALK the viewer stays on the ground in any case. */
  public void collisions(boolean on) {
    collisions = on;
  }

  public boolean collisions() {
    return collisions;
  }

  /**
   * Sets the point that EXAMINE orbits about, in the world: the viewpoint's centerOfRotation or the
   * centre of the framed box.
   */
  public void pivot(Vector3dc point) {
    pivot.set(point);
  }

  /**
   * Returns the Collision nodes with which the viewer collided in the last move, for their events.
   */
  public Set<CollisionNode> bumped() {
    Set<CollisionNode> nodes = new LinkedHashSet<>();
    bumped.forEach(placed -> nodes.addAll(placed.collisions()));
    return nodes;
  }

  @Override
  public void move(Viewer viewer, double time, double dt) {
    MotionRequest motion = input.next(dt);
    bumped.clear();
    if (mode == NavigationMode.NONE) {
      return;
    }
    Quaterniond toFrame = frame.upright().conjugate(new Quaterniond());
    Vector3d eye = toFrame.transform(viewer.position(), new Vector3d());
    YawPitch heading = YawPitch.of(toFrame.mul(viewer.orientation(), new Quaterniond()));
    heading =
        switch (mode) {
          case EXAMINE, LOOKAT -> orbit(eye, heading, motion, toFrame, dt);
          case FLY, EXPLORE -> fly(eye, heading, motion, dt);
          default -> {
            if (!viewer.position().equals(lastEye)) {
              walking.landAnew();
            }
            yield walk(eye, heading, motion, dt);
          }
        };
    viewer.moveTo(frame.upright().transform(eye));
    viewer.turnTo(frame.upright().mul(heading.orientation(), new Quaterniond()));
    lastEye.set(viewer.position());
  }

  /**
   * Moves the viewer by the physical walking of the user, as far as walls allow; no time passes.
   *
   * @param way the displacement in the world
   * @return whether the mode allows it: WALK, FLY and EXPLORE do
   */
  public boolean push(Viewer viewer, Vector3dc way) {
    bumped.clear();
    boolean walks = mode == NavigationMode.WALK;
    if (!walks && mode != NavigationMode.FLY && mode != NavigationMode.EXPLORE) {
      return false;
    }
    Quaterniond toFrame = frame.upright().conjugate(new Quaterniond());
    Vector3d eye = toFrame.transform(viewer.position(), new Vector3d());
    Vector3d level = toFrame.transform(way, new Vector3d());
    int parts = parts(level.length(), 0);
    Vector3d part = limited(level.div(parts, new Vector3d()));
    for (int i = 0; i < parts; i++) {
      if (walks) {
        walking.step(body(), eye, part, 0, collisions, bumped);
      } else {
        eye.set(flyStep(eye, part));
      }
    }
    viewer.moveTo(frame.upright().transform(eye));
    lastEye.set(viewer.position());
    return true;
  }

  private CharacterController.Body body() {
    double scale = frame.scale();
    return new CharacterController.Body(
        frame.upright(),
        radius(),
        navigation.height() * scale,
        navigation.step() * scale,
        CharacterController.GRAVITY * scale);
  }

  private double radius() {
    return navigation.radius() * frame.scale();
  }

  /**
   * Returns the speed in world units per second; diagonal motion is no faster than motion along one
   * axis.
   */
  private double speed(MotionRequest motion) {
    double wish = new Vector3d(motion.forward(), motion.strafe(), motion.rise()).length();
    return navigation.speed() * frame.scale() * motion.speedFactor() / Math.max(1, wish);
  }

  private int parts(double distance, double dt) {
    double parts = Math.max(dt / PART - 1e-6, distance / (radius() / 2));
    return (int) Math.max(1, Math.min(MAX_PARTS, Math.ceil(parts)));
  }

  /** Returns the displacement of one substep, limited such that no wall can be passed. */
  private Vector3d limited(Vector3d way) {
    double most = radius() / 2;
    double length = way.length();
    return length > most ? way.mul(most / length) : way;
  }

  private YawPitch walk(Vector3d eye, YawPitch start, MotionRequest motion, double dt) {
    CharacterController.Body body = body();
    YawPitch heading = start.turned(motion.lookYaw(), motion.lookPitch());
    double speed =
        speed(
            new MotionRequest(motion.forward(), motion.strafe(), 0, 0, 0, 0, motion.speedFactor()));
    int parts = parts(speed * Math.hypot(motion.forward(), motion.strafe()) * dt, dt);
    double part = dt / parts;
    for (int i = 0; i < parts; i++) {
      heading = heading.turned(motion.turn() * part / 2, 0);
      Vector3d way = heading.level(motion.forward(), motion.strafe()).mul(speed * part);
      walking.step(body, eye, limited(way), part, collisions, bumped);
      heading = heading.turned(motion.turn() * part / 2, 0);
    }
    return heading;
  }

  private YawPitch fly(Vector3d eye, YawPitch start, MotionRequest motion, double dt) {
    YawPitch heading = start.turned(motion.lookYaw(), motion.lookPitch());
    double speed = speed(motion);
    Vector3d wish = new Vector3d(motion.strafe(), motion.rise(), -motion.forward());
    int parts = parts(speed * wish.length() * dt, dt);
    double part = dt / parts;
    for (int i = 0; i < parts; i++) {
      heading = heading.turned(motion.turn() * part / 2, 0);
      Vector3d way = new Vector3d(motion.strafe(), 0, -motion.forward());
      heading.orientation().transform(way).add(0, motion.rise(), 0).mul(speed * part);
      eye.set(flyStep(eye, limited(way)));
      heading = heading.turned(motion.turn() * part / 2, 0);
    }
    return heading;
  }

  private Vector3d flyStep(Vector3dc eye, Vector3dc way) {
    double distance = way.length();
    if (distance == 0 || !collisions) {
      return eye.add(way, new Vector3d());
    }
    double reach = radius() + 2 * distance;
    double[] box = {
      eye.x() - reach,
      eye.y() - reach,
      eye.z() - reach,
      eye.x() + reach,
      eye.y() + reach,
      eye.z() + reach
    };
    colliders.gather(frame.upright(), box, triangles);
    return CollisionResponse.step(
        eye, way, radius(), distance / 2, new TriangleObstacleSet(triangles, bumped));
  }

  /**
   * Orbits about the pivot; forward motion approaches it by a share of the distance, so that it is
   * never reached.
   */
  private YawPitch orbit(
      Vector3d eye, YawPitch start, MotionRequest motion, Quaterniond toFrame, double dt) {
    Vector3d about = toFrame.transform(pivot, new Vector3d());
    YawPitch heading = start.turned(motion.lookYaw() + motion.turn() * dt, motion.lookPitch());
    Vector3d arm = start.orientation().transformInverse(eye.sub(about, new Vector3d()));
    double speed = speed(motion) / frame.scale();
    arm.mul(Math.exp(-motion.forward() * speed * dt));
    double side = arm.length() * speed * dt;
    eye.set(heading.orientation().transform(arm)).add(about);
    Vector3d pan = new Vector3d(motion.strafe() * side, motion.rise() * side, 0);
    eye.add(heading.orientation().transform(pan));
    return heading;
  }
}
