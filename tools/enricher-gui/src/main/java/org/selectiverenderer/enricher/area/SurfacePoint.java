package org.selectiverenderer.enricher.area;

import java.util.Optional;
import org.joml.Vector3dc;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A point of a visible surface.
 *
 * @param point in the world
 * @param innermost the innermost node of the document that the surface belongs to
 * @param meant the node that a click on it selects
 */
public record SurfacePoint(
    Vector3dc point, Optional<DocumentElement> innermost, Optional<DocumentElement> meant) {}
