package org.selectiverenderer.cli.view;

import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.MirroredEye;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.hmd.HeadsetLayout;
import org.selectiverenderer.hmd.HeadsetViewSettings;
import picocli.CommandLine.Option;

/** The options of {@code --display openxr}. */
final class HeadsetOptions {
  private static final double LARGEST = 100;
  private static final double WIDEST_TURN = 180;

  private enum Posture {
    standing,
    seated
  }

  private enum Side {
    both,
    left,
    right
  }

  @Option(
      names = "--posture",
      paramLabel = "POSTURE",
      description =
          "user of a headset: standing (eyes as high above the scene's floor as they are) or "
              + "seated (eyes at the scene's height) (default: standing)")
  private @Nullable Posture posture;

  @Option(
      names = "--user-scale",
      paramLabel = "N",
      description =
          "size of a headset's user in the scene: 2 halves the size of everything (default: 1)")
  private @Nullable Double scale;

  @Option(
      names = "--turn",
      paramLabel = "DEG",
      description =
          "angle by which a headset's controller turns at once, 0 to turn smoothly "
              + "(default: 30)")
  private @Nullable Double turn;

  @Option(
      names = "--mirror",
      paramLabel = "EYES",
      description =
          "eyes of a headset whose pictures the window shows: both, left or right "
              + "(default: both)")
  private @Nullable Side mirror;

  /** Rejects options that would have no effect. */
  void check(boolean worn) {
    if (!worn && (posture != null || scale != null || turn != null || mirror != null)) {
      throw CommandException.usage(
          "--posture, --user-scale, --turn and --mirror need --display openxr");
    }
    if (scale != null && !(scale >= 1 / LARGEST && scale <= LARGEST)) {
      throw CommandException.usage("--user-scale must be a number from 0.01 to 100");
    }
    if (turn != null && !(turn >= 0 && turn <= WIDEST_TURN)) {
      throw CommandException.usage("--turn must be a number of degrees from 0 to 180");
    }
  }

  HeadsetViewSettings shown() {
    HeadsetViewSettings usual = HeadsetViewSettings.standing();
    double size = scale == null ? usual.size() : scale;
    return new HeadsetViewSettings(
        posture == Posture.seated,
        size,
        turn == null ? usual.turnStep() : Math.toRadians(turn),
        mirror == null
            ? usual.mirror()
            : MirroredEye.valueOf(mirror.name().toUpperCase(Locale.ROOT)),
        new HeadsetLayout(size));
  }
}
