package org.selectiverenderer.cli.view;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.hmd.DisplayConfiguration;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options for the display on which a scene is shown. */
final class DisplayOptions {
  @Option(
      names = "--display",
      defaultValue = "window",
      converter = ModeConverter.class,
      paramLabel = "MODE",
      description =
          "way of showing the scene: window, side-by-side, dual (a full-screen "
              + "window per eye on two monitors), quad (quad-buffered stereo), anaglyph "
              + "(red-cyan) or openxr (a headset) (default: ${DEFAULT-VALUE})")
  private DisplayMode mode = DisplayMode.WINDOW;

  @Option(
      names = "--hmd",
      paramLabel = "NAME",
      description =
          "profile of the display: proview50, proview30, desk or a file FILE.json "
              + "(default: proview50; desk with --display anaglyph)")
  private @Nullable String hmd;

  @Option(
      names = "--ipd",
      paramLabel = "MM",
      description = "distance of the pupils in millimetres (default: 63)")
  private @Nullable Double ipd;

  @Option(
      names = "--hmd-check",
      description =
          "shows a test pattern instead of the scene, to check left and right eye, "
              + "field of view and scale (side-by-side unless --display says otherwise)")
  private boolean check;

  @Option(
      names = "--operator",
      negatable = true,
      description =
          "opens a window for the person who runs the session: the participant's "
              + "picture, the areas from above, schemas, figures, the tracker's health "
              + "(default: only with dual and quad)")
  private @Nullable Boolean operator;

  @Mixin private HeadsetOptions headset = new HeadsetOptions();

  /** Returns whether the scene is shown in a headset. */
  boolean worn() {
    return mode == DisplayMode.OPENXR;
  }

  /** Returns the display profile's file, if the option names one; else null. */
  @Nullable Path file() {
    return hmd == null || DisplayProfileLoader.builtIn(hmd).isPresent() ? null : Path.of(hmd);
  }

  /**
   * Checks the options before any work begins.
   *
   * @param picture file for the picture of the operator's window; null for none
   */
  void check(boolean offscreen, @Nullable Path picture) {
    headset.check(worn());
    if (worn() && offscreen) {
      throw CommandException.usage(
          "--display openxr shows the scene in a headset, so it cannot be combined with "
              + "--offscreen; leave one of them out");
    }
    if (worn() && (hmd != null || ipd != null || check)) {
      throw CommandException.usage(
          "--display openxr: a headset brings its own field of view and pupil distance; leave "
              + "--hmd, --ipd and --hmd-check out");
    }
    if (offscreen && operator != null && operator) {
      throw CommandException.usage(
          "--operator opens a window, so it cannot be combined with --offscreen; leave "
              + "one of them out");
    }
    if (offscreen && picture != null) {
      throw CommandException.usage(
          "--operator-screenshot needs a window, so it cannot be combined with "
              + "--offscreen; leave one of them out");
    }
    if (picture != null && !operator()) {
      throw CommandException.usage("--operator-screenshot needs --operator");
    }
  }

  /** Returns whether the operator has a window. */
  boolean operator() {
    return operator == null ? mode == DisplayMode.DUAL || mode == DisplayMode.QUAD : operator;
  }

  /**
   * Returns the presentation; empty when the display profile's file has errors, which are reported
   * to {@code problems}.
   *
   * @throws IOException if that file cannot be read
   */
  Optional<DisplayConfiguration> presentation(ProblemCollector problems) throws IOException {
    if (worn()) {
      return Optional.of(DisplayConfiguration.in(headset.shown()));
    }
    double millimetres = ipd == null ? EyeGeometry.MEAN_IPD : ipd;
    if (!(millimetres >= 0 && millimetres <= EyeGeometry.LARGEST_IPD)) {
      throw CommandException.usage(
          "--ipd must be a number of millimetres from 0 to " + (int) EyeGeometry.LARGEST_IPD);
    }
    if (check && mode == DisplayMode.WINDOW) {
      mode = DisplayMode.SIDE_BY_SIDE;
    }
    if (mode == DisplayMode.WINDOW && (hmd != null || ipd != null)) {
      throw CommandException.usage(
          "--hmd and --ipd need a display for two eyes: add --display side-by-side, "
              + "dual, quad or anaglyph");
    }
    return profile(problems)
        .map(
            profile ->
                new DisplayConfiguration(
                    mode, new EyeGeometry(profile, millimetres / 1000), check));
  }

  private Optional<DisplayProfile> profile(ProblemCollector problems) throws IOException {
    if (hmd == null) {
      boolean desk = mode == DisplayMode.WINDOW || mode == DisplayMode.ANAGLYPH;
      return Optional.of(desk ? DisplayProfile.DESK : DisplayProfile.PROVIEW_50);
    }
    Optional<DisplayProfile> known = DisplayProfileLoader.builtIn(hmd);
    if (known.isPresent()) {
      return known;
    }
    Path file = Path.of(hmd);
    if (!Files.isRegularFile(file)) {
      throw CommandException.usage(
          "--hmd " + hmd + ": is neither a file nor one of proview50, proview30 and desk");
    }
    return DisplayProfileLoader.read(file, problems);
  }

  /** Converts the name of a display mode. */
  static final class ModeConverter implements ITypeConverter<DisplayMode> {
    @Override
    public DisplayMode convert(String value) {
      for (DisplayMode mode : DisplayMode.values()) {
        if (mode.name().replace('_', '-').equalsIgnoreCase(value)) {
          return mode;
        }
      }
      throw new TypeConversionException(
          "'"
              + value
              + "' is unknown; choose window, side-by-side, dual, quad, anaglyph or openxr");
    }
  }
}
