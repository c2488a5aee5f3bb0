package org.selectiverenderer.hmd;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.selectiverenderer.apparatus.Eye;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.DepthRange;
import org.selectiverenderer.browser.camera.EyeView;
import org.selectiverenderer.browser.camera.EyeView.Channel;
import org.selectiverenderer.browser.camera.ViewLayout;
import org.selectiverenderer.browser.viewer.ViewpointFrame;

/**
 * The layout of both eyes' views in a framebuffer. Each picture keeps the display's aspect ratio in
 * pixels, which need not be square; the rest of the framebuffer is filled with black bars.
 *
 * <p>The interpupillary distance is converted to the scene's unit of length (X3D 4.0, 7.2.5 {@code
 * UNIT}) and scaled with the coordinate system of the bound viewpoint: a viewer in a scaled
 * Transform is that much larger, and so is the head.
 *
 * @param geometry the geometry of the eyes and the display
 * @param arrangement the places of the pictures in the framebuffer
 */
public record StereoLayout(EyeGeometry geometry, Arrangement arrangement) implements ViewLayout {

  /** The arrangement of both eyes' pictures. */
  public enum Arrangement {
    /** The left eye's in the left half, the right eye's in the right half. */
    SIDE_BY_SIDE,
    /** One over the other: red for the left eye, cyan for the right. */
    ANAGLYPH,
    /** Into the left and right buffers of a quad-buffered window. */
    QUAD
  }

  /** A viewport of a framebuffer in pixels from the lower left corner. */
  public record Part(int x, int y, int width, int height) {}

  @Override
  public List<EyeView> views(World world, int width, int height, DepthRange range) {
    double scale = unitsPerMetre(world);
    // The eyes are off the head's centre, so the depth range must hold for both.
    DepthRange both = new DepthRange(range.near(), range.far() + 2 * farthestEye() * scale);
    return List.of(
        view(world, Eye.LEFT, part(Eye.LEFT, width, height), scale, both),
        view(world, Eye.RIGHT, part(Eye.RIGHT, width, height), scale, both));
  }

  /** Returns the scene's units per metre of the viewer. */
  static double unitsPerMetre(World world) {
    Optional<ViewpointFrame> frame =
        world
            .bindables()
            .bound("X3DViewpointNode")
            .map(viewpoint -> ViewpointFrame.of(world.views().placeOf(viewpoint)));
    return frame.map(ViewpointFrame::scale).orElse(1.0) / world.scene().unitLength();
  }

  private double farthestEye() {
    return Math.max(geometry.position(Eye.LEFT).length(), geometry.position(Eye.RIGHT).length());
  }

  private EyeView view(World world, Eye eye, Part part, double scale, DepthRange range) {
    Vector3d at = geometry.position(eye).mul(scale);
    Matrix4d view = new Matrix4d().translation(-at.x, -at.y, -at.z).mul(world.viewer().view());
    return new EyeView(
        new Camera(
            view,
            geometry.frustum(eye).projection(range.near(), range.far()),
            part.x(),
            part.y(),
            part.width(),
            part.height()),
        channel(eye));
  }

  private Channel channel(Eye eye) {
    return switch (arrangement) {
      case SIDE_BY_SIDE -> Channel.ALL;
      case ANAGLYPH -> eye == Eye.LEFT ? Channel.RED : Channel.CYAN;
      case QUAD -> eye == Eye.LEFT ? Channel.LEFT_BUFFER : Channel.RIGHT_BUFFER;
    };
  }

  /** Returns the viewport of an eye's picture in a framebuffer of that size. */
  public Part part(Eye eye, int width, int height) {
    if (arrangement != Arrangement.SIDE_BY_SIDE) {
      return fit(0, width, height);
    }
    int half = Math.max(1, width / 2);
    return fit(eye == Eye.LEFT ? 0 : width - half, half, height);
  }

  /** Returns the largest centred viewport with the display's aspect ratio. */
  private Part fit(int x, int width, int height) {
    double aspect = geometry.profile().width() / (double) geometry.profile().height();
    int fitWidth = (int) Math.max(1, Math.min(width, Math.round(height * aspect)));
    int fitHeight = (int) Math.max(1, Math.min(height, Math.round(width / aspect)));
    return new Part(x + (width - fitWidth) / 2, (height - fitHeight) / 2, fitWidth, fitHeight);
  }
}
