/**
 * Tests of the scripts that make a release and of those that use one: {@code packaging/release},
 * {@code packaging/validate}, {@code packaging/action}; and of what the hosted workflows state.
 *
 * <p>Each runs in a small repository of its own, with a Maven and a Java that only take notes.
 */
@NullMarked
package org.selectiverenderer.release;

import org.jspecify.annotations.NullMarked;
