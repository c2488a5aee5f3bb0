package org.selectiverenderer.hmd;

import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.runtime.camera.ViewLayout;

/**
 * How a world is shown: on one screen, or to two eyes through a display.
 *
 * @param geometry of the eyes; without meaning for {@link DisplayMode#WINDOW}
 * @param check whether a pattern to check the display by is shown instead of the world
 * @param headset how it is shown in a headset; empty for all modes but {@link DisplayMode#OPENXR}
 */
public record Presentation(
    DisplayMode mode, EyeGeometry geometry, boolean check, Optional<HeadsetShown> headset) {
  /** On a screen, or to two eyes by a profile. */
  public Presentation(DisplayMode mode, EyeGeometry geometry, boolean check) {
    this(mode, geometry, check, Optional.empty());
  }

  /** In a headset; the mirror on the desk is as large as the profile's pictures. */
  public static Presentation in(HeadsetShown headset) {
    return new Presentation(
        DisplayMode.OPENXR,
        new EyeGeometry(DisplayProfile.DESK, EyeGeometry.MEAN_IPD / 1000),
        false,
        Optional.of(headset));
  }

  /** Whether two eyes are shown two views. */
  public boolean stereo() {
    return mode != DisplayMode.WINDOW;
  }

  /** The same eyes shown in another way. */
  public Presentation as(DisplayMode other) {
    return new Presentation(other, geometry, check, headset);
  }

  /**
   * The same to eyes at another distance.
   *
   * @param metres between the pupils
   */
  public Presentation withIpd(double metres) {
    return new Presentation(mode, new EyeGeometry(geometry.profile(), metres), check, headset);
  }

  /** Width in pixels of a picture in which nothing is scaled. */
  public int width() {
    return geometry.profile().width() * (sideBySide() ? 2 : 1);
  }

  /** Height in pixels of a picture in which nothing is scaled. */
  public int height() {
    return geometry.profile().height();
  }

  /** Both eyes' pictures lie side by side, in one window or spread over two. */
  private boolean sideBySide() {
    return mode == DisplayMode.SIDE_BY_SIDE || mode == DisplayMode.DUAL;
  }

  /**
   * What is seen at all: by both eyes together, or in a window.
   *
   * @param fieldOfView of a window's viewer in radians: the smaller of its two angles (X3D 4.0,
   *     23.3.5)
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

  /** How the views are arranged in one target. */
  public ViewLayout layout() {
    if (headset.isPresent()) {
      return headset.get().layout();
    }
    if (!stereo()) {
      return ViewLayout.MONO;
    }
    return check ? new CheckPattern(stereoLayout()) : stereoLayout();
  }

  /** The two views; for modes that have them. */
  public StereoLayout stereoLayout() {
    return new StereoLayout(
        geometry,
        switch (mode) {
          case QUAD -> StereoLayout.Arrangement.QUAD;
          case ANAGLYPH -> StereoLayout.Arrangement.ANAGLYPH;
          default -> StereoLayout.Arrangement.SIDE_BY_SIDE;
        });
  }

  /** What a picture of that size shows, in a sentence; for modes of two views. */
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
