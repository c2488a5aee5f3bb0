package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.enricher.compare.ReferenceImage;
import org.selectiverenderer.schema.SensorSchemas;

/**
 * A rendered frame of the preview with the texts about it; a value.
 *
 * @param image in device pixels
 * @param camera the camera of the frame
 * @param labels of the sensor boxes; none when they are not shown
 * @param polygons polygons of the whole scene in its present versions
 * @param drawn polygons after culling
 * @param samples per pixel; 0 for no anti-aliasing
 * @param milliseconds that drawing the picture took, measured until its pixels were there
 * @param areas areas that the walking viewer is in, in the order of entering
 * @param schemas active schemas, by walking or by simulation
 * @param walking whether the author walks
 * @param selected the name of the outlined node; empty for none
 * @param otherLayers number of visible layers that this picture leaves out
 * @param revision the document's revision that is shown
 * @param drawnBy the OpenGL renderer and version
 * @param compared the reference image, if the author compares
 * @param boxes of the selected nodes that show something, in the order of the selection
 * @param version a sentence about the object whose version the author has chosen
 */
record PreviewFrame(
    BufferedImage image,
    Camera camera,
    List<Label> labels,
    long polygons,
    long drawn,
    int samples,
    double milliseconds,
    List<String> areas,
    List<String> schemas,
    boolean walking,
    Optional<String> selected,
    int otherLayers,
    long revision,
    String drawnBy,
    Optional<ReferenceImage> compared,
    List<ObjectBox> boxes,
    Optional<String> version) {

  /** Returns the same picture with other labels and another revision. */
  PreviewFrame with(List<Label> otherLabels, long newRevision) {
    return new PreviewFrame(
        image,
        camera,
        otherLabels,
        polygons,
        drawn,
        samples,
        milliseconds,
        areas,
        schemas,
        walking,
        selected,
        otherLayers,
        newRevision,
        drawnBy,
        compared,
        boxes,
        version);
  }

  /**
   * The label of a sensor's box.
   *
   * @param x its horizontal centre in pixels from the left
   * @param y its lower edge in pixels from the top
   * @param name the DEF name
   * @param polygons polygons in the box, if they were counted
   * @param hidden whether all label points of the box are occluded
   * @param anchor the sensor's anchor
   */
  record Label(
      int x,
      int y,
      String name,
      SensorSchemas schemas,
      Optional<Long> polygons,
      boolean selected,
      boolean hidden,
      SourceAnchor anchor) {}
}
