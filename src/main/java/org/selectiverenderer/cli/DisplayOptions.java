package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.DisplayProfiles;
import org.selectiverenderer.hmd.EyeGeometry;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options that say on what a scene is shown. */
final class DisplayOptions {
  @Option(
      names = "--display",
      defaultValue = "window",
      converter = ModeConverter.class,
      paramLabel = "MODE",
      description =
          "window, side-by-side, dual (a full-screen window per eye on two monitors), quad"
              + " (quad-buffered stereo) or anaglyph (red-cyan) (default: ${DEFAULT-VALUE})")
  private DisplayMode mode = DisplayMode.WINDOW;

  @Option(
      names = "--hmd",
      paramLabel = "NAME",
      description =
          "the display before the eyes: proview50, proview30, desk or a file FILE.json (default:"
              + " proview50; with --display anaglyph desk)")
  private @Nullable String hmd;

  @Option(
      names = "--ipd",
      paramLabel = "MM",
      description = "distance of the pupils in millimetres (default: 63)")
  private @Nullable Double ipd;

  @Option(
      names = "--hmd-check",
      description =
          "a pattern instead of the scene, to check which eye is which, field of view and scale"
              + " (side-by-side unless --display says otherwise)")
  private boolean check;

  @Option(
      names = "--operator",
      negatable = true,
      description =
          "a window for whoever runs the session: what the participant sees, the areas from above,"
              + " schemas, figures, the tracker's health (default: with dual and quad)")
  private @Nullable Boolean operator;

  /** Whether there is a window for the operator. */
  boolean operator() {
    return operator == null ? mode == DisplayMode.DUAL || mode == DisplayMode.QUAD : operator;
  }

  /**
   * What was asked for; empty when the display's file has faults, which are told then.
   *
   * @throws IOException if that file cannot be read
   */
  Optional<Presentation> presentation(Problems problems) throws IOException {
    double millimetres = ipd == null ? EyeGeometry.MEAN_IPD : ipd;
    if (!(millimetres >= 0 && millimetres <= EyeGeometry.LARGEST_IPD)) {
      throw CommandFailure.usage(
          "--ipd is a number of millimetres from 0 to " + (int) EyeGeometry.LARGEST_IPD);
    }
    if (check && mode == DisplayMode.WINDOW) {
      mode = DisplayMode.SIDE_BY_SIDE;
    }
    if (mode == DisplayMode.WINDOW && (hmd != null || ipd != null)) {
      throw CommandFailure.usage(
          "--hmd and --ipd are for two eyes: choose --display side-by-side, dual, quad or anaglyph"
              + " too");
    }
    return profile(problems)
        .map(
            profile -> new Presentation(mode, new EyeGeometry(profile, millimetres / 1000), check));
  }

  private Optional<DisplayProfile> profile(Problems problems) throws IOException {
    if (hmd == null) {
      boolean desk = mode == DisplayMode.WINDOW || mode == DisplayMode.ANAGLYPH;
      return Optional.of(desk ? DisplayProfile.DESK : DisplayProfile.PROVIEW_50);
    }
    Optional<DisplayProfile> known = DisplayProfiles.builtIn(hmd);
    if (known.isPresent()) {
      return known;
    }
    Path file = Path.of(hmd);
    if (!Files.isRegularFile(file)) {
      throw CommandFailure.usage(
          "--hmd " + hmd + ": is neither proview50, proview30, desk nor a file");
    }
    return DisplayProfiles.read(file, problems);
  }

  /** Reads a mode as the command line writes it. */
  static final class ModeConverter implements ITypeConverter<DisplayMode> {
    @Override
    public DisplayMode convert(String value) {
      for (DisplayMode mode : DisplayMode.values()) {
        if (mode.name().replace('_', '-').equalsIgnoreCase(value)) {
          return mode;
        }
      }
      throw new TypeConversionException(
          "'" + value + "' is none of window, side-by-side, dual, quad, anaglyph");
    }
  }
}
