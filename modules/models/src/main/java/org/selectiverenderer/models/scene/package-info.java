/**
 * Serves all translators of models with what they have in common: names, transforms, skins and
 * animations of a tree of nodes, written as X3D.
 *
 * <p>In: nodes with their parents, joints, keys over time. Out: Transforms, HAnimHumanoids,
 * interpolators and routes in the text of a scene. Knows no format of models. Uses {@code
 * x3d.write}, {@code base} and JOML.
 */
@NullMarked
package org.selectiverenderer.models.scene;

import org.jspecify.annotations.NullMarked;
