package org.selectiverenderer.browser.nodes.sensor;

import org.joml.Vector3dc;

/**
 * The point at which the pointing device hits geometry, in the local coordinates of the sensor that
 * receives it (X3D 4.0, 20.4.4).
 *
 * @param point the point on the surface
 * @param normal the unit surface normal
 * @param s the first texture coordinate
 * @param t the second texture coordinate
 */
public record PointerHit(Vector3dc point, Vector3dc normal, float s, float t) {}
