package org.selectiverenderer.enricher.area;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The box of what a node shows in the running scene; a value.
 *
 * @param element the node in the document
 * @param own the box in the node's coordinates: those in a Transform, those around another node
 * @param place the matrix from these to the world
 * @param bounds the bounds in the world
 */
public record ObjectBox(
    DocumentElement element, BoundingBox own, Matrix4dc place, BoundingBox bounds) {
  /** Copies the matrix. */
  public ObjectBox {
    place = new Matrix4d(place);
  }
}
