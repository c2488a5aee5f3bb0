package org.selectiverenderer.app.run;

import java.util.List;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.sound.DeviceLine;
import org.selectiverenderer.runtime.sound.Speaker;

/** Has the sounds of a watched run heard. Where there is no device, it says so once. */
final class SceneSound implements AutoCloseable {
  private final Speaker speaker = new Speaker(DeviceLine::open);
  private final boolean audible;

  /**
   * @param audible whether anything is heard at all
   */
  SceneSound(boolean audible) {
    this.audible = audible;
  }

  /**
   * Plays what a step has left.
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
                        "the scene has sounds that are not heard: %s; --mute leaves them out"
                            .formatted(reason)));
  }

  @Override
  public void close() {
    speaker.close();
  }
}
