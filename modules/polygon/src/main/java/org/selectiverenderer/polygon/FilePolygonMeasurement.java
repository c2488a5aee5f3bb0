package org.selectiverenderer.polygon;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * A file whose geometry has been measured, with the files that its Inlines name. Compared by
 * identity: a file that is inlined several times is one object.
 */
public interface FilePolygonMeasurement {
  /** Returns the parsed file. */
  X3dFile file();

  /**
   * Returns the size of a geometry node of this file; {@link GeometrySize#NOTHING} for one that is
   * not drawn.
   */
  GeometrySize size(ParsedNode geometry);

  /**
   * Returns the file that an Inline names; empty if it is not to be loaded or could not be read.
   */
  Optional<? extends FilePolygonMeasurement> content(ParsedNode inline);

  /**
   * Returns the picture that a texture of this file would show.
   *
   * @param texture an ImageTexture or PixelTexture
   * @param urls the urls of an ImageTexture, which may be others than the node has
   */
  Optional<TexturePicture> picture(ParsedNode texture, List<String> urls);

  /** Returns the problems of the file, in document order. */
  List<Problem> problemList();
}
