package org.selectiverenderer.hmd;

import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.viewer.NavigationFrame;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.walk.Navigation;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Where a tracked head is above its body. The body stands in the scene as a walker does: on the
 * ground, its eyes as high as the NavigationInfo says, held up by walls. The head is beside and
 * above it by what the tracker tells, so nothing that the user does with his head is delayed,
 * softened or kept from him. When the head goes away to a side, the body follows, as far as walls
 * let it; what it cannot follow is a lean, of at most {@value #LEAN} m: who leans farther takes the
 * room with him, so that nobody gets behind a wall.
 *
 * <p>Belongs to the thread that steps the world.
 */
final class HeadPlace {
  /** Metres that a head may be beside its body. */
  static final double LEAN = 0.5;

  private final World world;
  private final HeadSettings settings;
  private final @Nullable FollowingBody body;

  /** The place of the tracker's room above which the body stands: right, back. */
  private double footX;

  private double footZ;

  /** The height that counts as that of the body's eyes. */
  private double footY;

  private int straightened = -1;
  private int jumps;
  private @Nullable Vector3d head;
  private final Vector3d eyes = new Vector3d();

  /**
   * @param body that follows; null for one that something else moves, such as a path
   */
  HeadPlace(World world, HeadSettings settings, @Nullable FollowingBody body) {
    this.world = world;
    this.settings = settings;
    this.body = body;
    jumps = world.views().jumps();
  }

  /** Puts the viewer to the body's eyes, where walking goes on from. */
  void leave(Viewer viewer) {
    Vector3d before = head;
    if (before == null) {
      return;
    }
    boolean jumped = world.views().jumps() != jumps;
    jumps = world.views().jumps();
    if (jumped) {
      return; // It was taken to a viewpoint: the body goes there.
    }
    // What moved the viewer since, such as a viewpoint that rides on something, moved the body.
    viewer.moveTo(viewer.position().sub(before, new Vector3d()).add(eyes));
  }

  /**
   * Puts the viewer to the head.
   *
   * @param viewer stands where the body's eyes are
   * @param chair how the tracker's room is turned, in the walker's upright frame
   */
  void enter(Viewer viewer, PoseSample sample, double chair, Quaterniondc upright) {
    double scale = settings.size() * StereoLayout.unitsPerMetre(world);
    Quaterniond room = upright.mul(new Quaterniond().rotationY(chair), new Quaterniond());
    if (sample.straightened() != straightened) {
      straightened = sample.straightened();
      footX = sample.x();
      footY = sample.y();
      footZ = sample.z();
    }
    follow(viewer, sample, room, scale);
    eyes.set(viewer.position());
    double height =
        settings.floor().getAsBoolean()
            ? sample.y() * scale - eyeHeight()
            : (sample.y() - footY) * scale;
    Vector3d beside =
        new Vector3d((sample.x() - footX) * scale, height, (sample.z() - footZ) * scale);
    Vector3d at = room.transform(beside).add(eyes);
    viewer.moveTo(at);
    head = at;
  }

  private void follow(Viewer viewer, PoseSample sample, Quaterniondc room, double scale) {
    FollowingBody walking = body;
    if (walking == null) {
      return;
    }
    Vector3d wanted =
        room.transform(new Vector3d((sample.x() - footX) * scale, 0, (sample.z() - footZ) * scale));
    if (wanted.lengthSquared() == 0) {
      return;
    }
    Vector3dc before = new Vector3d(viewer.position());
    if (!walking.follow(viewer, wanted)) {
      return;
    }
    Vector3d went = room.transformInverse(viewer.position().sub(before, new Vector3d())).div(scale);
    footX += went.x;
    footZ += went.z;
    double leanX = sample.x() - footX;
    double leanZ = sample.z() - footZ;
    double lean = Math.hypot(leanX, leanZ);
    if (lean > LEAN) {
      footX += leanX * (1 - LEAN / lean);
      footZ += leanZ * (1 - LEAN / lean);
    }
  }

  /** How high the body's eyes are above the ground, in the world's unit. */
  private double eyeHeight() {
    double height =
        world
            .bindables()
            .bound("NavigationInfo")
            .map(Navigation::of)
            .orElse(Navigation.WALKING)
            .height();
    Optional<NavigationFrame> frame =
        world
            .bindables()
            .bound("X3DViewpointNode")
            .map(viewpoint -> NavigationFrame.of(world.views().placeOf(viewpoint)));
    return height * frame.map(NavigationFrame::scale).orElse(1.0);
  }
}
