/**
 * What is to be seen, without GL: the cameras of which a frame consists and flat marks over them.
 *
 * <p>In: a world and its viewer. Out: {@link org.selectiverenderer.runtime.camera.ViewLayout}s,
 * plain values that anything may make and a renderer draws. Uses {@code runtime}, {@code
 * runtime.instance} and {@code runtime.viewer}, but no renderer.
 */
@NullMarked
package org.selectiverenderer.runtime.camera;

import org.jspecify.annotations.NullMarked;
