package org.selectiverenderer.app.run;

import java.util.List;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.sound.DeviceLine;
import org.selectiverenderer.runtime.sound.Speaker;

/** Plays the sounds of a real-time run. A missing sound device is reported once. */
final class SceneSound implements AutoCloseable {
  private final Speaker speaker = new Speaker(DeviceLine::open);
  private final boolean audible;

  /**
   * @param audible whether sounds are played at all
   */
  SceneSound(boolean audible) {
    this.audible = audible;
  }

  /**
   * Plays the sounds that are active after a step.
   *
   * @param silent whether the run is paused
   */
  void hear(World world, boolean silent) {
    if (!audible) {
      return;
    }
    speaker.play(silent ? List.of() : world.voices());
    speaker
        .fault()
        .ifPresent(
            reason ->
                world
                    .problems()
                    .info(
                        Location.of(world.scene().url()),
                        "the sounds of the scene cannot be played: %s; use --mute to run without"
                            .formatted(reason)));
  }

  @Override
  public void close() {
    speaker.close();
  }
}
