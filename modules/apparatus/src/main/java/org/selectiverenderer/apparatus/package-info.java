/**
 * The apparatus of an experiment as data: display modes and profiles of head-mounted displays, the
 * geometry of two eyes behind their lenses, and what the mouse buttons do (thesis 2.4.2, 6.1.1).
 *
 * <p>A profile comes in as a name or a JSON file and goes out as frusta of two eyes, in metres and
 * radians in the frame of the head: x to the right, y up, z backwards. Nothing here draws or knows
 * a scene, so studies can be read without a browser. May use {@code formats} and {@code base}.
 */
@NullMarked
package org.selectiverenderer.apparatus;

import org.jspecify.annotations.NullMarked;
