/**
 * Recipes of the objects in the kitchen: each class builds one object, a {@link
 * org.selectiverenderer.modelling.ParametricModel} in metres that stands on y = 0, is centred on x
 * and z, and shows its front to +z. Uses {@code apartment.materials}, {@code apartment.textures},
 * {@code modelling}, {@code geometry} and {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.apartment.kitchen;

import org.jspecify.annotations.NullMarked;
