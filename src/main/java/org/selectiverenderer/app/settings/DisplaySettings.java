package org.selectiverenderer.app.settings;

import java.util.Optional;
import java.util.OptionalInt;
import org.selectiverenderer.hmd.DisplayMode;
import org.selectiverenderer.hmd.DisplayProfile;
import org.selectiverenderer.hmd.EyeGeometry;
import org.selectiverenderer.hmd.Presentation;
import org.selectiverenderer.runtime.render.DrawStyle;
import org.selectiverenderer.runtime.render.Shading;
import org.selectiverenderer.runtime.render.window.Monitor;

/**
 * On what a scene is shown.
 *
 * @param presentation to one eye or two, and on what
 * @param width of the picture in pixels
 * @param height of the picture in pixels
 * @param sized whether the size was asked for; else it is what suits the presentation
 * @param samples per pixel for anti-aliasing, 0 for none; empty for what suits the machine
 * @param style how the scene is drawn
 * @param operator whether there is a window for whoever runs the session
 * @param operatorMonitor on which it opens; empty for one that no eye uses
 */
public record DisplaySettings(
    Presentation presentation,
    int width,
    int height,
    boolean sized,
    OptionalInt samples,
    DrawStyle style,
    boolean operator,
    Optional<Monitor> operatorMonitor) {
  /** A window on a desk. */
  public static final DisplaySettings WINDOW =
      of(
          new Presentation(
              DisplayMode.WINDOW,
              new EyeGeometry(DisplayProfile.DESK, EyeGeometry.MEAN_IPD / 1000),
              false));

  /** A presentation in the size that suits it. */
  public static DisplaySettings of(Presentation presentation) {
    return new DisplaySettings(
        presentation,
        presentation.width(),
        presentation.height(),
        false,
        OptionalInt.empty(),
        DrawStyle.of(Shading.AUTO),
        false,
        Optional.empty());
  }

  /** In a size that was asked for. */
  public DisplaySettings sized(int wantedWidth, int wantedHeight) {
    return new DisplaySettings(
        presentation, wantedWidth, wantedHeight, true, samples, style, operator, operatorMonitor);
  }

  /** With so many samples per pixel. */
  public DisplaySettings samples(OptionalInt wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, wanted, style, operator, operatorMonitor);
  }

  /** Where light is computed. */
  public Shading shading() {
    return style.shading();
  }

  /** Drawn in another way. */
  public DisplaySettings style(DrawStyle wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, samples, wanted, operator, operatorMonitor);
  }

  /** With a window for the operator or without. */
  public DisplaySettings operator(boolean wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, samples, style, wanted, operatorMonitor);
  }

  /** With the operator's window on a monitor. */
  public DisplaySettings operatorOn(Optional<Monitor> wanted) {
    return new DisplaySettings(
        presentation, width, height, sized, samples, style, operator, wanted);
  }

  /** Of the size that a monitor turned out to have. */
  public DisplaySettings filling(int foundWidth, int foundHeight) {
    return new DisplaySettings(
        presentation, foundWidth, foundHeight, sized, samples, style, operator, operatorMonitor);
  }

  /** Shown in another way; the size stays if it was asked for. */
  public DisplaySettings as(Presentation other) {
    DisplaySettings suited =
        of(other).samples(samples).style(style).operator(operator).operatorOn(operatorMonitor);
    return sized ? suited.sized(width, height) : suited;
  }
}
