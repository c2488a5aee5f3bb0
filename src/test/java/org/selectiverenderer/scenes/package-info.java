/**
 * Recipes for the objects in {@code inlineNodes/} and tests of everything in {@code scenes/}.
 *
 * <p>In: nothing but numbers written here. Out: the text of an X3D file per object, compared with
 * the committed file. Uses only the JDK, so that it judges our reader and renderer from outside.
 */
@NullMarked
package org.selectiverenderer.scenes;

import org.jspecify.annotations.NullMarked;
