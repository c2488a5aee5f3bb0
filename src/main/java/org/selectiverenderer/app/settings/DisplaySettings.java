package org.selectiverenderer.app.settings;

import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.hmd.DisplayConfiguration;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.RenderOptions;
import org.selectiverenderer.render.ShadingMode;
import org.selectiverenderer.render.window.Monitor;

/**
 * The display on which a scene is shown, and how it is drawn.
 *
 * @param presentation display mode and stereo geometry
 * @param width width of the picture in pixels
 * @param height height of the picture in pixels
 * @param sized whether the user chose the size; otherwise it is the presentation's default
 * @param samples samples per pixel for anti-aliasing, 0 for none; empty for the machine's default
 * @param style how the scene is drawn
 * @param operator whether the operator of a session has a window
 * @param operatorMonitor monitor of the operator's window; empty for one that no eye uses
 * @param saved whether the last picture is written to a file
 * @param title of the windows; empty for the name of the scene's file
 */
public record DisplaySettings(
    DisplayConfiguration presentation,
    int width,
    int height,
    boolean sized,
    OptionalInt samples,
    RenderOptions style,
    boolean operator,
    Optional<Monitor> operatorMonitor,
    boolean saved,
    Optional<String> title) {
  /** A window on a desktop monitor. */
  public static final DisplaySettings WINDOW =
      of(
          new DisplayConfiguration(
              DisplayMode.WINDOW,
              new EyeGeometry(DisplayProfile.DESK, EyeGeometry.MEAN_IPD / 1000),
              false));

  /** Creates the settings of a presentation in its default size. */
  public static DisplaySettings of(DisplayConfiguration presentation) {
    return new DisplaySettings(
        presentation,
        presentation.width(),
        presentation.height(),
        false,
        OptionalInt.empty(),
        RenderOptions.of(ShadingMode.AUTO),
        false,
        Optional.empty(),
        false,
        Optional.empty());
  }

  /** Returns these settings with a size chosen by the user. */
  public DisplaySettings sized(int wantedWidth, int wantedHeight) {
    return new DisplaySettings(
        presentation,
        wantedWidth,
        wantedHeight,
        true,
        samples,
        style,
        operator,
        operatorMonitor,
        saved,
        title);
  }

  /** Returns these settings with another number of samples per pixel. */
  public DisplaySettings samples(OptionalInt wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, wanted, style, operator, operatorMonitor, saved, title);
  }

  /** Returns these settings for a run whose last picture is written to a file, or is not. */
  public DisplaySettings saved(boolean wanted) {
    return new DisplaySettings(
        presentation,
        width,
        height,
        sized,
        samples,
        style,
        operator,
        operatorMonitor,
        wanted,
        title);
  }

  /**
   * Returns the samples per pixel of the last picture. One that is written to a file is smooth on
   * any machine, unless the user chose the samples: it is drawn once more where frames have fewer.
   *
   * @param drawn the samples per pixel of the frames
   */
  public int pictureSamples(int drawn) {
    return saved && samples.isEmpty() ? Math.max(AntiAliasing.SMOOTH, drawn) : drawn;
  }

  /** Returns whether light is computed per pixel or per vertex. */
  public ShadingMode shading() {
    return style.shading();
  }

  /** Returns these settings with another drawing style. */
  public DisplaySettings style(RenderOptions wanted) {
    return new DisplaySettings(
        presentation,
        width,
        height,
        sized,
        samples,
        wanted,
        operator,
        operatorMonitor,
        saved,
        title);
  }

  /** Returns these settings with or without a window for the operator. */
  public DisplaySettings operator(boolean wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, samples, style, wanted, operatorMonitor, saved, title);
  }

  /** Returns these settings with the operator's window on a given monitor. */
  public DisplaySettings operatorOn(Optional<Monitor> wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, samples, style, operator, wanted, saved, title);
  }

  /** Returns these settings with a title of the windows, which must not tell the scene's name. */
  public DisplaySettings titled(Optional<String> wanted) {
    return new DisplaySettings(
        presentation,
        width,
        height,
        sized,
        samples,
        style,
        operator,
        operatorMonitor,
        saved,
        wanted);
  }

  /** Returns these settings with the real size of a monitor. */
  public DisplaySettings filling(int foundWidth, int foundHeight) {
    return new DisplaySettings(
        presentation,
        foundWidth,
        foundHeight,
        sized,
        samples,
        style,
        operator,
        operatorMonitor,
        saved,
        title);
  }

  /** Returns these settings with another presentation; a size chosen by the user stays. */
  public DisplaySettings as(DisplayConfiguration other) {
    DisplaySettings suited =
        of(other)
            .samples(samples)
            .style(style)
            .operator(operator)
            .operatorOn(operatorMonitor)
            .saved(saved)
            .titled(title);
    return sized ? suited.sized(width, height) : suited;
  }
}
