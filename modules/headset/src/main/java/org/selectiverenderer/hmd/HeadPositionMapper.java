package org.selectiverenderer.hmd;

import java.util.Optional;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.browser.viewer.ViewpointFrame;
import org.selectiverenderer.tracker.PoseSample;

/**
 * Maps the tracked position of the head to the viewer. The user's body stands in the scene like a
 * walking viewer: on the ground, with its eyes at the avatar height of the NavigationInfo, stopped
 * by walls. The head is displaced from the body by the tracked position, so that head movements are
 * neither delayed, smoothed nor restricted. When the head moves away sideways, the body follows as
 * far as walls allow. The rest is a lean of at most {@value #LEAN} m: if the user leans farther,
 * the tracker's room is shifted instead, so that the viewer never gets behind a wall.
 *
 * <p>Belongs to the thread that steps the world.
 */
final class HeadPositionMapper {
  /** The largest horizontal distance of the head from its body, in metres. */
  static final double LEAN = 0.5;

  private final World world;
  private final HeadTrackingOptions settings;
  private final @Nullable HeadTrackedCollision body;

  /** The body's position in the tracker's room: right, back. */
  private double footX;

  private double footZ;

  /** The tracked height that corresponds to the body's eyes. */
  private double footY;

  private int straightened = -1;
  private int jumps;
  private @Nullable Vector3d head;
  private final Vector3d eyes = new Vector3d();

  /**
   * @param body the body that follows the head; null if something else moves it, such as a path
   */
  HeadPositionMapper(
      World world, HeadTrackingOptions settings, @Nullable HeadTrackedCollision body) {
    this.world = world;
    this.settings = settings;
    this.body = body;
    jumps = world.views().jumps();
  }

  /** Moves the viewer back to the body's eyes, from where walking continues. */
  void leave(Viewer viewer) {
    Vector3d before = head;
    if (before == null) {
      return;
    }
    boolean jumped = world.views().jumps() != jumps;
    jumps = world.views().jumps();
    if (jumped) {
      return; // The viewer jumped to a viewpoint, and so does the body.
    }
    // Movements of the viewer since then, for example by an animated viewpoint, also move the body.
    viewer.moveTo(viewer.position().sub(before, new Vector3d()).add(eyes));
  }

  /**
   * Moves the viewer to the head.
   *
   * @param viewer the viewer at the position of the body's eyes
   * @param chair the yaw of the tracker's room in the walking viewer's upright frame, in radians
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
    HeadTrackedCollision walking = body;
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

  /** Returns the height of the body's eyes above the ground, in the world's units. */
  private double eyeHeight() {
    double height =
        world
            .bindables()
            .bound("NavigationInfo")
            .map(NavigationParameters::of)
            .orElse(NavigationParameters.WALKING)
            .height();
    Optional<ViewpointFrame> frame =
        world
            .bindables()
            .bound("X3DViewpointNode")
            .map(viewpoint -> ViewpointFrame.of(world.views().placeOf(viewpoint)));
    return height * frame.map(ViewpointFrame::scale).orElse(1.0);
  }
}
