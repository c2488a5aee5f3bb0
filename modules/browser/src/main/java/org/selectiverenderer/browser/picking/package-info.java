/**
 * Evaluation of pick sensors (X3D 4.0, clause 38).
 *
 * <p>{@link org.selectiverenderer.browser.picking.PickSensorEvaluator} checks in every frame
 * whether something has moved since a sensor was last evaluated; only then a {@link
 * org.selectiverenderer.browser.picking.Picker}, made from the sensor's geometry, tests the
 * pickable shapes below the sensor's targets: their bounding boxes first, then, if required, their
 * meshes.
 *
 * <p>In: sensors, the instance tree. Out: the shapes that each sensor picks, passed to the sensor.
 * Uses {@code browser.instance}, {@code browser.collision}, {@code browser.nodes.picking}, {@code
 * browser.nodes.group}, {@code browser.scene} and {@code geometry}. Belongs to the thread that
 * steps the world.
 */
@NullMarked
package org.selectiverenderer.browser.picking;

import org.jspecify.annotations.NullMarked;
