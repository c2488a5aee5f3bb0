package org.selectiverenderer.runtime.nodes.sensor;

import org.joml.Vector3dc;

/**
 * Where the pointing device meets geometry, in the local coordinates of the sensor that is told
 * (X3D 4.0, 20.4.4).
 *
 * @param point on the surface
 * @param normal of the surface, of unit length
 * @param s texture coordinate
 * @param t texture coordinate
 */
public record PointerHit(Vector3dc point, Vector3dc normal, float s, float t) {}
