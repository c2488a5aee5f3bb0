package org.selectiverenderer.hmd;

import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfile;
import org.selectiverenderer.apparatus.Eye;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.apparatus.FieldOfView;
import org.selectiverenderer.browser.camera.ViewLayout;

/**
 * The display configuration of a run: one window, or two eyes through a display.
 *
 * @param geometry the geometry of the eyes; unused with {@link DisplayMode#WINDOW}
 * @param check whether a test pattern is shown instead of the world
 * @param headset the options of a headset; empty for all modes except {@link DisplayMode#OPENXR}
 */
public record DisplayConfiguration(
    DisplayMode mode, EyeGeometry geometry, boolean check, Optional<HeadsetViewSettings> headset) {
  /** Makes a configuration without a headset. */
  public DisplayConfiguration(DisplayMode mode, EyeGeometry geometry, boolean check) {
    this(mode, geometry, check, Optional.empty());
  }

  /**
   * Returns the configuration of a headset; the mirror window is as large as the desk profile's
   * pictures.
   */
  public static DisplayConfiguration in(HeadsetViewSettings headset) {
    return new DisplayConfiguration(
        DisplayMode.OPENXR,
        new EyeGeometry(DisplayProfile.DESK, EyeGeometry.MEAN_IPD / 1000),
        false,
        Optional.of(headset));
  }

  /** Returns whether it is stereoscopic. */
  public boolean stereo() {
    return mode != DisplayMode.WINDOW;
  }

  /** Returns the same configuration with another display mode. */
  public DisplayConfiguration as(DisplayMode other) {
    return new DisplayConfiguration(other, geometry, check, headset);
  }

  /**
   * Returns the same configuration with another interpupillary distance.
   *
   * @param metres the interpupillary distance
   */
  public DisplayConfiguration withIpd(double metres) {
    return new DisplayConfiguration(
        mode, new EyeGeometry(geometry.profile(), metres), check, headset);
  }

  /** Returns the width in pixels at which nothing is scaled. */
  public int width() {
    return geometry.profile().width() * (sideBySide() ? 2 : 1);
  }

  /** Returns the height in pixels at which nothing is scaled. */
  public int height() {
    return geometry.profile().height();
  }

  /** Returns whether both eyes' pictures lie side by side, in one window or two. */
  private boolean sideBySide() {
    return mode == DisplayMode.SIDE_BY_SIDE || mode == DisplayMode.DUAL;
  }

  /**
   * Returns the whole field of view: of both eyes together, or of a window.
   *
   * @param fieldOfView the viewer's field of view in radians for a window: the smaller of its two
   *     angles (X3D 4.0, 23.3.5)
   * @param width of the window's picture
   * @param height of the window's picture
   */
  public FieldOfView seen(double fieldOfView, int width, int height) {
    if (headset.isPresent()) {
      return headset.get().layout().bothEyes();
    }
    if (stereo()) {
      return geometry.bothEyes();
    }
    double half = Math.tan(fieldOfView / 2) / Math.min(width, height);
    return new FieldOfView(half * width, half * height);
  }

  /** Returns the layout of the views in one framebuffer. */
  public ViewLayout layout() {
    if (headset.isPresent()) {
      return headset.get().layout();
    }
    if (!stereo()) {
      return ViewLayout.MONO;
    }
    return check ? new DisplayTestPattern(stereoLayout()) : stereoLayout();
  }

  /** Returns the layout of the two views, for stereoscopic modes. */
  public StereoLayout stereoLayout() {
    return new StereoLayout(
        geometry,
        switch (mode) {
          case QUAD -> StereoLayout.Arrangement.QUAD;
          case ANAGLYPH -> StereoLayout.Arrangement.ANAGLYPH;
          default -> StereoLayout.Arrangement.SIDE_BY_SIDE;
        });
  }

  /** Describes the configuration at a window size in one sentence, for stereoscopic modes. */
  public String describe(int width, int height) {
    if (headset.isPresent()) {
      return "headset by OpenXR: " + headset.get().layout().describe();
    }
    StereoLayout.Part part = stereoLayout().part(Eye.LEFT, width, height);
    DisplayProfile profile = geometry.profile();
    FieldOfView field = profile.fieldOfView();
    String scaled =
        part.width() == profile.width()
            ? ""
            : String.format(
                Locale.ROOT, " (the display has %dx%d)", profile.width(), profile.height());
    String arranged =
        switch (mode) {
          case SIDE_BY_SIDE -> "side by side, the left eye's on the left";
          case DUAL ->
              "the left eye's on monitor %d, the right eye's on monitor %d"
                  .formatted(profile.leftScreen(), profile.rightScreen());
          case ANAGLYPH ->
              "one on top of the other, the left eye's in red, the right eye's in cyan";
          default -> "in the left and right buffers";
        };
    return String.format(
        Locale.ROOT,
        "%s: two pictures of %dx%d%s, %s, %.1f x %.1f degrees each, eyes %.1f mm apart",
        profile.name(),
        part.width(),
        part.height(),
        scaled,
        arranged,
        field.horizontal(),
        field.vertical(),
        geometry.interpupillaryDistance() * 1000);
  }
}
