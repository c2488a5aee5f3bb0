package org.selectiverenderer.enricher.preview;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.enricher.compare.Compared;
import org.selectiverenderer.runtime.camera.Camera;
import org.selectiverenderer.schema.SensorSchemas;

/**
 * A picture of the scene and what is to be said about it; a value.
 *
 * @param image in pixels of the screen
 * @param camera that it is seen with
 * @param labels of the sensor boxes; none when they are not shown
 * @param polygons of the whole scene in its present versions
 * @param drawn polygons after culling
 * @param areas that the viewer walks in, in the order of entering
 * @param schemas in force, by walking or as if
 * @param walking whether the author walks
 * @param selected the name of what is outlined, if anything is
 * @param otherLayers layers of the scene that are seen, but not in this picture
 * @param revision of the document that is shown
 * @param drawnBy what OpenGL says of itself
 * @param compared the scene with all polygons, if the author compares
 * @param version what is said of an object whose version the author has chosen
 */
record PreviewFrame(
    BufferedImage image,
    Camera camera,
    List<Label> labels,
    long polygons,
    long drawn,
    List<String> areas,
    List<String> schemas,
    boolean walking,
    Optional<String> selected,
    int otherLayers,
    long revision,
    String drawnBy,
    Optional<Compared> compared,
    Optional<String> version) {

  /** The same picture, of which something else is said. */
  PreviewFrame with(List<Label> otherLabels, long newRevision) {
    return new PreviewFrame(
        image,
        camera,
        otherLabels,
        polygons,
        drawn,
        areas,
        schemas,
        walking,
        selected,
        otherLayers,
        newRevision,
        drawnBy,
        compared,
        version);
  }

  /**
   * The label of a sensor's box.
   *
   * @param x of its middle in pixels from the left
   * @param y of its foot in pixels from the top
   * @param name the DEF name
   * @param polygons of what stands in the box, if they were counted
   * @param hidden whether all of the box where a label may stand is behind something
   * @param anchor of the sensor
   */
  record Label(
      int x,
      int y,
      String name,
      SensorSchemas schemas,
      Optional<Long> polygons,
      boolean selected,
      boolean hidden,
      Anchor anchor) {}
}
